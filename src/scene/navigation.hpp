// Moving a camera by hand. Angles in radians, lengths in scene units. Every result is a camera without a fault.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "scene/scene.hpp"

namespace sphereview {

// Where a picture of that size shows a point: pixels from the top left corner, pixel (0, 0)'s centre is (0.5, 0.5). Nothing
// for a point that is not in front of the eye.
std::optional<glm::dvec2> project(const Camera& camera, PictureSize size, const glm::dvec3& point);

// How deep a point lies, in multiples of the distance from the eye to the screen along the view's axis (1: in the screen's plane).
double depth_of(const Camera& camera, const glm::dvec3& point);

// The point at that depth on the ray through a place in the picture (pixels, as project() gives).
glm::dvec3 point_at(const Camera& camera, PictureSize size, const glm::dvec2& place, double depth);

// Turned about the pivot: `turn` about the world's y axis, `tilt` about the camera's right. A tilt ends at the poles.
Camera orbited(const Camera& camera, const glm::dvec3& pivot, double turn, double tilt);

// Moved parallel to the screen so that what lies at `depth` follows a pointer that moved by so many pixels.
Camera panned(const Camera& camera, PictureSize size, const glm::dvec2& pixels, double depth);

// Moved towards the point (factor < 1) or away from it (> 1) so that it keeps its pixel and its distance is times the factor.
Camera zoomed(const Camera& camera, const glm::dvec3& point, double factor);

// Moved parallel to itself so that the point is in the picture's middle, as deep as before.
Camera centered_on(const Camera& camera, const glm::dvec3& point);

// What the spheres that are not hidden take up. Of an empty scene: what the default screen shows at z = 200.
struct SceneBounds {
    glm::dvec3 low{-100.0, -100.0, 100.0};
    glm::dvec3 high{100.0, 100.0, 300.0};
    double largest_radius = 20.0;

    glm::dvec3 middle() const { return 0.5 * low + 0.5 * high; }
    // The longest side, more than 0.
    double extent() const;
};
SceneBounds bounds_of(const Scene& scene);

}  // namespace sphereview
