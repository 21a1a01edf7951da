// A camera seen from beside: where its screen is drawn, from where a second view sees it and its rays.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "scene/camera.hpp"

namespace sphereview {

// The rays of a camera do not tell how far along them its screen is. How deep the screen is drawn, as of depth_of(), where the
// nearest hit lies that deep, or nothing is hit: where the camera has it, at 1, unless it would reach into the scene there or be
// lost before it.
double screen_depth_before(std::optional<double> nearest_hit);

// The corners of what a picture shows at a depth: top left, top right, bottom right, bottom left.
std::array<glm::dvec3, 4> screen_corners(const Camera& camera, PictureSize size, double depth);

// Where a view's ray through a place of its picture meets the screen of another camera.
struct PlaceOnScreen {
    glm::dvec2 place{0.0};  // in that camera's picture, in pixels from its top left corner
    double depth = 0.0;     // how deep it lies for the view
};
// Nothing where it does not meet the part of the screen that the picture shows, drawn at that depth.
std::optional<PlaceOnScreen> place_on_screen(const Camera& camera, PictureSize size, double screen_depth, const Camera& view,
                                             PictureSize view_size, const glm::dvec2& place);

// A view from beside the camera, somewhat from behind and above, with what the camera sees to the right; all the points are in its
// picture, with some room around them, and, as far as there is room, beside or below what covers the picture's upper left corner:
// so many pixels to the right and down. In perspective. Nothing where doubles cannot hold such a camera.
std::optional<Camera> camera_beside(const Camera& camera, PictureSize size, std::span<const glm::dvec3> points,
                                    const glm::dvec2& covered = glm::dvec2(0.0));

}  // namespace sphereview
