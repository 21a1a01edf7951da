#include "app/probe.hpp"

#include <functional>

#include "app/render_picture.hpp"
#include "base/error.hpp"
#include "image/compare.hpp"

namespace sphereview {

namespace {

constexpr PictureSize test_size{64, 48};
constexpr Background test_background{{10, 20, 30}, false};

// A sphere in front of a part of another, one around the eye's side, one behind the eye.
Scene test_scene() {
    Scene scene;
    scene.spheres = {{{0.0, 0.0, 300.0}, 80.0, {255, 0, 0}},
                     {{40.0, 30.0, 150.0}, 20.0, {0, 200, 100}},
                     {{-120.0, -60.0, 260.0}, 50.0, {1, 2, 3}},
                     {{0.0, 0.0, -100.0}, 50.0, {255, 255, 255}}};
    return scene;
}

Image render_test(OpenBackend& backend) {
    Timings timings;
    PictureFacts facts;
    const Scene scene = test_scene();
    return render_picture(backend, scene, drawn_spheres(scene), {scene.camera, test_size, test_background, true}, timings, facts,
                          [](double) {});
}

Json describe_context(const GlContext& context, const GpuRenderer& gpu) {
    const GlDescription gl = describe_gl();
    return {{"vendor", gl.vendor},
            {"renderer", gl.renderer},
            {"version", gl.version},
            {"glsl", gl.glsl},
            {"software", context.is_software()},
            {"largest_uniform_block_bytes", gl.largest_uniform_block},
            {"spheres_in_uniform_block", gpu.uniform_capacity()},
            {"largest_texture_side", gl.largest_texture_side},
            {"largest_viewport", gl.largest_viewport}};
}

void check_pixels(const Image& picture, const Image& expected, const std::string& what) {
    const Comparison comparison = compare(picture, expected);
    if (!comparison.equal()) throw RenderError(what + " is wrong: " + describe(comparison));
}

Json probe_gl(Backend backend, const std::function<std::unique_ptr<GlContext>()>& open_context) {
    require_address_space_for_gl();
    OpenBackend cpu;
    const Image expected = render_test(cpu);
    OpenBackend open;
    Timings timings;
    open.context = open_context();
    open.backend = backend;
    open.gpu.emplace(timings);
    Json result = {{"works", true}};
    result.update(describe_context(*open.context, *open.gpu));
    check_pixels(render_test(open), expected, "a test picture");
    check_pixels(open.gpu->shade(test_scene(), drawn_spheres(test_scene()), test_background), expected,
                 "the same picture in a window");
    return result;
}

}  // namespace

Json probe_cpu() {
    OpenBackend cpu;
    const Image picture = render_test(cpu);
    // Where the red sphere, the green one and the background are follows from the scene.
    const auto is = [&](int x, int y, Color c) {
        const std::uint8_t* at = picture.at(x, y);
        return at[0] == c.r && at[1] == c.g && at[2] == c.b;
    };
    if (!is(32, 24, {255, 0, 0}) || !is(44, 14, {0, 200, 100}) || !is(0, 0, test_background.color)) {
        throw RenderError("a test picture came out wrong");
    }
    return {{"works", true}, {"renderer", "the CPU renderer"}};
}

Json probe_osmesa() { return probe_gl(Backend::osmesa, open_osmesa); }

Json probe_egl(std::size_t index) {
    const std::vector<EglDevice> devices = list_egl_devices();
    if (index >= devices.size()) throw RenderError("EGL no longer offers it");
    return probe_gl(Backend::egl, [&] { return open_egl(devices[index]); });
}

Json list_egl() {
    Json devices = Json::array();
    for (const EglDevice& device : list_egl_devices()) {
        devices.push_back({{"name", device.name},
                           {"device", device.kind == EglDevice::Kind::device ? Json(device.index) : Json(nullptr)},
                           {"software", device.software}});
    }
    return {{"devices", devices}};
}

}  // namespace sphereview
