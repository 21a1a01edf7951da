#include "app/picture_marks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/ascii.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr int top_margin = 2 * marks_margin;
constexpr int scale_bar_height = 38;  // with its margin and its words
constexpr int bar_width = 11;
constexpr int longest_bar = 150;
constexpr int tick = 3;

Rgb rgb_of(const Color& color) { return {color.r, color.g, color.b}; }

// The font has ASCII alone, and its 0 has a slash and looks like its 8.
std::string legible(const std::string& text) {
    std::string found = in_ascii(text);
    std::ranges::replace(found, '0', 'O');
    return found;
}

// As much of it as is no wider than that, with two dots behind what is cut.
std::string cut(const std::string& text, int unit, int most) {
    if (width_of_strokes(text, unit) <= most) return text;
    std::string shorter = text;
    while (!shorter.empty() && width_of_strokes(shorter + "..", unit) > most) shorter.pop_back();
    return shorter + "..";
}

struct Row {
    Color color;
    std::string name;
    std::string count;
};

class LegendDrawing {
public:
    LegendDrawing(const Coloring& coloring, const LegendRoom& room, int unit, bool on_light)
        : coloring_(coloring),
          room_(room),
          unit_(unit),
          ink_(on_light ? dark_mark : light_mark),
          halo_(on_light ? light_mark : dark_mark) {}

    std::vector<Stroke> draw() {
        if (coloring_.is_category()) {
            draw_categories();
        } else {
            draw_numbers();
        }
        return std::move(strokes_);
    }

private:
    int pitch() const { return (height_of_letters + 3) * letter_; }
    int dot() const { return (height_of_letters + 1) * letter_; }

    void text(const std::string& words, StrokePlace corner) {
        draw_with_edge(strokes_of_text(words, corner, letter_, letter_ * 5 / 4, ink_));
    }

    void draw_with_edge(const std::vector<Stroke>& more) { append_with_edge(strokes_, more, unit_ * 3 / 4, halo_); }

    // With a ring, which tells it from a background of its colour.
    void draw_dot(StrokePlace middle, const Color& color) {
        draw_with_edge({{middle, middle, dot(), ink_}});
        strokes_.push_back({middle, middle, dot() - unit_ * 3 / 2, rgb_of(color)});
    }

    void draw_numbers() {
        const int right = room_.corner.x;
        const std::string title = cut(legible(coloring_.property), letter_, room_.width);
        text(title, {right - width_of_strokes(title, letter_), room_.corner.y});
        const int without = coloring_.without_value > 0 ? pitch() : 0;
        const int top = room_.corner.y + pitch() + 6 * letter_;  // half of the first number is above it
        const int most = std::min(longest_bar * unit_, (room_.height - pitch() - without) * 11 / 20);
        // Numbers have room between them.
        const int ticks = std::max(most / (2 * pitch()) + 1, 2);
        draw_bar(top, top + most);
        for (const Tick& one : ticks_of(coloring_.range, coloring_.log, ticks)) {
            const int y = top + most - static_cast<int>(one.part * most);
            const int end = right - bar_width * unit_ - tick * unit_;
            draw_with_edge({{{end, y}, {end + (tick - 1) * unit_, y}, unit_ * 3 / 2, ink_}});
            const std::string words = cut(legible(one.text), letter_, room_.width);
            const int left = end - 4 * unit_ - width_of_strokes(words, letter_);
            text(words, {left, y - height_of_letters * letter_ / 2});
        }
        if (without == 0) return;
        const std::string words = "no value";
        const int y = top + most + pitch() / 2 + 2 * letter_;
        const StrokePlace middle{right - bar_width * unit_ / 2, y + height_of_letters * letter_ / 2};
        draw_dot(middle, no_value_color);
        text(words, {right - bar_width * unit_ - 4 * unit_ - width_of_strokes(words, letter_), y});
    }

