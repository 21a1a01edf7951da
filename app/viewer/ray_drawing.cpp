#include "viewer/ray_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "camera/beside.hpp"
#include "camera/navigation.hpp"
#include "panels/math_text.hpp"
#include "panels/ray_section.hpp"
#include "panels/widgets.hpp"
#include "scene/vectors.hpp"
#include "viewer/view_marks.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

constexpr double crowded = 0.35;         // how much of their opacity rays keep that lie side by side
constexpr double most_steps = 60'000.0;  // of all lines together: where it would be more often, they are asked more rarely

constexpr double picture_opacity = 0.9;  // of the picture on the screen: what is behind it shimmers through
constexpr double hidden_picture = 0.10;

constexpr float largest_patch = 36.0F;  // of the picture on the screen, in screen coordinates: drawn as if it were flat
constexpr float smallest_patch = 2.0F;  // at the edge of what hides it
constexpr int most_halvings = 12;

// The screen of an eye that is seen from beside: its edge, a grid, and the picture on it. What it is given must outlive it.
// `texture`: the picture, if there is one yet.
class DrawnScreen {
public:
    DrawnScreen(const RayCanvas& canvas, const RaysInSpace& rays, const std::optional<ImTextureID>& texture, const Inks& inks);

    void draw() const;

    // In the scene.
    const std::array<glm::dvec3, 4>& corners() const { return corners_; }

private:
    glm::dvec3 on_screen(const glm::dvec2& place) const;
    int grid_cell() const;
    void draw_patch(const glm::dvec2& low, const glm::dvec2& high, int halvings) const;
    void halve(const glm::dvec2& low, const glm::dvec2& high, const std::array<glm::dvec2, 4>& places, bool is_before,
               int halvings) const;
    double visible_part(const glm::dvec2& low, const glm::dvec2& high) const;
    glm::dvec3 point_on_screen(const glm::dvec2& part) const;
    bool is_outside(const std::array<ImVec2, 4>& points) const;

    const RayCanvas& canvas_;
    const RaysInSpace& rays_;
    const std::optional<ImTextureID>& texture_;
    const Inks& inks_;
    std::array<glm::dvec3, 4> corners_;
};

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

class RayDrawing {
public:
    RayDrawing(const ViewerState& state, const Inspection& inspection, const std::optional<ImTextureID>& seen_by_eye,
               const DrawnOver& over)
        : state_(state),
          rays_(state.rays),
          inspection_(inspection),
          canvas_(state, over),
          inks_(inks_on(state.shown_background())),
          screen_(canvas_, rays_, seen_by_eye, inks_) {}

    void draw() {
        const OverPicture clipped(canvas_.over().area);
        // What the screen hides comes first: of each line the part on the other side of its plane.
        const bool eye_is_nearer = is_before_screen(state_.camera);
        draw_rays_on(!eye_is_nearer);
        screen_.draw();
        draw_rays_on(eye_is_nearer);
        draw_marks();
    }

private:
    // Whether the view is on the eye's side of the screen.
    bool is_before_screen(const Camera& view) const {
        const glm::dvec3 ahead = camera_axes(rays_.camera).ahead;
        if (view.orthographic()) return dot(view.center - view.eye, ahead) > 0.0;
        return dot(view.eye - screen_.corners()[0], ahead) < 0.0;
    }

    // --- Rays ---

    // The rays' parts on one side of the screen: from where they begin to it, or from there on.
    void draw_rays_on(bool eye_side) const {
        draw_frustum(eye_side);
        const double step = step_of_all();
        if (rays_.rays.made()) {
            for (const TracedRay& ray : *rays_.rays.made()) {
                Ink ink = inks_.of(state_.scene(), ray.visible);
                // Of a whole picture they lie side by side: before the screen, and where they hit nothing.
                if (rays_.choice.shown == RaysShown::all && (eye_side || ray.visible < 0)) ink.opacity *= crowded;
                draw_part(ray.from, ray.to, eye_side, ink, 1.0F, step);
                if (ray.visible >= 0 && !eye_side) canvas_.dot_at(ray.to, ink, 1.7F);
            }
        }
        draw_single(inspection_.second, second_ink, eye_side);
        draw_single(inspection_.first, first_ink, eye_side);
    }

