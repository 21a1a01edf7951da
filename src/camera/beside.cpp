#include "camera/beside.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "camera/navigation.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// Where the camera's own screen may stay, relative to the nearest hit.
constexpr double least_screen_depth = 0.12;
constexpr double most_screen_depth = 0.9;
constexpr double usual_screen_depth = 0.4;

// From beside, by so much from behind and from above.
constexpr double from_behind = 46.0 * std::numbers::pi / 180.0;
constexpr double from_above = 20.0 * std::numbers::pi / 180.0;
// Half of the second view's shorter screen side by the screen's distance.
constexpr double view_slope = 0.5;
constexpr double room_around = 0.07;  // at each side of the picture, or of what of it is free
constexpr double least_free = 0.4;    // of the picture's side, or all of it is taken

// A part of a picture, in pixels.
struct Region {
    glm::dvec2 low{0.0};
    glm::dvec2 high{0.0};
};

// Where points lie along the directions of a view.
struct Along {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 ahead;

    glm::dvec3 operator()(const glm::dvec3& v) const { return {dot(v, right), dot(v, up), dot(v, ahead)}; }
};

// The nearest eye that sees all the points in the region of its picture, along these directions and relative to the first point. As
// for fitted() (camera/fit.cpp): planes through the eye and the region's sides, outside of which no point lies.
glm::dvec3 eye_for(std::span<const glm::dvec3> points, const Along& along, PictureSize size, const Region& region) {
    const double m = size.shorter_side();
    const glm::dvec2 room = room_around * (region.high - region.low);
    const glm::dvec2 low = region.low + room;
    const glm::dvec2 high = region.high - room;
    // How far to the right, and up, the sides are of what is one away.
    const std::array<double, 2> lowest = {view_slope * (2.0 * low.x - size.width) / m,
                                          view_slope * (size.height - 2.0 * high.y) / m};
    const std::array<double, 2> highest = {view_slope * (2.0 * high.x - size.width) / m,
                                           view_slope * (size.height - 2.0 * low.y) / m};
    constexpr double nothing = -std::numeric_limits<double>::max();
    std::array<double, 2> above{nothing, nothing};
    std::array<double, 2> below{nothing, nothing};
    for (const glm::dvec3& point : points) {
        const glm::dvec3 place = along(point - points.front());
        for (int i = 0; i < 2; ++i) {
            const auto axis = static_cast<std::size_t>(i);
            above[axis] = std::max(above[axis], place[i] - highest[axis] * place.z);
            below[axis] = std::max(below[axis], lowest[axis] * place.z - place[i]);
        }
    }
    const double z = std::min((above[0] + below[0]) / (lowest[0] - highest[0]), (above[1] + below[1]) / (lowest[1] - highest[1]));
    // Between the two planes of each pair.
    return {0.5 * (above[0] - below[0] + (highest[0] + lowest[0]) * z), 0.5 * (above[1] - below[1] + (highest[1] + lowest[1]) * z),
            z};
}

}  // namespace

double screen_depth_before(std::optional<double> nearest_hit) {
    if (!nearest_hit) return 1.0;
    const bool fits = least_screen_depth * *nearest_hit <= 1.0 && 1.0 <= most_screen_depth * *nearest_hit;
    return fits ? 1.0 : usual_screen_depth * *nearest_hit;
}

std::array<glm::dvec3, 4> screen_corners(const Camera& camera, PictureSize size, double depth) {
    const double width = size.width;
    const double height = size.height;
    return {point_at(camera, size, {0.0, 0.0}, depth), point_at(camera, size, {width, 0.0}, depth),
            point_at(camera, size, {width, height}, depth), point_at(camera, size, {0.0, height}, depth)};
}

std::optional<PlaceOnScreen> place_on_screen(const Camera& camera, PictureSize size, double screen_depth, const Camera& view,
                                             PictureSize view_size, const glm::dvec2& place) {
    const glm::dvec3 origin = point_at(view, view_size, place, 0.0);
    const glm::dvec3 one_deep = point_at(view, view_size, place, 1.0);
    // Depths are linear along the ray.
    const double at_origin = depth_of(camera, origin);
    const double rise = depth_of(camera, one_deep) - at_origin;
    const double depth = (screen_depth - at_origin) / rise;
    if (!(depth > 0.0 && std::isfinite(depth))) return std::nullopt;
    const auto found = place_of(camera, size, origin + depth * (one_deep - origin));
    if (!found || !(found->x >= 0.0 && found->y >= 0.0 && found->x < size.width && found->y < size.height)) return std::nullopt;
    return PlaceOnScreen{*found, depth};
}

std::optional<Camera> camera_beside(const Camera& camera, PictureSize size, std::span<const glm::dvec3> points,
                                    const glm::dvec2& covered) {
    if (points.empty()) return std::nullopt;
    const CameraAxes axes = camera_axes(camera);
    const double across = std::cos(from_behind);
    const double behind = std::sin(from_behind);
    const glm::dvec3 level = behind * axes.ahead - across * axes.right;
    const Along along{across * axes.ahead + behind * axes.right, std::sin(from_above) * level + std::cos(from_above) * axes.up,
                      std::cos(from_above) * level - std::sin(from_above) * axes.up};

    const glm::dvec2 whole(size.width, size.height);
    const auto view_for = [&](const Region& region) {
        const glm::dvec3 place = eye_for(points, along, size, region);
        const glm::dvec3 eye = points.front() + place.x * along.right + place.y * along.up + place.z * along.ahead;
        constexpr double to_screen = 100.0;  // to the screen, as the default camera's
        return camera_with(eye, to_screen * along.ahead, view_slope * to_screen * along.right, view_slope * to_screen * along.up);
    };
    const auto is_clear = [&](const Camera& view) {
        return std::ranges::none_of(points, [&](const glm::dvec3& point) {
            const auto place = place_of(view, size, point);
            return place && place->x < covered.x && place->y < covered.y;
        });
    };
    // Everything may be clear of the corner as it is. Else what is free beside it or below it, whichever shows more.
    Camera best = view_for({glm::dvec2(0.0), whole});
    if (!is_clear(best)) {
        std::optional<double> nearest;
        for (int i = 0; i < 2; ++i) {
            if (covered[i] > (1.0 - least_free) * whole[i]) continue;
            Region free{glm::dvec2(0.0), whole};
            free.low[i] = covered[i];
            const Camera view = view_for(free);
            const double depth = dot(view.eye - points.front(), along.ahead);
            if (nearest && depth <= *nearest) continue;
            nearest = depth;
            best = view;
        }
    }
    return camera_fault(best) ? std::nullopt : std::optional(best);
}

}  // namespace sphereview
