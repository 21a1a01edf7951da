// Which way a picture shows the scene's axes, and how large. Made of + - * / and square roots alone, so that the marks in a picture
// have the same bytes everywhere.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "scene/camera.hpp"

namespace sphereview {

// One end of an axis as the view sees it from afar, the axes being of length 1.
struct AxisEnd {
    int axis = 0;  // 0: x, 1: y, 2: z
    bool positive = true;
    glm::dvec2 place{0.0};  // to the right and down, each from -1 to 1
    double toward = 0.0;    // to the eye's side
};

// All six, the farthest first.
std::array<AxisEnd, 6> axis_ends(const Camera& camera);

// The axes of a view along an axis, seen from that end, of the same hand as the camera's. y stays up; seen from the ends of y, z
// does as it does after a tilt from the front.
CameraAxes axes_seen_from(const Camera& camera, const AxisEnd& end);

// A length that is 1, 2 or 5 times a power of ten.
struct ScaleBar {
    double length = 0.0;          // in the scene's units, > 0
    double pixels = 0.0;          // how long the picture shows it
    std::optional<double> depth;  // in perspective: how far from the eye along the view's axis that is so
};

// The longest that takes at most so many pixels, where the point is or, for parallel rays, anywhere. Nothing where the point is not
// before the eye, and beyond what doubles hold.
std::optional<ScaleBar> scale_bar(const Camera& camera, PictureSize size, const glm::dvec3& point, double most_pixels);

// "20"; in perspective "20 at depth 300".
std::string in_words(const ScaleBar& bar);

}  // namespace sphereview