    // All rays together are asked for no more places than most_steps.
    double step_of_all() const {
        if (!rays_.rays.made()) return usual_step;
        double pixels = 0.0;
        for (const TracedRay& ray : *rays_.rays.made()) {
            if (const auto shown = canvas_.projected(ray.from, ray.to)) pixels += shown->pixels() / canvas_.over().pixels;
        }
        return std::max(usual_step, pixels / most_steps);
    }

    // `to` is somewhere along a ray of the eye's that begins in `from`.
    void draw_part(const glm::dvec3& from, const glm::dvec3& to, bool eye_side, const Ink& ink, float width, double step) const {
        const double depth = depth_of(rays_.camera, to);
        if (depth <= rays_.screen_depth) {
            if (eye_side) canvas_.line(from, to, ink, width, step);
            return;
        }
        const glm::dvec3 through = from + rays_.screen_depth / depth * (to - from);
        if (eye_side) {
            canvas_.line(from, through, ink, width, step);
        } else {
            canvas_.line(through, to, ink, width, step);
        }
    }

    void draw_frustum(bool eye_side) const {
        if (!eye_side) return;
        if (!rays_.camera.orthographic()) {
            for (const glm::dvec3& corner : screen_.corners()) canvas_.line(rays_.camera.eye, corner, inks_.frustum, 1.0F);
            return;
        }
        const auto plane = screen_corners(rays_.camera, rays_.size, 0.0);
        for (std::size_t i = 0; i < plane.size(); ++i) {
            canvas_.line(plane[i], screen_.corners()[i], inks_.frustum, 1.0F);
            canvas_.line(plane[i], plane[(i + 1) % plane.size()], inks_.edge, 1.5F);
        }
    }

    bool is_of_eye(const std::optional<InspectedPixel>& pixel) const { return pixel && pixel->place.camera == rays_.camera; }

    const ExplainedHit* hit_of(const InspectedPixel& pixel) const {
        const auto& hits = pixel.explanation.hits;
        return !hits.empty() && has_sphere(state_.scene(), hits.front().number) ? hits.data() : nullptr;
    }

    glm::dvec3 end_of(const InspectedPixel& pixel) const {
        if (const ExplainedHit* hit = hit_of(pixel)) return hit->point;
        return pixel.explanation.origin + rays_.far_depth * pixel.explanation.direction;
    }

    void draw_single(const std::optional<InspectedPixel>& pixel, const Ink& ink, bool eye_side) const {
        if (!is_of_eye(pixel)) return;
        const glm::dvec3 from = pixel->explanation.origin;
        const glm::dvec3 to = end_of(*pixel);
        draw_part(from, to, eye_side, dark_ink, 4.5F, usual_step);
        draw_part(from, to, eye_side, ink, 2.2F, usual_step);
        if (!eye_side) draw_shadow_ray(*pixel);
    }

    void draw_shadow_ray(const InspectedPixel& pixel) const {
        const ExplainedHit* hit = hit_of(pixel);
        const std::optional<InspectedLight>& light = pixel.light;
        if (hit == nullptr || !light || !(light->shines || light->blocker)) return;
        const auto shadow = shadow_ray(state_.scene(), pixel.explanation, light->direction, light->blocker);
        if (!shadow) return;
        const glm::dvec3 way = hit->point - pixel.explanation.origin;
        const double length = shadow->hits.empty() ? 0.6 * std::sqrt(dot(way, way)) : shadow->hits.front().t;
        const glm::dvec3 end = hit->point + length * shadow->direction;
        canvas_.line(hit->point, end, dark_ink, 4.0F);
        canvas_.line(hit->point, end, sun_ink, 1.8F);
        if (!shadow->hits.empty()) {
            canvas_.dot_at(end, sun_ink, 3.5F);
        } else if (const auto at = canvas_.place(end); at && light->is_sun()) {
            sun_at(canvas_.on_window(*at));
        }
    }

    void sun_at(ImVec2 middle) const {
        const float s = canvas_.over().scale;
        canvas_.list().AddCircleFilled(middle, 5.0F * s, sun_ink.times(1.0), 24);
        for (int i = 0; i < 8; ++i) {
            const float angle = 0.785398F * static_cast<float>(i);
            const ImVec2 way{std::cos(angle), std::sin(angle)};
            canvas_.list().AddLine({middle.x + 7.5F * s * way.x, middle.y + 7.5F * s * way.y},
                                   {middle.x + 11.0F * s * way.x, middle.y + 11.0F * s * way.y}, sun_ink.times(1.0), 1.6F * s);
        }
    }

