#include "camera/navigation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr glm::dvec3 world_up{0.0, 1.0, 0.0};
// How near the poles a tilt comes: nobody sees the difference, and rounding never turns up into down.
constexpr double farthest_tilt = std::numbers::pi / 2.0 - 1e-4;
// A camera that lies on its side, `right` within this of the world's y, has no poles.
constexpr double smallest_height = 1e-6;
// How many times as far from the origin as its own size a screen may be: its vectors then keep some 9 digits.
constexpr double farthest_screen = 0x1p24;
constexpr double nearest_zoom = 1e-9;

// What pixels are in multiples of `right` and `up`.
glm::dvec2 on_screen(PictureSize size, const glm::dvec2& pixels) {
    const double m = size.shorter_side();
    return {2.0 * pixels.x / m, -2.0 * pixels.y / m};
}

glm::dvec2 middle_of(PictureSize size) { return {0.5 * size.width, 0.5 * size.height}; }

// The camera with these vectors; the one before where they are none.
Camera settled(const Camera& before, const glm::dvec3& eye, const glm::dvec3& axis, const glm::dvec3& right, const glm::dvec3& up) {
    const Camera camera = camera_with(eye, axis, right, up, before.projection);
    return camera_fault(camera) ? before : camera;
}

Camera moved_to(const Camera& camera, const glm::dvec3& eye) {
    return settled(camera, eye, camera.center - camera.eye, camera.right, camera.up);
}

// rotated(v): a direction as it is after the turn.
template <typename Rotated>
Camera turned_about(const Camera& camera, const glm::dvec3& pivot, const Rotated& rotated) {
    return settled(camera, pivot + rotated(camera.eye - pivot), rotated(camera.center - camera.eye), rotated(camera.right),
                   rotated(camera.up));
}

// Turned about an axis of length 1 through 0, by the right-hand rule (Rodrigues).
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    const glm::dvec3 along = glm::dot(axis, v) * axis;
    return along + std::cos(angle) * (v - along) + std::sin(angle) * glm::cross(axis, v);
}

// How the camera stands to the world's up. In the plane that a tilt turns in, `elevation` is where `ahead` points: 0 to the
// horizon, pi/2 to the pole above; beyond that the camera is upside down.
struct Attitude {
    bool has_poles = true;
    bool upside_down = false;
    double elevation = 0.0;
};

Attitude attitude_of(const CameraAxes& directions) {
    const double ahead = glm::dot(world_up, directions.ahead);
    const double up = glm::dot(world_up, directions.up);
    if (std::hypot(ahead, up) < smallest_height) return {false, false, 0.0};
    const double elevation = std::atan2(ahead, up);
    // A camera that begins at a pole counts as upright, however it was rounded.
    return {true, std::fabs(elevation) > std::numbers::pi / 2.0 + 1e-9, elevation};
}

// How far the camera may be tilted down, at most `tilt`. A camera beyond the end stays there and may only turn back.
double allowed_tilt(const Attitude& attitude, double tilt) {
    if (!attitude.has_poles) return tilt;
    // Upside down, what counts is the way from the horizon behind.
    const double begin =
        attitude.upside_down ? attitude.elevation - std::copysign(std::numbers::pi, attitude.elevation) : attitude.elevation;
    const double end = std::clamp(begin - tilt, std::min(begin, -farthest_tilt), std::max(begin, farthest_tilt));
    return begin - end;
}

}  // namespace

Camera camera_with(const glm::dvec3& eye, glm::dvec3 axis, glm::dvec3 right, glm::dvec3 up, Projection projection) {
    // The same picture, with a larger screen: added to the eye's numbers, a small one would be rounded away. A power of two: exact.
    // An orthographic screen's size is the picture's, and only its distance is free.
    const bool perspective = projection == Projection::perspective;
    const double smallest = perspective ? std::min(largest_of(axis), largest_of(right)) : largest_of(axis);
    const double ratio = largest_of(eye) / smallest / farthest_screen;
    if (ratio > 1.0 && std::isfinite(ratio)) {
        const double scale = std::ldexp(1.0, std::ilogb(ratio) + 1);
        axis *= scale;
        if (perspective) {
            right *= scale;
            up *= scale;
        }
    }
    return {eye, eye + axis, right, up, projection};
}

Camera with_projection(const Camera& camera, Projection projection, double depth) {
    if (projection == camera.projection) return camera;
    const glm::dvec3 axis = camera.center - camera.eye;
    const bool perspective = projection == Projection::perspective;
    const glm::dvec3 eye = camera.eye + (depth - 1.0) * axis;
    const Camera turned = perspective ? camera_with(eye, axis, camera.right, camera.up)
                                      : camera_with(camera.eye, depth * axis, depth * camera.right, depth * camera.up, projection);
    return camera_fault(turned) ? camera : turned;
}

