#include "python/scene_arrays.hpp"

#include <algorithm>
#include <array>
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

// What a caller gave, without Python.
template <typename Channel>
struct Values {
    const double* centers;
    const double* radii;
    const Channel* colors;
    const bool* hidden;  // may be null
    std::size_t count;
};

// Throws InputError "ARRAY[ROW, COLUMN]: found ..., expected WHAT of sphere ROW + 1 of COUNT..."; no column for an array of one
// dimension.
[[noreturn]] void fail(const std::string& array, std::size_t row, std::optional<std::size_t> column, std::size_t count,
                       const std::string& found, const std::string& what, const std::string& expected) {
    const std::string place = array + "[" + std::to_string(row) + (column ? ", " + std::to_string(*column) : "") + "]: ";
    const std::string sphere = " of sphere " + std::to_string(row + 1) + " of " + std::to_string(count);
    throw InputError(place + found_expected(found, what + sphere + expected));
}

template <typename Channel>
bool is_channel(Channel value) {
    return value >= 0 && value <= (std::is_floating_point_v<Channel> ? 1 : color_max);
}

template <typename Channel>
std::uint8_t to_byte(Channel value) {
    if constexpr (std::is_floating_point_v<Channel>)
        return static_cast<std::uint8_t>(std::lround(color_max * value));  // as formats/xyz.cpp
    return static_cast<std::uint8_t>(value);
}

// Throws for the first value of sphere i that is wrong, of which there is one.
template <typename Channel>
[[noreturn]] void fail_for(const Values<Channel>& values, std::size_t i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double value = values.centers[3 * i + axis];
        if (std::isfinite(value)) continue;
        fail("centers", i, axis, values.count, shortest(value), std::string("the centre's ") + "xyz"[axis], ", a finite number");
    }
    const double radius = values.radii[i];
    if (!(radius > 0.0 && std::isfinite(radius))) {
        fail("radii", i, std::nullopt, values.count, shortest(radius), "the radius",
             std::isfinite(radius) ? " above 0" : ", a finite number");
    }
    std::size_t channel = 0;
    while (channel < 2 && is_channel(values.colors[3 * i + channel])) ++channel;
    constexpr std::array names = {"the red", "the green", "the blue"};
    const Channel value = values.colors[3 * i + channel];
    if constexpr (std::is_floating_point_v<Channel>) {
        fail("colors", i, channel, values.count, shortest(value), names[channel], " from 0 to 1");
    } else {
        fail("colors", i, channel, values.count, std::to_string(value), names[channel], " from 0 to 255");
    }
}

template <typename Channel>
void fill(std::vector<Sphere>& spheres, const Values<Channel>& values) {
    parallel_in_order((values.count + spheres_at_once - 1) / spheres_at_once, [&](std::size_t piece) {
        const std::size_t end = std::min(values.count, (piece + 1) * spheres_at_once);
        for (std::size_t i = piece * spheres_at_once; i < end; ++i) {
            const double* center = values.centers + 3 * i;
            const Channel* color = values.colors + 3 * i;
            const double radius = values.radii[i];
            const bool good = std::isfinite(center[0]) && std::isfinite(center[1]) && std::isfinite(center[2]) && radius > 0.0 &&
                              std::isfinite(radius) && is_channel(color[0]) && is_channel(color[1]) && is_channel(color[2]);
            if (!good) fail_for(values, i);
            spheres[i] = {{center[0], center[1], center[2]},
                          radius,
                          {to_byte(color[0]), to_byte(color[1]), to_byte(color[2])},
                          values.hidden != nullptr && values.hidden[i]};
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
    const Projection projection = n[12] == 0.0 ? Projection::perspective : Projection::orthographic;
    const Camera camera{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, {n[9], n[10], n[11]}, projection};
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
    *next = camera.orthographic() ? 1.0 : 0.0;
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
    scene.spheres.reserve(count);
    prefer_large_pages(scene.spheres.data(), count * sizeof(Sphere));
    scene.spheres.resize(count);
    if (bytes) {
        fill<std::uint8_t>(scene.spheres, {centers, radii, static_cast<const std::uint8_t*>(colors), hidden, count});
    } else if (whole) {
        fill<std::int64_t>(scene.spheres, {centers, radii, static_cast<const std::int64_t*>(colors), hidden, count});
    } else {
        fill<double>(scene.spheres, {centers, radii, static_cast<const double*>(colors), hidden, count});
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
