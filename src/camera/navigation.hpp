// Moving a camera by hand. Angles in radians, lengths in scene units. Every result is a camera without a fault: a move beyond the
// range of doubles leaves the camera as it is. Far from the origin a result's screen may be farther from the eye and larger by the
// same factor, so that its numbers stay exact enough. So a depth holds for one camera only.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "scene/camera.hpp"

namespace sphereview {

// The camera of these vectors; `axis` goes from the eye to the screen's centre. Far from the origin the screen is larger, as above,
// or, if orthographic, farther away. Unlike the results of the other functions this camera may have a fault.
Camera camera_with(const glm::dvec3& eye, glm::dvec3 axis, glm::dvec3 right, glm::dvec3 up,
                   Projection projection = Projection::perspective);

// The camera with that projection. What lies at `depth` keeps its size. The angle of view is remembered for the way back.
Camera with_projection(const Camera& camera, Projection projection, double depth);

// A point's depth along the view's axis: 1 is the screen's plane.
double depth_of(const Camera& camera, const glm::dvec3& point);

// How far a vector leads along the screen, in multiples of `right` and of `up`.
glm::dvec2 across_screen(const Camera& camera, const glm::dvec3& v);

// The point at `depth` on the ray through a place in the picture, in pixels: the centre of pixel (0, 0) is (0.5, 0.5).
glm::dvec3 point_at(const Camera& camera, PictureSize size, const glm::dvec2& place, double depth);

// Where a picture shows a point, the inverse of point_at(). Nothing for a point that is not in front of the eye.
std::optional<glm::dvec2> place_of(const Camera& camera, PictureSize size, const glm::dvec3& point);

// Turned about the pivot. A positive `turn`, about the world's y axis, moves what lies in front of the pivot to the picture's
// right; a positive `tilt`, about the camera's right, moves it down. A tilt ends at the poles, where the camera looks along y, or
// as nearly as its roll allows. A camera that is upside down stays so.
Camera orbited(const Camera& camera, const glm::dvec3& pivot, double turn, double tilt);

// The same as with a trackball: `turn` is about the camera's own up, and no pole ends a tilt. The camera may lean afterwards.
Camera tumbled(const Camera& camera, const glm::dvec3& pivot, double turn, double tilt);

// Turned about the pivot until the camera's axes are `axes`, which have the camera's handedness.
Camera turned_to(const Camera& camera, const glm::dvec3& pivot, const CameraAxes& axes);

// Moved parallel to the screen so that what lies at `depth` follows a pointer that moved by so many pixels (y down).
Camera panned(const Camera& camera, PictureSize size, const glm::dvec2& pixels, double depth);

// Moved towards the point (0 < factor < 1) or away from it (factor > 1): the point keeps its pixel, and its distance is multiplied
// by the factor. Orthographic: the screen's size is multiplied instead. Not nearer than a billionth of the point's coordinates,
// where directions begin to be rounded.
Camera zoomed(const Camera& camera, const glm::dvec3& point, double factor);

// Moved parallel to itself so that the point is in the picture's middle, at the same depth. A point behind the eye is then as far
// in front of it.
Camera centered_on(const Camera& camera, const glm::dvec3& point);

}  // namespace sphereview