double depth_of(const Camera& camera, const glm::dvec3& point) {
    const CameraAxes directions = camera_axes(camera);
    return glm::dot(point - camera.eye, directions.ahead) / glm::dot(camera.center - camera.eye, directions.ahead);
}

glm::dvec2 across_screen(const Camera& camera, const glm::dvec3& v) {
    // Brought near 1 by a power of two, which rounds nothing: so no square leaves the range of doubles.
    const int exponent = -exponent_of(largest_of(camera.right));
    const glm::dvec3 right = times_two_to(camera.right, exponent);
    const glm::dvec3 up = times_two_to(camera.up, exponent);
    const glm::dvec3 part = times_two_to(v, exponent);
    return {dot(part, right) / dot(right, right), dot(part, up) / dot(up, up)};
}

glm::dvec3 point_at(const Camera& camera, PictureSize size, const glm::dvec2& place, double depth) {
    const glm::dvec2 screen = on_screen(size, place - middle_of(size));
    if (camera.orthographic()) {
        return camera.eye + depth * (camera.center - camera.eye) + screen.x * camera.right + screen.y * camera.up;
    }
    return camera.eye + depth * ((camera.center - camera.eye) + screen.x * camera.right + screen.y * camera.up);
}

std::optional<glm::dvec2> place_of(const Camera& camera, PictureSize size, const glm::dvec3& point) {
    const double depth = depth_of(camera, point);
    if (!(depth > 0.0)) return std::nullopt;
    const glm::dvec3 axis = camera.center - camera.eye;
    const glm::dvec3 way = point - camera.eye;
    const glm::dvec3 there = camera.orthographic() ? way - depth * axis : way / depth - axis;
    const glm::dvec2 across = across_screen(camera, there);
    const glm::dvec2 place = middle_of(size) + 0.5 * size.shorter_side() * glm::dvec2(across.x, -across.y);
    return std::isfinite(place.x) && std::isfinite(place.y) ? std::optional(place) : std::nullopt;
}

Camera orbited(const Camera& camera, const glm::dvec3& pivot, double turn, double tilt) {
    const CameraAxes directions = camera_axes(camera);
    const Attitude attitude = attitude_of(directions);
    const double tilt_angle = allowed_tilt(attitude, tilt) * (directions.mirrored ? -1.0 : 1.0);
    const double turn_angle = turn * (directions.mirrored != attitude.upside_down ? -1.0 : 1.0);
    const auto rotated = [&](const glm::dvec3& v) { return turned(turned(v, directions.right, tilt_angle), world_up, turn_angle); };
    return turned_about(camera, pivot, rotated);
}

Camera tumbled(const Camera& camera, const glm::dvec3& pivot, double turn, double tilt) {
    const CameraAxes directions = camera_axes(camera);
    const double hand = directions.mirrored ? -1.0 : 1.0;
    const auto rotated = [&](const glm::dvec3& v) {
        return turned(turned(v, directions.right, hand * tilt), directions.up, hand * turn);
    };
    return turned_about(camera, pivot, rotated);
}

Camera turned_to(const Camera& camera, const glm::dvec3& pivot, const CameraAxes& axes) {
    const CameraAxes before = camera_axes(camera);
    const auto rotated = [&](const glm::dvec3& v) {
        return glm::dot(v, before.right) * axes.right + glm::dot(v, before.up) * axes.up + glm::dot(v, before.ahead) * axes.ahead;
    };
    return turned_about(camera, pivot, rotated);
}

Camera panned(const Camera& camera, PictureSize size, const glm::dvec2& pixels, double depth) {
    const glm::dvec2 screen = on_screen(size, pixels);
    if (camera.orthographic()) return moved_to(camera, camera.eye - (screen.x * camera.right + screen.y * camera.up));
    return moved_to(camera, camera.eye - depth * (screen.x * camera.right + screen.y * camera.up));
}

Camera zoomed(const Camera& camera, const glm::dvec3& point, double factor) {
    if (camera.orthographic()) {
        const glm::dvec3 axis = camera.center - camera.eye;
        const glm::dvec3 aside = (point - camera.eye) - depth_of(camera, point) * axis;
        const bool too_small = factor < 1.0 && factor * largest_of(camera.right) < nearest_zoom * largest_of(point);
        if (!(factor > 0.0) || too_small) return camera;
        // The axis, too: so the angle of view stays for a perspective picture.
        return settled(camera, camera.eye + (1.0 - factor) * aside, factor * axis, factor * camera.right, factor * camera.up);
    }
    const glm::dvec3 eye = point + factor * (camera.eye - point);
    const bool too_near = factor < 1.0 && largest_of(eye - point) < nearest_zoom * largest_of(point);
    return factor > 0.0 && !too_near ? moved_to(camera, eye) : camera;
}

Camera centered_on(const Camera& camera, const glm::dvec3& point) {
    const double depth = std::fabs(depth_of(camera, point));
    return moved_to(camera, point - (depth > 0.0 ? depth : 1.0) * (camera.center - camera.eye));
}

}  // namespace sphereview
