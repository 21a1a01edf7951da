// A camera seen from beside: the place of its drawn screen, and a second view that sees the screen and the rays.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "scene/camera.hpp"

namespace sphereview {

// The depth, as of depth_of(), at which the screen is drawn; the rays are the same for any. `nearest_hit`: the depth of the nearest
// hit, if any. The result is the camera's own 1, unless the screen would then reach into the scene or be tiny before it.
double screen_depth_before(std::optional<double> nearest_hit);

// The corners of what a picture shows at a depth: top left, top right, bottom right, bottom left.
std::array<glm::dvec3, 4> screen_corners(const Camera& camera, PictureSize size, double depth);

// The place where a view's ray meets the screen of another camera.
struct PlaceOnScreen {
    glm::dvec2 place{0.0};  // in that camera's picture, in pixels from its top left corner
    double depth = 0.0;     // its depth for the view
};
// The place where the view's ray through `place` meets the camera's screen, drawn at `screen_depth`. Nothing outside the picture.
std::optional<PlaceOnScreen> place_on_screen(const Camera& camera, PictureSize size, double screen_depth, const Camera& view,
                                             PictureSize view_size, const glm::dvec2& place);

// A view in perspective from beside the camera, somewhat from behind and above; the camera looks to the right in it. All points are
// in its picture, with some room around them, and if possible clear of the upper left corner's `covered` pixels to the right and
// down. Nothing if doubles cannot hold such a camera.
std::optional<Camera> camera_beside(const Camera& camera, PictureSize size, std::span<const glm::dvec3> points,
                                    const glm::dvec2& covered = glm::dvec2(0.0));

}  // namespace sphereview
