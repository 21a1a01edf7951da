// Moving a camera by hand. Angles in radians, lengths in scene units. Every result is a camera without a fault: where a move
// would lead out of what doubles can hold, the camera stays as it is. Far from the origin a result's screen may be farther from the
// eye, and larger by as much, so that its numbers stay exact enough: depths are those of one camera.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "scene/camera.hpp"

namespace sphereview {

// The camera of these vectors, `axis` from the eye to the screen's centre; far from the origin with a larger screen, as above, or
// an orthographic one farther away. Unlike the results of the other functions this camera may have a fault.
Camera camera_with(const glm::dvec3& eye, glm::dvec3 axis, glm::dvec3 right, glm::dvec3 up,
                   Projection projection = Projection::perspective);

// The camera with the other projection, if it is another: what lies at the depth keeps its size, and the angle of view is kept for
// the way back.
Camera with_projection(const Camera& camera, Projection projection, double depth);

// How deep a point lies, in multiples of the distance from the eye to the screen along the view's axis (1: in the screen's plane).
double depth_of(const Camera& camera, const glm::dvec3& point);

// How far a vector leads along the screen, in multiples of `right` and of `up`.
glm::dvec2 across_screen(const Camera& camera, const glm::dvec3& v);

// The point at that depth on the ray through a place in the picture (pixels from the top left corner, pixel (0, 0)'s centre is
// (0.5, 0.5)).
glm::dvec3 point_at(const Camera& camera, PictureSize size, const glm::dvec2& place, double depth);

// Where a picture shows a point: the other way round than point_at(). Nothing for a point that is not in front of the eye.
std::optional<glm::dvec2> place_of(const Camera& camera, PictureSize size, const glm::dvec3& point);

// Turned about the pivot, as a pointer would drag what lies before it: a positive `turn`, about the world's y axis, takes that to
// the picture's right, a positive `tilt`, about the camera's right, takes it down. A tilt ends at the poles, where the camera looks
// along y, or as nearly as its roll lets it; a camera that is upside down stays so.
Camera orbited(const Camera& camera, const glm::dvec3& pivot, double turn, double tilt);

// The same for a ball in the hand: `turn` is about the camera's own up, and nothing ends at a pole. What went round may lean.
Camera tumbled(const Camera& camera, const glm::dvec3& pivot, double turn, double tilt);

// Turned about the pivot until the camera's axes are these; of the same hand as the camera's.
Camera turned_to(const Camera& camera, const glm::dvec3& pivot, const CameraAxes& axes);

// Moved parallel to the screen so that what lies at `depth` follows a pointer that moved by so many pixels (y down).
Camera panned(const Camera& camera, PictureSize size, const glm::dvec2& pixels, double depth);

// Moved towards the point (factor < 1) or away from it (> 1) so that it keeps its pixel and its distance is times the factor.
// Orthographic: the screen is times the factor, and moved along itself. The factor is more than 0. Not nearer than a billionth of
// the point's numbers, where directions begin to be rounded.
Camera zoomed(const Camera& camera, const glm::dvec3& point, double factor);

// Moved parallel to itself so that the point is in the picture's middle, as deep as before; as far before the eye as it was
// behind it.
Camera centered_on(const Camera& camera, const glm::dvec3& point);

}  // namespace sphereview
