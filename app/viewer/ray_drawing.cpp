#include "viewer/ray_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "camera/beside.hpp"
#include "camera/navigation.hpp"
#include "panels/math_text.hpp"
#include "panels/ray_section.hpp"
#include "panels/widgets.hpp"
#include "scene/vectors.hpp"
#include "viewer/drawn_screen.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

constexpr double crowded = 0.35;         // how much of their opacity rays keep that lie side by side
constexpr double most_steps = 60'000.0;  // of all lines together: where it would be more often, they are asked more rarely

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
        canvas_.list().PushClipRect(
            {canvas_.over().area.x, canvas_.over().area.y},
            {canvas_.over().area.x + canvas_.over().area.width, canvas_.over().area.y + canvas_.over().area.height});
        // What the screen hides comes first: of each line the part on the other side of its plane.
        const bool eye_is_nearer = is_before_screen(state_.camera);
        draw_rays_on(!eye_is_nearer);
        screen_.draw();
        draw_rays_on(eye_is_nearer);
        draw_marks();
        canvas_.list().PopClipRect();
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
        const bool there = !hits.empty() && static_cast<std::size_t>(hits.front().number) < state_.scene().spheres.size();
        return there ? hits.data() : nullptr;
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
