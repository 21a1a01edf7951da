#include "scene/camera.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace sphereview {

namespace {

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// The vector scaled by a power of two so that its largest component lies in [0.5, 1): its square cannot over- or underflow.
struct Scaled {
    glm::dvec3 vector;
    int exponent;
};

Scaled scaled(const glm::dvec3& v) {
    int exponent = 0;
    std::frexp(largest_of(v), &exponent);
    // In two steps: 2^-exponent itself may overflow.
    const auto shrink = [&](double x) { return std::ldexp(std::ldexp(x, -exponent / 2), -(exponent - exponent / 2)); };
    return {{shrink(v.x), shrink(v.y), shrink(v.z)}, exponent};
}

}  // namespace

std::optional<CameraFault> camera_fault(const Camera& camera) {
    const glm::dvec3 zero{0.0};
    if (!finite(camera.eye) || !finite(camera.center) || !finite(camera.right) || !finite(camera.up)) {
        return CameraFault{"its numbers are not all finite", {"eye", "center", "right", "up"}};
    }
    // Halved only where the difference overflows: half of the smallest double is 0.
    glm::dvec3 axis = camera.center - camera.eye;
    if (!finite(axis)) axis = camera.center * 0.5 - camera.eye * 0.5;
    if (camera.right == zero) return CameraFault{"'right' is zero", {"right"}};
    if (camera.up == zero) return CameraFault{"'up' is zero", {"up"}};
    if (axis == zero) return CameraFault{"'eye' and 'center' are the same point", {"eye", "center"}};

    const Scaled right = scaled(camera.right);
    const Scaled up = scaled(camera.up);
    const glm::dvec3 forward = glm::normalize(scaled(axis).vector);
    const glm::dvec3 unit_right = glm::normalize(right.vector);
    const glm::dvec3 unit_up = glm::normalize(up.vector);

    if (std::fabs(glm::dot(unit_right, unit_up)) > camera_tolerance)
        return CameraFault{"'up' is not perpendicular to 'right'", {"up", "right"}};
    const double ratio = glm::length(up.vector) / glm::length(right.vector) * std::ldexp(1.0, up.exponent - right.exponent);
    if (!(std::fabs(ratio - 1.0) <= camera_tolerance)) return CameraFault{"'right' and 'up' are not equally long", {"up", "right"}};
    if (std::fabs(glm::dot(forward, glm::cross(unit_right, unit_up))) <= camera_tolerance) {
        return CameraFault{"'eye' lies in the screen's plane, or within 1e-6 of its distance from 'center'",
                           {"eye", "center", "up", "right"}};
    }
    return std::nullopt;
}

}  // namespace sphereview
