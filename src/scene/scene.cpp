#include "scene/scene.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <mutex>

#include "base/number.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr Color black{0, 0, 0};
constexpr Color white{255, 255, 255};

constexpr double most = std::numeric_limits<double>::max();
constexpr std::size_t spheres_at_once = 16384;

// What nothing takes up: less than any sphere.
constexpr SceneBounds nothing{glm::dvec3(most), glm::dvec3(-most), 0.0, 0};

// By hand: min and max of glm do not become SIMD.
void include(SceneBounds& bounds, const glm::dvec3& low, const glm::dvec3& high, double radius) {
    for (int axis = 0; axis < 3; ++axis) {
        bounds.low[axis] = low[axis] < bounds.low[axis] ? low[axis] : bounds.low[axis];
        bounds.high[axis] = high[axis] > bounds.high[axis] ? high[axis] : bounds.high[axis];
    }
    bounds.largest_radius = radius > bounds.largest_radius ? radius : bounds.largest_radius;
}

}  // namespace

bool parse_background(std::string_view text, Background& background) {
    if (text == "black") {
        background = {black, false};
    } else if (text == "white") {
        background = {white, false};
    } else if (text == "transparent") {
        background = {black, true};
    } else if (text.size() == 7 && text[0] == '#') {
        std::array<std::uint8_t, 3> channels{};
        for (std::size_t i = 0; i < 3; ++i) {
            if (!parse_whole(text.substr(1 + 2 * i, 2), channels[i], 16)) return false;
        }
        background = {{channels[0], channels[1], channels[2]}, false};
    } else {
        return false;
    }
    return true;
}

std::string view_name_fault(std::string_view name) {
    if (trimmed(name).empty()) return "no name";
    if (std::ranges::find(view_sides, name) != view_sides.end()) return "the name of a side";
    const std::size_t comma = name.find(',');
    double angle = 0.0;
    const auto is_angle = [&](std::string_view part) { return parse_double(part, angle) == NumberFault::none; };
    if (comma != std::string_view::npos && is_angle(name.substr(0, comma)) && is_angle(name.substr(comma + 1)))
        return "an azimuth and an elevation";
    return "";
}

std::string to_string(const Background& background) {
    if (background.transparent) return "transparent";
    if (background.color == black) return "black";
    if (background.color == white) return "white";
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", background.color.r, background.color.g, background.color.b);
    return text.data();
}

double SceneBounds::extent() const {
    const glm::dvec3 sides = high - low;
    return std::min(most, std::max({sides.x, sides.y, sides.z, 2.0 * largest_radius}));
}

SceneBounds bounds_of(const Scene& scene) {
    SceneBounds all = nothing;
    std::mutex mutex;
    parallel_pieces(scene.spheres.size(), spheres_at_once, [&](std::size_t begin, std::size_t end) {
        SceneBounds part = nothing;
        for (std::size_t i = begin; i < end; ++i) {
            const Sphere& sphere = scene.spheres[i];
            if (!sphere.hidden) include(part, sphere.center - sphere.radius, sphere.center + sphere.radius, sphere.radius);
            part.hidden += sphere.hidden ? 1 : 0;
        }
        const std::lock_guard lock(mutex);
        include(all, part.low, part.high, part.largest_radius);
        all.hidden += part.hidden;
    });
    if (all.largest_radius == 0.0) return {.hidden = all.hidden};
    for (int axis = 0; axis < 3; ++axis) {
        all.low[axis] = std::max(all.low[axis], -most);
        all.high[axis] = std::min(all.high[axis], most);
    }
    return all;
}

}  // namespace sphereview
