#include "scene/camera.hpp"

#include <cmath>

#include "base/square_root.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// From the eye to the screen's centre, halved only where the difference overflows: half of the smallest double is 0.
glm::dvec3 axis_of(const Camera& camera) {
    const glm::dvec3 axis = camera.center - camera.eye;
    return finite(axis) ? axis : camera.center * 0.5 - camera.eye * 0.5;
}

// How many times as long as the other, a vector that is not zero.
double ratio_of_lengths(const glm::dvec3& a, const glm::dvec3& b) {
    const double largest_a = largest_of(a);
    const double largest_b = largest_of(b);
    const auto length = [](const glm::dvec3& v) { return square_root(dot(v, v)); };
    return length(a / largest_a) / length(b / largest_b) * (largest_a / largest_b);
}

}  // namespace

CameraAxes camera_axes(const Camera& camera) {
    CameraAxes axes{unit(camera.right), unit(camera.up), {}};
    axes.ahead = unit(cross(axes.right, axes.up));
    axes.mirrored = dot(axes.ahead, unit(axis_of(camera))) < 0.0;
    if (axes.mirrored) axes.ahead = -axes.ahead;
    return axes;
}

std::optional<CameraFault> camera_fault(const Camera& camera) {
    const glm::dvec3 zero{0.0};
    if (!finite(camera.eye) || !finite(camera.center) || !finite(camera.right) || !finite(camera.up)) {
        return CameraFault{"its numbers are not all finite", {"eye", "center", "right", "up"}};
    }
    const glm::dvec3 axis = axis_of(camera);
    if (camera.right == zero) return CameraFault{"'right' is zero", {"right"}};
    if (camera.up == zero) return CameraFault{"'up' is zero", {"up"}};
    if (axis == zero) return CameraFault{"'eye' and 'center' are the same point", {"eye", "center"}};

    const glm::dvec3 right = unit(camera.right);
    const glm::dvec3 up = unit(camera.up);
    if (std::fabs(dot(right, up)) > camera_tolerance) return CameraFault{"'up' is not perpendicular to 'right'", {"up", "right"}};
    if (!(std::fabs(ratio_of_lengths(camera.up, camera.right) - 1.0) <= camera_tolerance))
        return CameraFault{"'right' and 'up' are not equally long", {"up", "right"}};
    if (std::fabs(dot(unit(axis), cross(right, up))) <= camera_tolerance) {
        return CameraFault{"'eye' lies in the screen's plane, or within 1e-6 of its distance from 'center'",
                           {"eye", "center", "up", "right"}};
    }
    return std::nullopt;
}

}  // namespace sphereview