    // Bands that cover each other, so that no background is seen between them.
    void draw_bar(int top, int bottom) {
        const int right = room_.corner.x;
        const int left = right - bar_width * unit_;
        const int height = bottom - top;
        const int bands = std::clamp(height / stroke_unit, 2, 256);
        const auto frame = [&](int width, const Rgb& color) {
            for (const auto& [from, to] :
                 std::initializer_list<std::pair<StrokePlace, StrokePlace>>{{{left, top}, {right, top}},
                                                                            {{right, top}, {right, bottom}},
                                                                            {{right, bottom}, {left, bottom}},
                                                                            {{left, bottom}, {left, top}}}) {
                strokes_.push_back({from, to, width, color});
            }
        };
        frame(unit_ * 5 / 2, halo_);
        const int band = height / bands + 1;
        for (int i = 0; i < bands; ++i) {
            const double part = 1.0 - (i + 0.5) / bands;
            const bool one_color = coloring_.range.low == coloring_.range.high;
            const int y = std::min(top + height * i / bands + band, bottom - band / 2);
            strokes_.push_back(
                {{left + band, y}, {right - band, y}, 2 * band, rgb_of(color_of(coloring_.map, one_color ? 0.5 : part))});
        }
        frame(unit_, ink_);
    }

    std::vector<Row> rows() const {
        std::vector<Row> all;
        for (const Category& category : coloring_.categories) {
            if (category.count == 0) continue;
            all.push_back(
                {category.color, category.name.empty() ? "none" : legible(category.name), legible(in_groups(category.count))});
        }
        return all;
    }

    void draw_categories() {
        std::vector<Row> all = rows();
        const auto fitting = [&] { return static_cast<std::size_t>(std::max(room_.height / pitch() - 1, 1)); };
        if (all.size() > fitting()) letter_ = unit_;
        std::string more;
        if (all.size() > fitting()) {
            const std::size_t shown = std::max<std::size_t>(fitting(), 2) - 1;
            more = legible("and " + in_groups(all.size() - shown) + " more");
            all.resize(shown);
        }
        const int gap = 4 * letter_;
        const int count_gap = 3 * gap;  // as wide as two letters: words that are numbers must not run into theirs
        int widest_count = 0;
        for (const Row& row : all) widest_count = std::max(widest_count, width_of_strokes(row.count, letter_));
        const int most_name = room_.width - dot() - gap - count_gap - widest_count;
        int widest_name = 0;
        for (Row& row : all) {
            row.name = cut(row.name, letter_, most_name);
            widest_name = std::max(widest_name, width_of_strokes(row.name, letter_));
        }
        const std::string title = cut(legible(coloring_.property), letter_, room_.width);
        const int width = std::max({dot() + gap + widest_name + count_gap + widest_count, width_of_strokes(title, letter_),
                                    more.empty() ? 0 : dot() + gap + width_of_strokes(more, letter_)});
        const int left = room_.corner.x - width;
        int y = room_.corner.y;
        text(title, {left, y});
        y += 2 * letter_;
        const int names = left + dot() + gap;
        for (const Row& row : all) {
            y += pitch();
            const StrokePlace middle{left + dot() / 2, y + height_of_letters * letter_ / 2};
            draw_dot(middle, row.color);
            text(row.name, {names, y});
            text(row.count, {names + widest_name + count_gap + widest_count - width_of_strokes(row.count, letter_), y});
        }
        if (!more.empty()) text(more, {names, y + pitch()});
    }

    const Coloring& coloring_;
    LegendRoom room_;
    int unit_;
    Rgb ink_;
    Rgb halo_;
    int letter_ = unit_ * 3 / 2;
    std::vector<Stroke> strokes_;
};

}  // namespace

LegendRoom room_for_legend(int width, int height, int unit) {
    return {
        {width - 2 * marks_margin * unit, top_margin * unit}, width * 45 / 100, height - (top_margin + scale_bar_height) * unit};
}

std::vector<Stroke> strokes_of_legend(const Coloring& coloring, const LegendRoom& room, int unit, bool on_light) {
    return LegendDrawing(coloring, room, unit, on_light).draw();
}

namespace {

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
