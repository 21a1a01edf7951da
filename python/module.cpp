// The module sphereview._native: what python/sphereview/ needs of the program. Its signatures are in _native.pyi.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

#include "app/load_scene.hpp"
#include "app/options.hpp"
#include "app/render_picture.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/text.hpp"
#include "image/compare.hpp"
#include "image/png.hpp"
#include "light/light_set.hpp"
#include "python/beside_python.hpp"
#include "python/errors.hpp"
#include "python/image_arrays.hpp"
#include "python/light_arguments.hpp"
#include "python/look_arguments.hpp"
#include "python/property_arrays.hpp"
#include "python/renderers.hpp"
#include "python/scene_arrays.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

namespace py = pybind11;

namespace {

PictureSize size_from(const std::pair<std::int64_t, std::int64_t>& sides, int samples) {
    const auto [width, height] = sides;
    const std::string found = std::to_string(width) + "x" + std::to_string(height);
    if (width < 1 || height < 1 || width > most_pixels || height > most_pixels / width) {
        wrong_argument(
            "size", found,
            "(width, height), such as (1000, 1000): sides of at least 1 pixel, at most " + std::to_string(most_pixels) + " pixels");
    }
    const int longest = longest_side(samples);
    if (std::max(width, height) > longest) {
        wrong_argument("size", found,
                       "sides of at most " + std::to_string(longest) + " pixels with samples=" + std::to_string(samples));
    }
    return {static_cast<int>(width), static_cast<int>(height)};
}

Shading shading_from(const std::string& name) {
    const auto shading = shading_named(name);
    if (!shading) wrong_argument("shade", name, shading_syntax());
    return *shading;
}

Background background_from(const std::string& text) {
    Background background;
    if (!parse_background(text, background)) wrong_argument("background", text, std::string(background_syntax));
    return background;
}

// `name`: of the argument or variable that says so.
Backend backend_from(const char* name, const std::string& text) {
    const auto found = std::ranges::find(backend_names, text);
    if (found == backend_names.end()) {
        wrong_argument(name, text, listed(std::vector<std::string>(backend_names.begin(), backend_names.end()), "or"));
    }
    return static_cast<Backend>(found - backend_names.begin());
}

Backend backend_from(const std::string& text) {
    const Backend backend = backend_from("backend", text);
    const char* variable = std::getenv("SPHEREVIEW_BACKEND");
    if (backend != Backend::automatic || variable == nullptr || *variable == '\0') return backend;
    return backend_from("SPHEREVIEW_BACKEND", variable);
}

std::optional<ViewAxes> view_from(const std::optional<std::string>& text) {
    if (!text) return std::nullopt;
    const auto view = parse_view(*text);
    if (!view) wrong_argument("view", *text, std::string(view_syntax));
    return view;
}

py::array render(const SphereArrays& arrays, const std::optional<CameraNumbers>& camera, bool fit,
                 const std::pair<std::int64_t, std::int64_t>& size, int samples, const std::string& shade,
                 const std::string& backend, const std::string& background, const LightNumbers& light,
                 const LightArguments& light_instead) {
    if (std::ranges::find(sample_counts, samples) == sample_counts.end()) {
        wrong_argument("samples", std::to_string(samples), sample_counts_text);
    }
    PictureOptions options;
    options.size = size_from(size, samples);
    options.samples = samples;
    options.background = background_from(background);
    options.shading = shading_from(shade);
    if (camera) options.camera = camera_from(*camera);
    const Backend asked_for = backend_from(backend);
    Scene given = scene_from(arrays);
    given.camera = options.camera;
    given.light = light_from(light);
    auto draw = [scene = std::move(given), options, fit, light_instead, asked_for](WorkControl& control) mutable {
        if (fit) scene.camera = fitted(scene, axes_of(scene.camera), scene.camera.projection).value_or(scene.camera);
        options.camera = scene.camera;
        options.light = light_with(scene, light_instead, options.shading);
        const DrawnSpheres drawn = drawn_spheres(scene, options.camera);
        Timings timings;
        PictureFacts facts;
        Image image;
        const auto draw_with = [&](OpenBackend& opened) {
            return render_picture(opened, scene, drawn, options, timings, facts, [&](double) { control.check(); });
        };
        const auto bytes = static_cast<std::uint64_t>(options.size.width) * static_cast<std::uint64_t>(options.size.height) * 4;
        with_renderer(asked_for, bytes, control,
                      [&](OpenBackend& opened) { image = render_by_what_holds_it(opened, asked_for, draw_with); });
        return image;
    };
    return array_of(beside_python(std::move(draw)));
}

std::string explain_pixel_of(const SphereArrays& arrays, const CameraNumbers& camera,
                             const std::map<std::uint32_t, std::string>& names, const std::string& background,
                             const std::pair<int, int>& pixel, const std::pair<std::int64_t, std::int64_t>& size,
                             const std::string& shade, const LightNumbers& light, const LightArguments& light_instead,
                             const std::string& name) {
    ExplainOptions options;
    options.size = size_from(size, 1);
    options.pixel = {pixel.first, pixel.second};
    options.shading = shading_from(shade);
    if (pixel.first < 0 || pixel.second < 0 || pixel.first >= options.size.width || pixel.second >= options.size.height) {
        wrong_argument(
            "pixel", std::to_string(pixel.first) + "," + std::to_string(pixel.second),
            "a pixel from 0,0 to " + std::to_string(options.size.width - 1) + "," + std::to_string(options.size.height - 1));
    }
    Scene scene = scene_from(arrays);
    scene.camera = camera_from(camera);
    scene.names = names;
    scene.background = background_from(background);
    scene.light = light_from(light);
    scene.light = light_with(scene, light_instead, options.shading);
    return beside_python([scene = std::move(scene), name, options](WorkControl&) { return explain(scene, name, options); });
}

CameraNumbers fit(const SphereArrays& arrays, const CameraNumbers& camera, bool right_handed,
                  const std::optional<std::string>& view) {
    const Camera given = camera_from(camera);
    const ViewAxes present = right_handed ? data_axes : axes_of(given);
    const ViewAxes axes = with_hand_of(present, view_from(view).value_or(present));
    const Scene scene = scene_from(arrays);
    const py::gil_scoped_release others_may_run;
    return numbers_of(fitted(scene, axes, given.projection).value_or(given));
}

// As the command line says them.
std::vector<std::string> words_of_warnings(const LoadedScene& loaded) {
    std::vector<std::string> words;
    for (const std::string& warning : loaded.warnings) words.push_back(on_one_line(warning));
    return words;
}

// `properties`: names of those to keep; none: all.
py::dict read(const std::string& path, std::int64_t frame, std::optional<double> radius, bool virtual_sites,
              const std::optional<std::string>& columns, std::optional<bool> wanted, const std::optional<std::string>& view,
              const std::optional<std::vector<std::string>>& properties, const LookArguments& look_arguments) {
    if (frame < 0) wrong_argument("frame", std::to_string(frame), "the number of a frame, from 0");
    if (radius && !(*radius > 0.0 && std::isfinite(*radius))) wrong_argument("radius", shortest(*radius), "a number above 0");
    DataOptions data{.frame = frame, .radius = radius, .virtual_sites = virtual_sites};
    if (columns) {
        const auto choices = parse_column_choices(*columns);
        if (!choices) wrong_argument("columns", *columns, column_choices_syntax);
        data.columns = *choices;
    }
    data.all_properties = !properties;
    if (properties) data.properties = *properties;
    const LookOptions look = look_from(look_arguments);
    FitOptions fit;
    fit.wanted = wanted;
    if (view) {
        const auto asked = fit_from(*view);
        if (!asked) wrong_argument("view", *view, std::string(any_view_syntax));
        fit = *asked;
    }
    LoadedScene loaded = beside_python([path, data, look, fit](WorkControl& control) {
        LoadOptions options;
        options.more_per_sphere = sizeof(Sphere);  // the arrays
        options.data = data;
        options.look = look;
        options.fit = fit;
        options.control = &control;
        LoadedScene read = load_scene(path, options);
        require_properties(read, data);
        return read;
    });
    const Scene& scene = loaded.scene;
    const SphereArrays arrays = arrays_of(scene);
    py::dict read;
    read["centers"] = arrays.centers;
    read["radii"] = arrays.radii;
    read["colors"] = arrays.colors;
    read["hidden"] = arrays.hidden;
    read["names"] = scene.names;
    read["properties"] = values_of(std::move(loaded.scene.properties), data);
    read["background"] = to_string(scene.background);
    read["camera"] = numbers_of(scene.camera);
    read["light"] = numbers_of(scene.light);
    read["frames"] = loaded.frames;
    read["format"] = loaded.format.name;
    read["source"] = py::bytes(loaded.name);
    read["warnings"] = words_of_warnings(loaded);
    return read;
}

// Whether the pictures are equal, what differs in words, the first different pixel of pictures of the same size, and a picture of
// the difference.
py::tuple compare_with_png(const Image& actual, const std::string& path) {
    auto [comparison, difference] = [&] {
        const py::gil_scoped_release others_may_run;
        PngReader golden = open_png(path);
        Image picture;
        const Comparison found = compare(actual, golden, &picture);
        return std::pair(found, std::move(picture));
    }();
    py::object first = py::none();
    if (comparison.same_size() && !comparison.equal()) first = py::make_tuple(comparison.first_x, comparison.first_y);
    return py::make_tuple(comparison.equal(), comparison.equal() ? "" : describe(comparison), first,
                          array_of(std::move(difference)));
}

py::array read_png(const std::string& path) {
    return array_of(beside_python([path](WorkControl&) {
        const InputFile file(path, Content::binary);
        return decode_png(file.bytes(), file.name());
    }));
}

void write_png(const std::string& path, const Image& image) {
    const py::gil_scoped_release others_may_run;
    check_output(path);
    write_output(path, encode_png(image));
}

void define(py::module_& module) {
    // With NumPy 2, a pybind11 before 2.12 reads the sizes of elements where they no longer are.
    if (py::dtype::of<double>().itemsize() != sizeof(double)) {
        throw py::import_error(
            "sphereview was built with a pybind11 that does not know this NumPy; 2.12 or later knows both 1 and 2");
    }
    translate_errors();
    using Doubles = py::array_t<double, py::array::c_style>;
    using Bytes = py::array_t<std::uint8_t, py::array::c_style>;
    using Hidden = std::optional<py::array_t<bool, py::array::c_style>>;
    py::class_<SphereArrays>(module, "SphereArrays")
        .def(py::init([](Doubles centers, Doubles radii, py::array colors, Hidden hidden) {
                 return SphereArrays{std::move(centers), std::move(radii), std::move(colors), std::move(hidden)};
             }),
             py::arg("centers").noconvert(), py::arg("radii").noconvert(), py::arg("colors"), py::arg("hidden").noconvert());
    module.def("render", &render, py::arg("arrays"), py::arg("camera"), py::arg("fit"), py::arg("size"), py::arg("samples"),
               py::arg("shade"), py::arg("backend"), py::arg("background"), py::arg("light"), py::arg("light_instead"));
    module.def("explain", &explain_pixel_of, py::arg("arrays"), py::arg("camera"), py::arg("names"), py::arg("background"),
               py::arg("pixel"), py::arg("size"), py::arg("shade"), py::arg("light"), py::arg("light_instead"), py::arg("name"));
    module.def("fit", &fit, py::arg("arrays"), py::arg("camera"), py::arg("right_handed"), py::arg("view"));
    module.def("read", &read, py::arg("path"), py::arg("frame"), py::arg("radius"), py::arg("virtual"), py::arg("columns"),
               py::arg("fit"), py::arg("view"), py::arg("properties"), py::arg("look"));
    module.def(
        "sky_lights",
        [](const LightNumbers& light, std::size_t spheres, int samples) { return sky_lights(light_from(light), spheres, samples); },
        py::arg("light"), py::arg("spheres"), py::arg("samples"));
    module.def(
        "check_camera", [](const CameraNumbers& numbers) { camera_from(numbers); }, py::arg("camera"));
    module.def(
        "light", [](const LightArguments& arguments) { return numbers_of(light_with({}, arguments, Shading::studio)); },
        py::arg("arguments"));
    module.def(
        "compare_with_png", [](const Bytes& actual, const std::string& path) { return compare_with_png(image_from(actual), path); },
        py::arg("actual"), py::arg("path"));
    module.def("read_png", &read_png, py::arg("path"));
    module.def(
        "write_png", [](const std::string& path, const Bytes& image) { write_png(path, image_from(image)); }, py::arg("path"),
        py::arg("image"));
    module.def("close_renderers", &close_renderers, py::call_guard<py::gil_scoped_release>());
    module.def("forget_renderers", &forget_renderers);
}

}  // namespace

}  // namespace sphereview

PYBIND11_MODULE(_native, module) { sphereview::define(module); }
