// What may be drawn over a picture: the axes in its lower left corner, a scale bar in the lower right one. A window draws the same
// lines.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "camera/orientation.hpp"
#include "image/strokes.hpp"

namespace sphereview {

struct PictureMarks {
    bool axes = false;
    bool scale_bar = false;
    glm::dvec3 scale_at{0.0};  // in perspective the bar holds as deep as this point

    bool operator==(const PictureMarks&) const = default;
};

// Sizes are in units of so many sixteenths of a pixel.
inline constexpr int axes_radius = 26;  // from the middle to the outermost edge
inline constexpr int marks_margin = 6;  // to the picture's edges
// Of a picture: the wanted one, or the largest with which the axes take no more than a third of the picture; 0 where letters would
// be too small to be read.
int unit_of_marks(int shorter_side, int wanted);
// The longest that the bar may be, of the picture's shorter side.
inline constexpr double longest_scale_bar = 0.25;

// How far from the middle an axis' end is drawn, and how large it is there.
inline constexpr int axis_length = 20;
inline constexpr int axis_ball = 6;  // its radius

std::vector<Stroke> strokes_of_axes(const Camera& camera, StrokePlace middle, int unit);
// With its words above it. `corner`: the bar's lower right end. Words that are wider than `most`, in sixteenths of a pixel, leave
// the depth out.
std::vector<Stroke> strokes_of_scale_bar(const ScaleBar& bar, StrokePlace corner, int unit, int most);

// A picture that is too small for them gets none.
void draw_marks(const PictureMarks& marks, const Camera& camera, Image& picture);

}  // namespace sphereview
