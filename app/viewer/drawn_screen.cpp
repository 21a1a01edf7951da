#include "viewer/drawn_screen.hpp"

#include <algorithm>
#include <cmath>

#include "camera/beside.hpp"
#include "viewer/rays_in_space.hpp"

namespace sphereview {

namespace {

constexpr double picture_opacity = 0.9;  // of the picture on the screen: what is behind it shimmers through
constexpr double hidden_picture = 0.10;

constexpr float largest_patch = 36.0F;  // of the picture on the screen, in screen coordinates: drawn as if it were flat
constexpr float smallest_patch = 2.0F;  // at the edge of what hides it
constexpr int most_halvings = 12;

}  // namespace

DrawnScreen::DrawnScreen(const RayCanvas& canvas, const RaysInSpace& rays, const std::optional<ImTextureID>& texture,
                         const Inks& inks)
    : canvas_(canvas),
      rays_(rays),
      texture_(texture),
      inks_(inks),
      corners_(screen_corners(rays.camera, rays.size, rays.screen_depth)) {}

glm::dvec3 DrawnScreen::on_screen(const glm::dvec2& place) const {
    return point_at(rays_.camera, rays_.size, place, rays_.screen_depth);
}

void DrawnScreen::draw() const {
    if (texture_) draw_patch({0.0, 0.0}, {1.0, 1.0}, 0);
    const auto line_across = [&](const glm::dvec2& from, const glm::dvec2& to, const Ink& ink, float width) {
        canvas_.line(on_screen(from), on_screen(to), ink, width, 2.0 * usual_step);
    };
    const double width = rays_.size.width;
    const double height = rays_.size.height;
    const int cell = grid_cell();
    for (int x = cell; x < rays_.size.width; x += cell) line_across({x, 0.0}, {x, height}, inks_.grid, 1.0F);
    for (int y = cell; y < rays_.size.height; y += cell) line_across({0.0, y}, {width, y}, inks_.grid, 1.0F);
    for (std::size_t i = 0; i < corners_.size(); ++i)
        canvas_.line(corners_[i], corners_[(i + 1) % corners_.size()], inks_.edge, 1.6F);
}

// So many pixels of the eye's picture a square of the grid is wide: one in which one ray of all is drawn.
// So many times wider where it would be too small to be seen.
int DrawnScreen::grid_cell() const {
    constexpr double least = 4.5;  // screen coordinates
    int cell = std::max(rays_.choice.in_picture, 1);
    const glm::dvec2 middle{0.5 * rays_.size.width, 0.5 * rays_.size.height};
    const auto at = canvas_.place(on_screen(middle));
    const auto right = canvas_.place(on_screen(middle + glm::dvec2(cell, 0.0)));
    const auto below = canvas_.place(on_screen(middle + glm::dvec2(0.0, cell)));
    if (!at || !right || !below) return cell;
    double spacing = std::min(std::hypot(right->x - at->x, right->y - at->y), std::hypot(below->x - at->x, below->y - at->y)) /
                     (canvas_.over().pixels * static_cast<double>(canvas_.over().scale));
    for (; spacing < least && cell < rays_.size.shorter_side(); spacing *= 2.0) cell *= 2;
    return cell;
}

// A part of the picture, from corner to corner, 0..1. It is halved until each piece is small enough to be drawn as if it were
// seen straight on, and wholly hidden or not.
void DrawnScreen::draw_patch(const glm::dvec2& low, const glm::dvec2& high, int halvings) const {
    const std::array<glm::dvec2, 4> parts = {low, {high.x, low.y}, high, {low.x, high.y}};
    std::array<glm::dvec2, 4> places{};
    std::array<ImVec2, 4> points{};
    std::array<ImVec2, 4> on_texture{};
    bool is_before = true;  // the view
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto at = canvas_.place(point_on_screen(parts[i]));
        is_before = is_before && at.has_value();
        places[i] = at.value_or(glm::dvec2(0.0));
        points[i] = canvas_.on_window(places[i]);
        on_texture[i] = {static_cast<float>(parts[i].x), static_cast<float>(parts[i].y)};
    }
    float longest = 1e30F;
    if (is_before) {
        if (is_outside(points)) return;
        longest = 0.0F;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const ImVec2& next = points[(i + 1) % points.size()];
            longest = std::max(longest, std::hypot(next.x - points[i].x, next.y - points[i].y));
        }
    }
    const bool small = longest <= largest_patch * canvas_.over().scale;
    const double shown = small ? visible_part(low, high) : 0.5;
    const bool mixed = shown > 0.0 && shown < 1.0;
    if (halvings < most_halvings && (!small || (mixed && longest > smallest_patch * canvas_.over().scale))) {
        halve(low, high, places, is_before, halvings);
        return;
    }
    if (!is_before) return;
    const double opacity = shown * picture_opacity + (1.0 - shown) * hidden_picture;
    canvas_.list().AddImageQuad(*texture_, points[0], points[1], points[2], points[3], on_texture[0], on_texture[1], on_texture[2],
                                on_texture[3], Ink{}.times(opacity));
}

void DrawnScreen::halve(const glm::dvec2& low, const glm::dvec2& high, const std::array<glm::dvec2, 4>& places, bool is_before,
                        int halvings) const {
    const auto length = [&](std::size_t i, std::size_t j) {
        return std::hypot(places[i].x - places[j].x, places[i].y - places[j].y);
    };
    const bool across = is_before ? length(0, 1) + length(3, 2) > length(0, 3) + length(1, 2) : halvings % 2 == 0;
    const glm::dvec2 middle = 0.5 * (low + high);
    draw_patch(low, across ? glm::dvec2(middle.x, high.y) : glm::dvec2(high.x, middle.y), halvings + 1);
    draw_patch(across ? glm::dvec2(middle.x, low.y) : glm::dvec2(low.x, middle.y), high, halvings + 1);
}

// How much of a patch no sphere hides.
double DrawnScreen::visible_part(const glm::dvec2& low, const glm::dvec2& high) const {
    constexpr int samples = 3;
    int visible = 0;
    for (int i = 0; i < samples * samples; ++i) {
        const glm::dvec2 part{(i % samples + 0.5) / samples, (static_cast<int>(i / samples) + 0.5) / samples};
        visible += canvas_.is_hidden(point_on_screen(low + part * (high - low))) ? 0 : 1;
    }
    return static_cast<double>(visible) / (samples * samples);
}

glm::dvec3 DrawnScreen::point_on_screen(const glm::dvec2& part) const {
    return on_screen({part.x * rays_.size.width, part.y * rays_.size.height});
}

bool DrawnScreen::is_outside(const std::array<ImVec2, 4>& points) const {
    const auto all = [&](auto holds) { return std::ranges::all_of(points, holds); };
    const Rectangle& a = canvas_.over().area;
    return all([&](const ImVec2& p) { return p.x < a.x; }) || all([&](const ImVec2& p) { return p.x > a.x + a.width; }) ||
           all([&](const ImVec2& p) { return p.y < a.y; }) || all([&](const ImVec2& p) { return p.y > a.y + a.height; });
}

}  // namespace sphereview
