// The directions and sizes in which a picture shows the scene's axes. Uses + - * / and square roots alone, so that marks have the
// same bytes everywhere.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "scene/camera.hpp"

namespace sphereview {

// One end of an axis of length 1, as the view sees it from afar.
struct AxisEnd {
    int axis = 0;  // 0: x, 1: y, 2: z
    bool positive = true;
    glm::dvec2 place{0.0};  // to the right and down, each from -1 to 1
    double toward = 0.0;    // towards the eye
};

// All six ends, the farthest first.
std::array<AxisEnd, 6> axis_ends(const Camera& camera);

// The axes of a view from that end along its axis, with the camera's handedness. y is up; from the ends of y, z is, as after a tilt
// from the front.
CameraAxes axes_seen_from(const Camera& camera, const AxisEnd& end);

// A length that is 1, 2 or 5 times a power of ten.
struct ScaleBar {
    double length = 0.0;          // in the scene's units, > 0
    double pixels = 0.0;          // its length in the picture
    std::optional<double> depth;  // in perspective: the depth at which that is so
};

// The longest bar of at most `most_pixels`, in perspective at the point's depth. Nothing if the point is not before the eye, or
// doubles cannot hold the length.
std::optional<ScaleBar> scale_bar(const Camera& camera, PictureSize size, const glm::dvec3& point, double most_pixels);

// "20"; in perspective "20 at depth 300".
std::string in_words(const ScaleBar& bar);

}  // namespace sphereview
