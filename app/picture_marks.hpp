// Marks over a picture: axes in the lower left corner, a scale bar in the lower right one, a legend in the upper right one. The
// window draws the same lines.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "camera/orientation.hpp"
#include "image/strokes.hpp"
#include "look/coloring.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Whether letters on this background should be dark.
constexpr bool is_light(const Background& background) {
    const Color& color = background.color;
    return !background.transparent && 3 * color.r + 6 * color.g + color.b > 10 * 150;
}

struct PictureMarks {
    bool axes = false;
    bool scale_bar = false;
    glm::dvec3 scale_at{0.0};  // in perspective the bar is right at this point's depth
    std::optional<Coloring> legend{};
    bool on_light = false;  // the legend's letters are dark, for a light background

    bool operator==(const PictureMarks&) const = default;
};

// Sizes of marks in `unit`s; a unit is a number of sixteenths of a pixel.
inline constexpr int axes_radius = 26;  // from the middle to the outermost edge
inline constexpr int marks_margin = 6;  // to the picture's edges
// The unit of a picture's marks: the wanted one, or the largest with which the axes take no more than a third of the picture; 0 if
// letters would be too small to be read.
int unit_of_marks(int shorter_side, int wanted);
// The longest scale bar, as a part of the picture's shorter side.
inline constexpr double longest_scale_bar = 0.25;

// The distance of an axis' end from the middle, and the radius of its ball.
inline constexpr int axis_length = 20;
inline constexpr int axis_ball = 6;  // its radius

// The colours of letters and lines, and of the edge around them, which makes them visible on any colour.
inline constexpr std::array<std::uint8_t, 3> light_mark{245, 246, 248};
inline constexpr std::array<std::uint8_t, 3> dark_mark{18, 20, 26};
// Appends strokes with an edge of that width and colour around all of them.
void append_with_edge(std::vector<Stroke>& strokes, const std::vector<Stroke>& more, int edge,
                      const std::array<std::uint8_t, 3>& color = dark_mark);

std::vector<Stroke> strokes_of_axes(const Camera& camera, StrokePlace middle, int unit);
// The bar with its words above. `corner`: the bar's lower right end. The words leave the depth out if they would be wider than
// `most` sixteenths of a pixel.
std::vector<Stroke> strokes_of_scale_bar(const ScaleBar& bar, StrokePlace corner, int unit, int most);

// Draws the marks, except over a picture that is too small for them.
void draw_marks(const PictureMarks& marks, const Camera& camera, Image& picture);

// The room of a legend, in sixteenths of a pixel. `corner`: the upper right one.
struct LegendRoom {
    StrokePlace corner;
    int width = 0;
    int height = 0;
};

// The room in a picture of that size, in sixteenths of a pixel, with marks of that unit: in the upper right corner, beside the axes
// and above the scale bar.
LegendRoom room_for_legend(int width, int height, int unit);

// The legend of a picture's colours: a bar of colours with numbers, or a dot, name and count for each category. Letters are drawn
// in 1.5 `unit`s, or in one `unit` if there are many categories. Categories that do not fit are counted in a last line: "and 12
// more". Long names are cut. `on_light`: dark letters, for a light background.
std::vector<Stroke> strokes_of_legend(const Coloring& coloring, const LegendRoom& room, int unit, bool on_light);

}  // namespace sphereview
