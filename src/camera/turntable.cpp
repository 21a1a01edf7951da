#include "camera/turntable.hpp"

#include <algorithm>

#include "base/sine_cosine.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

glm::dvec3 axis_of(const ViewAxes& axes, TurnAxis axis) {
    switch (axis) {
        case TurnAxis::up: return axes.up;
        case TurnAxis::x: return {1.0, 0.0, 0.0};
        case TurnAxis::y: return {0.0, 1.0, 0.0};
        case TurnAxis::z: return {0.0, 0.0, 1.0};
    }
    return axes.up;
}

}  // namespace

std::optional<TurnAxis> turn_axis_named(std::string_view name) {
    const auto found = std::ranges::find(turn_axis_names, name);
    if (found == turn_axis_names.end()) return std::nullopt;
    return static_cast<TurnAxis>(found - turn_axis_names.begin());
}

Turn::Turn(const ViewAxes& axes, TurnAxis axis) : axis_(axis_of(axes, axis)) {
    // In a mirrored view a turn that goes to the right is the other one.
    if (dot(cross(axes.right, axes.up), axes.ahead) > 0.0) axis_ = -axis_;
}

// By Rodrigues' formula.
glm::dvec3 Turn::direction(const glm::dvec3& v, double degrees) const {
    if (degrees == 0.0) return v;
    const auto [sine, cosine] = sine_cosine(degrees);
    const double along = dot(axis_, v) * (1.0 - cosine);
    const glm::dvec3 across = cross(axis_, v);
    return without_negative_zero({v.x * cosine + across.x * sine + axis_.x * along,
                                  v.y * cosine + across.y * sine + axis_.y * along,
                                  v.z * cosine + across.z * sine + axis_.z * along});
}

glm::dvec3 Turn::place(const glm::dvec3& point, const glm::dvec3& pivot, double degrees) const {
    if (degrees == 0.0) return point;
    return pivot + direction(point - pivot, degrees);
}

ViewAxes Turn::axes(const ViewAxes& axes, double degrees) const {
    return {direction(axes.right, degrees), direction(axes.up, degrees), direction(axes.ahead, degrees)};
}

Camera Turn::camera(const Camera& camera, const glm::dvec3& pivot, double degrees) const {
    return {place(camera.eye, pivot, degrees), place(camera.center, pivot, degrees), direction(camera.right, degrees),
            direction(camera.up, degrees), camera.projection};
}

}  // namespace sphereview
