// A camera as the numbers that people set one by one: eye, centre, angle of view and roll. Unlike the results of navigation these
// cameras may have a fault, where nothing else can be made of the number: whoever sets one asks camera_fault().
#pragma once

#include <glm/vec3.hpp>

#include "scene/camera.hpp"

namespace sphereview {

// Angles of view are more than 0 degrees and less than 180; these are the ends that people set.
inline constexpr double narrowest_view = 0.001;
inline constexpr double widest_view = 179.0;

// In degrees, between the middles of the screen's upper and lower edge, seen from an eye as far before the screen's middle as the
// camera's own is before the screen. The default camera's is 53.13. Of a camera without a fault.
double field_of_view(const Camera& camera);
// Eye and centre stay; the screen gets larger or smaller.
Camera with_field_of_view(const Camera& camera, double degrees);

// The screen's side, in scene units: what an orthographic picture shows. More than 0.
double screen_side(const Camera& camera);
Camera with_screen_side(const Camera& camera, double side);

// In degrees from -180 to 180: how far the camera is turned clockwise about where it looks, against one whose `up` is as near to +y
// as that way of looking lets it be. One that looks straight down has +z as that, one that looks straight up -z, as the views from
// the top and the bottom have.
double roll_of(const Camera& camera);
Camera with_roll(const Camera& camera, double degrees);

// The eye, or the screen's centre, is there, and the camera looks from the one to the other as it did before: with its roll and
// its angle of view, or, orthographic, the side of its screen. Where the centre lies off the axis, and the screen askew to that
// line, the screen stays as it is.
Camera with_eye(const Camera& camera, const glm::dvec3& eye);
Camera with_center(const Camera& camera, const glm::dvec3& center);

}  // namespace sphereview
