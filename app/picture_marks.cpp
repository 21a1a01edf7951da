#include "app/picture_marks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/legend.hpp"

namespace sphereview {

namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr std::array<Rgb, 3> axis_colors = {{{240, 92, 92}, {128, 204, 84}, {92, 150, 250}}};
constexpr std::array<const char*, 3> axis_names = {"x", "y", "z"};
constexpr Rgb dark = dark_mark;
constexpr Rgb light = light_mark;

// The same shape, so much wider on each side.
Stroke around(Stroke stroke, int by) {
    stroke.width += 2 * by;
    stroke.color = dark;
    return stroke;
}

// `percent` of a colour.
Rgb dimmed(const Rgb& color, int percent) {
    Rgb dim = color;
    for (std::uint8_t& part : dim) part = static_cast<std::uint8_t>(part * percent / 100);
    return dim;
}

}  // namespace

void append_with_edge(std::vector<Stroke>& strokes, const std::vector<Stroke>& more, int edge, const Rgb& color) {
    for (const Stroke& stroke : more) {
        strokes.push_back(around(stroke, edge));
        strokes.back().color = color;
    }
    strokes.insert(strokes.end(), more.begin(), more.end());
}

int unit_of_marks(int shorter_side, int wanted) {
    constexpr int smallest = stroke_unit;  // letters of 7 pixels
    const int most = shorter_side * stroke_unit / (3 * 2 * (axes_radius + marks_margin));
    return most < smallest ? 0 : std::clamp(wanted, smallest, most);
}

std::vector<Stroke> strokes_of_axes(const Camera& camera, StrokePlace middle, int unit) {
    std::vector<Stroke> strokes;
    const int edge = unit * 3 / 4;
    for (const AxisEnd& end : axis_ends(camera)) {
        const auto offset = [&](double part) { return static_cast<int>(std::lround(part * axis_length * unit)); };
        const StrokePlace place{middle.x + offset(end.place.x), middle.y + offset(end.place.y)};
        const auto axis = static_cast<std::size_t>(end.axis);
        // What points away from the eye is darker.
        const Rgb color = dimmed(axis_colors[axis], end.toward < -0.01 ? 72 : 100);
        if (!end.positive) {
            const Stroke ring{place, place, 2 * (axis_ball - 2) * unit, color};
            strokes.insert(strokes.end(), {around(ring, edge), ring, {place, place, 2 * (axis_ball - 3) * unit, dark}});
            continue;
        }
        const Stroke arm{middle, place, 2 * unit, color};
        const Stroke ball{place, place, 2 * axis_ball * unit, color};
        strokes.insert(strokes.end(), {around(arm, edge), around(ball, edge), arm, ball});
        const std::string name = axis_names[axis];
        const StrokePlace letter{place.x - width_of_strokes(name, unit) / 2, place.y - (height_of_letters + 1) * unit / 2};
        const std::vector<Stroke> letters = strokes_of_text(name, letter, unit, unit * 3 / 2, dark);
        strokes.insert(strokes.end(), letters.begin(), letters.end());
    }
    return strokes;
}

std::vector<Stroke> strokes_of_scale_bar(const ScaleBar& bar, StrokePlace corner, int unit, int most) {
    const int edge = unit * 3 / 4;
    const int tick = 3 * unit;
    const int left = corner.x - static_cast<int>(std::lround(bar.pixels * stroke_unit));
    std::string words = in_words(bar);
    if (width_of_strokes(words, unit) > most) words = in_words(ScaleBar{bar.length, bar.pixels, {}});
    std::ranges::replace(words, '0', 'O');  // the font's 0 has a slash, and looks like its 8
    // Digits are told apart the better the larger they are.
    const int larger = unit * 3 / 2;
    const int letter = width_of_strokes(words, larger) <= most ? larger : unit;
    const int width = width_of_strokes(words, letter);
    // In the bar's middle, but no farther to the right than the bar.
    const int text_left = std::min(left + (corner.x - left - width) / 2, corner.x - width);
    const int text_top = corner.y - tick - (3 + height_of_letters) * letter;
    std::vector<Stroke> strokes;
    append_with_edge(strokes,
                     {{{left, corner.y}, corner, 2 * unit, light},
                      {{left, corner.y - tick}, {left, corner.y}, 2 * unit, light},
                      {{corner.x, corner.y - tick}, corner, 2 * unit, light}},
                     edge);
    append_with_edge(strokes, strokes_of_text(words, {text_left, text_top}, letter, letter * 5 / 4, light), edge);
    return strokes;
}

void draw_marks(const PictureMarks& marks, const Camera& camera, Image& picture) {
    const PictureSize size{picture.width(), picture.height()};
    const int unit = unit_of_marks(size.shorter_side(), size.shorter_side() * stroke_unit / 450);
    if (unit == 0) return;
    const int right = size.width * stroke_unit;
    const int bottom = size.height * stroke_unit;
    if (marks.axes) {
        const int away = (axes_radius + marks_margin) * unit;
        draw(strokes_of_axes(camera, {away, bottom - away}, unit), picture);
    }
    const auto bar =
        marks.scale_bar ? scale_bar(camera, size, marks.scale_at, longest_scale_bar * size.shorter_side()) : std::nullopt;
    if (marks.legend) draw(strokes_of_legend(*marks.legend, room_for_legend(right, bottom, unit), unit, marks.on_light), picture);
    if (bar)
        draw(strokes_of_scale_bar(*bar, {right - 2 * marks_margin * unit, bottom - 2 * marks_margin * unit}, unit, right / 2),
             picture);
}

}  // namespace sphereview
