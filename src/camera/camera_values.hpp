// A camera as numbers that people set one by one: eye, centre, angle of view and roll. Unlike the results of navigation these
// cameras may have a fault: ask camera_fault().
#pragma once

#include <glm/vec3.hpp>

#include "scene/camera.hpp"

namespace sphereview {

// The limits for people; angles of view are above 0 and below 180 degrees.
inline constexpr double narrowest_view = 0.001;
inline constexpr double widest_view = 179.0;

// The angle of view in degrees, between the middles of the screen's upper and lower edge, for an eye before the screen's middle at
// the camera's distance. The default camera's is 53.13. For a camera without a fault.
double field_of_view(const Camera& camera);
// Changes the size of the screen; eye and centre stay.
Camera with_field_of_view(const Camera& camera, double degrees);

// The screen's side, in scene units: what an orthographic picture shows. More than 0.
double screen_side(const Camera& camera);
Camera with_screen_side(const Camera& camera, double side);

// The clockwise turn about the viewing direction in degrees, -180 to 180, from the camera whose `up` is nearest to +y. Looking
// straight down that `up` is +z, straight up -z, as in the views from the top and the bottom.
double roll_of(const Camera& camera);
Camera with_roll(const Camera& camera, double degrees);

// Move the eye, or the screen's centre. The camera then looks from the one to the other with the same roll and angle of view, or,
// orthographic, the same side of the screen. A screen that is askew to that line stays as it is.
Camera with_eye(const Camera& camera, const glm::dvec3& eye);
Camera with_center(const Camera& camera, const glm::dvec3& center);

}  // namespace sphereview
