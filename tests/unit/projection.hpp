// Where pictures show points: the other way round than point_at() of camera/navigation.hpp.
#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "camera/navigation.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

// Pixels from the top left corner, pixel (0, 0)'s centre is (0.5, 0.5). Nothing for a point that is not in front of the eye.
inline std::optional<glm::dvec2> project(const Camera& camera, PictureSize size, const glm::dvec3& point) {
    const CameraAxes directions = camera_axes(camera);
    const double depth = depth_of(camera, point);
    if (!(depth > 0.0)) return std::nullopt;
    // On the screen, from its centre; with the dual vectors, because right and up may be not quite perpendicular.
    const glm::dvec3 axis = camera.center - camera.eye;
    const glm::dvec3 there = camera.orthographic() ? (point - camera.eye) - depth * axis : (point - camera.eye) / depth - axis;
    const glm::dvec3 dual_right = glm::cross(directions.up, directions.ahead);
    const glm::dvec3 dual_up = glm::cross(directions.right, directions.ahead);
    const double across = glm::dot(there, dual_right) / glm::dot(camera.right, dual_right);
    const double upward = glm::dot(there, dual_up) / glm::dot(camera.up, dual_up);
    const double m = size.shorter_side();
    const glm::dvec2 place = 0.5 * glm::dvec2(size.width, size.height) + 0.5 * m * glm::dvec2(across, -upward);
    if (!std::isfinite(place.x) || !std::isfinite(place.y)) return std::nullopt;
    return place;
}

// The default camera with a screen of another size: the same picture.
inline Camera camera_of_screen(int exponent) {
    const Camera usual;
    return {usual.eye, times_two_to(usual.center, exponent), times_two_to(usual.right, exponent), times_two_to(usual.up, exponent)};
}

// So small and so large that their squares are no doubles; the default's comes first.
inline constexpr std::array<int, 3> exponents_of_screens = {0, -570, 660};

}  // namespace sphereview
