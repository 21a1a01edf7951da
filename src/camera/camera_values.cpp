#include "camera/camera_values.hpp"

#include <cmath>
#include <numbers>

#include "camera/fit.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;
// Within this the eye's line to the centre and the screen's axis count as one.
constexpr double straight = 1e-9;
// So near to y, relative to its length, a direction has no level of its own.
constexpr double steepest = 1e-6;

// How far the screen is before the eye.
double distance_of(const Camera& camera) { return std::fabs(dot(camera.center - camera.eye, camera_axes(camera).ahead)); }

// The directions of a camera without roll, each of length 1.
struct Level {
    glm::dvec3 right;
    glm::dvec3 up;
};

Level level_of(const glm::dvec3& ahead, bool mirrored) {
    const glm::dvec3 y{0.0, 1.0, 0.0};
    glm::dvec3 up = y - ahead.y * ahead;
    if (length_of(up) < steepest) up = {0.0, 0.0, (ahead.y < 0.0) == mirrored ? -1.0 : 1.0};
    up = unit(up);
    const glm::dvec3 right = cross(up, ahead);
    return {mirrored ? -right : right, up};
}

// Eye and centre stay.
Camera turned(const Camera& camera, const glm::dvec3& ahead, bool mirrored, double roll, double scale) {
    const Level level = level_of(ahead, mirrored);
    const auto [sine, cosine] = sine_cosine(roll);
    Camera result = camera;
    result.right = without_negative_zero(scale * length_of(camera.right) * (cosine * level.right - sine * level.up));
    result.up = without_negative_zero(scale * length_of(camera.up) * (cosine * level.up + sine * level.right));
    return result;
}

Camera scaled(const Camera& camera, double scale) {
    Camera result = camera;
    result.right *= scale;
    result.up *= scale;
    return result;
}

Camera between(const Camera& before, const glm::dvec3& eye, const glm::dvec3& center) {
    if (eye == before.eye && center == before.center) return before;
    Camera camera = before;
    camera.eye = eye;
    camera.center = center;
    const glm::dvec3 old_axis = before.center - before.eye;
    const glm::dvec3 axis = center - eye;
    const CameraAxes axes = camera_axes(before);
    const double old_distance = length_of(old_axis);
    const double distance = length_of(axis);
    if (dot(unit(old_axis), axes.ahead) < 1.0 - straight || distance == 0.0 || !std::isfinite(distance)) return camera;
    const double scale = before.orthographic() ? 1.0 : distance / old_distance;
    return turned(camera, unit(axis), axes.mirrored, roll_of(before), scale);
}

}  // namespace

double field_of_view(const Camera& camera) {
    return 2.0 * std::atan2(length_of(camera.up), distance_of(camera)) * degrees_per_radian;
}

Camera with_field_of_view(const Camera& camera, double degrees) {
    const auto [sine, cosine] = sine_cosine(0.5 * degrees);
    return scaled(camera, distance_of(camera) * (sine / cosine) / length_of(camera.up));
}

double screen_side(const Camera& camera) { return 2.0 * length_of(camera.up); }

Camera with_screen_side(const Camera& camera, double side) { return scaled(camera, side / screen_side(camera)); }

double roll_of(const Camera& camera) {
    const CameraAxes axes = camera_axes(camera);
    const Level level = level_of(axes.ahead, axes.mirrored);
    return std::atan2(dot(axes.up, level.right), dot(axes.up, level.up)) * degrees_per_radian;
}

Camera with_roll(const Camera& camera, double degrees) {
    const CameraAxes axes = camera_axes(camera);
    return turned(camera, axes.ahead, axes.mirrored, degrees, 1.0);
}

Camera with_eye(const Camera& camera, const glm::dvec3& eye) { return between(camera, eye, camera.center); }

Camera with_center(const Camera& camera, const glm::dvec3& center) { return between(camera, camera.eye, center); }

}  // namespace sphereview
