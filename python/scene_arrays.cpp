#include "python/scene_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/lines.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

namespace py = pybind11;

namespace {

constexpr std::size_t spheres_at_once = 16384;

// One array's element, for messages. `column`: in a row; none for an array of one dimension.
struct Element {
    const char* array;
    std::size_t row;
    std::optional<std::size_t> column;
    const char* what;  // "the centre's x"
    std::size_t count;

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        std::string place = std::string(array) + "[" + std::to_string(row);
        if (column) place += ", " + std::to_string(*column);
        throw InputError(place + "]: " +
                         found_expected(found, std::string(what) + " of sphere " + std::to_string(row + 1) + " of " +
                                                   std::to_string(count) + expected));
    }
};

double finite(double value, const Element& element) {
    if (!std::isfinite(value)) element.fail(shortest(value), ", a finite number");
    return value;
}

template <typename Channel>
std::uint8_t channel(Channel value, const Element& element) {
    if constexpr (std::is_floating_point_v<Channel>) {
        if (!(finite(value, element) >= 0.0 && value <= 1.0)) element.fail(shortest(value), " from 0 to 1");
        return static_cast<std::uint8_t>(std::lround(color_max * value));  // as formats/xyz.cpp
    } else {
        if (value < 0 || value > color_max) element.fail(std::to_string(value), " from 0 to 255");
        return static_cast<std::uint8_t>(value);
    }
}

template <typename Channel>
void fill(std::vector<Sphere>& spheres, const double* centers, const double* radii, const Channel* colors, const bool* hidden) {
    const std::size_t count = spheres.size();
    parallel_in_order((count + spheres_at_once - 1) / spheres_at_once, [&](std::size_t piece) {
        const std::size_t end = std::min(count, (piece + 1) * spheres_at_once);
        for (std::size_t i = piece * spheres_at_once; i < end; ++i) {
            const auto center = [&](std::size_t axis, const char* what) {
                return finite(centers[3 * i + axis], {"centers", i, axis, what, count});
            };
            const auto color = [&](std::size_t column, const char* what) {
                return channel(colors[3 * i + column], {"colors", i, column, what, count});
            };
            Sphere sphere;
            sphere.center = {center(0, "the centre's x"), center(1, "the centre's y"), center(2, "the centre's z")};
            const Element radius{"radii", i, std::nullopt, "the radius", count};
            sphere.radius = finite(radii[i], radius);
            if (!(sphere.radius > 0.0)) radius.fail(shortest(sphere.radius), " above 0");
            sphere.color = {color(0, "the red"), color(1, "the green"), color(2, "the blue")};
            sphere.hidden = hidden != nullptr && hidden[i];
            spheres[i] = sphere;
        }
    });
}

void require_shapes(const SphereArrays& arrays) {
    const py::ssize_t count = arrays.radii.size();
    const auto is_table = [&](const py::array& array) {
        return array.ndim() == 2 && array.shape(0) == count && array.shape(1) == 3;
    };
    if (arrays.radii.ndim() != 1 || !is_table(arrays.centers) || !is_table(arrays.colors) ||
        (arrays.colors.flags() & py::array::c_style) == 0 || (arrays.hidden && arrays.hidden->size() != count)) {
        throw InputError("the arrays are not of the shapes (N, 3), (N,), (N, 3) and (N,)");
    }
    if (count > most_spheres) {
        throw InputError("found " + std::to_string(count) + " spheres, expected at most " + std::to_string(most_spheres));
    }
}

}  // namespace

Camera camera_from(const CameraNumbers& n) {
    const Camera camera{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, {n[9], n[10], n[11]}};
    if (const auto fault = camera_fault(camera)) {
        throw InputError("found a camera that cannot be used: " + fault->what +
                         "; expected perpendicular, equally long 'right' and 'up' (within 1e-6) and an eye off the screen's plane");
    }
    return camera;
}

CameraNumbers numbers_of(const Camera& camera) {
    CameraNumbers numbers{};
    auto* next = numbers.data();
    for (const glm::dvec3& v : {camera.eye, camera.center, camera.right, camera.up}) {
        for (int axis = 0; axis < 3; ++axis) *next++ = v[axis];
    }
    return numbers;
}

Scene scene_from(const SphereArrays& arrays) {
    require_shapes(arrays);
    const double* centers = arrays.centers.data();
    const double* radii = arrays.radii.data();
    const void* colors = arrays.colors.data();
    const bool* hidden = arrays.hidden ? arrays.hidden->data() : nullptr;
    const auto count = static_cast<std::size_t>(arrays.radii.size());
    const bool bytes = py::isinstance<py::array_t<std::uint8_t>>(arrays.colors);
    const bool whole = py::isinstance<py::array_t<std::int64_t>>(arrays.colors);
    if (!bytes && !whole && !py::isinstance<py::array_t<double>>(arrays.colors)) {
        throw InputError("colors: expected elements of uint8, int64 or float64");
    }
    const py::gil_scoped_release others_may_run;
    require_memory(count * (sizeof(Sphere) + bytes_to_draw_a_sphere), "sphereview: " + in_groups(count) + " spheres need");
    Scene scene;
    scene.spheres.resize(count);
    if (bytes) {
        fill(scene.spheres, centers, radii, static_cast<const std::uint8_t*>(colors), hidden);
    } else if (whole) {
        fill(scene.spheres, centers, radii, static_cast<const std::int64_t*>(colors), hidden);
    } else {
        fill(scene.spheres, centers, radii, static_cast<const double*>(colors), hidden);
    }
    return scene;
}

SphereArrays arrays_of(const Scene& scene) {
    const std::vector<Sphere>& spheres = scene.spheres;
    const auto count = static_cast<py::ssize_t>(spheres.size());
    const auto table = std::array<py::ssize_t, 2>{count, 3};
    py::array_t<double, py::array::c_style> centers(table);
    py::array_t<double, py::array::c_style> radii(count);
    py::array_t<std::uint8_t, py::array::c_style> colors(table);
    py::array_t<bool, py::array::c_style> hidden(count);
    double* center = centers.mutable_data();
    double* radius = radii.mutable_data();
    std::uint8_t* color = colors.mutable_data();
    bool* is_hidden = hidden.mutable_data();
    bool any_hidden = false;
    {
        const py::gil_scoped_release others_may_run;
        parallel_pieces(spheres.size(), spheres_at_once, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Sphere& sphere = spheres[i];
                for (int axis = 0; axis < 3; ++axis) center[3 * i + static_cast<std::size_t>(axis)] = sphere.center[axis];
                radius[i] = sphere.radius;
                color[3 * i] = sphere.color.r;
                color[3 * i + 1] = sphere.color.g;
                color[3 * i + 2] = sphere.color.b;
                is_hidden[i] = sphere.hidden;
            }
        });
        any_hidden = std::ranges::any_of(spheres, &Sphere::hidden);
    }
    SphereArrays arrays{centers, radii, colors, std::nullopt};
    if (any_hidden) arrays.hidden = hidden;
    return arrays;
}

}  // namespace sphereview