    // --- Marks and names ---

    void draw_marks() const {
        const float line_height = ImGui::GetTextLineHeight();
        for (const bool second : {true, false}) {
            const auto& pixel = second ? inspection_.second : inspection_.first;
            const Ink& ink = second ? second_ink : first_ink;
            if (!is_of_eye(pixel)) continue;
            const glm::dvec3 from = pixel->explanation.origin;
            canvas_.ring_at(from + rays_.screen_depth * pixel->explanation.direction, ink, 4.5F);
            const ExplainedHit* hit = hit_of(*pixel);
            if (rays_.camera.orthographic()) canvas_.dot_at(from, ink, 3.0F);
            if (hit == nullptr) continue;
            canvas_.dot_at(hit->point, dark_ink, 5.5F);
            canvas_.dot_at(hit->point, ink, 4.0F);
            if (const auto at = canvas_.place(hit->point)) {
                const ImVec2 middle = canvas_.on_window(*at);
                canvas_.words({middle.x, middle.y + 1.1F * line_height}, "t = " + number_text(hit->t, 4), ink);
            }
        }
        draw_eye();
        name_below(screen_.corners(), rays_.screen_depth == 1.0 ? "screen" : "screen (moved)");
    }

    // Names a rectangle below its lowest edge.
    void name_below(const std::array<glm::dvec3, 4>& corners, const char* name) const {
        std::optional<ImVec2> lowest;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto at = canvas_.place(0.5 * (corners[i] + corners[(i + 1) % corners.size()]));
            if (!at) continue;
            const ImVec2 middle = canvas_.on_window(*at);
            if (!lowest || middle.y > lowest->y) lowest = middle;
        }
        if (lowest) canvas_.words({lowest->x, lowest->y + ImGui::GetTextLineHeight()}, name, word_ink);
    }

    void draw_eye() const {
        if (rays_.camera.orthographic()) {
            return name_below(screen_corners(rays_.camera, rays_.size, 0.0), "rays begin in this plane");
        }
        const auto at = canvas_.place(rays_.camera.eye);
        if (!at) return;
        const ImVec2 middle = canvas_.on_window(*at);
        const float s = canvas_.over().scale;
        // An almond with an iris.
        const float wide = 11.0F * s;
        const float high = 6.5F * s;
        const auto almond = [&](float more) {
            canvas_.list().PathClear();
            canvas_.list().PathLineTo({middle.x - wide - more, middle.y});
            canvas_.list().PathBezierQuadraticCurveTo({middle.x, middle.y - 2.0F * (high + more)},
                                                      {middle.x + wide + more, middle.y}, 16);
            canvas_.list().PathBezierQuadraticCurveTo({middle.x, middle.y + 2.0F * (high + more)},
                                                      {middle.x - wide - more, middle.y}, 16);
        };
        almond(1.5F * s);
        canvas_.list().PathFillConvex(dark_ink.times(1.3));
        almond(0.0F);
        canvas_.list().PathFillConvex(IM_COL32(245, 247, 250, 255));
        canvas_.list().AddCircleFilled(middle, 5.0F * s, IM_COL32(58, 110, 190, 255), 24);
        canvas_.list().AddCircleFilled(middle, 2.3F * s, IM_COL32(10, 12, 18, 255), 16);
        canvas_.words({middle.x, middle.y - ImGui::GetTextLineHeight() - 6.0F * s}, "eye", word_ink);
    }

    const ViewerState& state_;
    const RaysInSpace& rays_;
    const Inspection& inspection_;
    RayCanvas canvas_;
    Inks inks_;
    DrawnScreen screen_;
};

}  // namespace

std::optional<glm::dvec3> middle_of_rays(const ViewerState& state) {
    const RaysInSpace& rays = state.rays;
    if (!rays.on) return std::nullopt;
    const glm::dvec2 middle{0.5 * rays.size.width, 0.5 * rays.size.height};
    return point_at(rays.camera, rays.size, middle, 0.5 * rays.far_depth);
}

void draw_rays(const ViewerState& state, const Inspection& inspection, const std::optional<ImTextureID>& seen_by_eye,
               const DrawnOver& over) {
    RayDrawing(state, inspection, seen_by_eye, over).draw();
}

}  // namespace sphereview
