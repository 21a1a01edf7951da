// The camera's numbers: of the view, which an edit makes the scene's camera.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.hpp"
#include "camera/camera_values.hpp"
#include "panels/number_field.hpp"
#include "panels/side_panel.hpp"
#include "panels/widgets.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// Angles are shown without what turning vectors into them adds: an exponent of ten.
constexpr int last_angle_digit = -6;
constexpr int side_digits = 10;  // likewise; significant ones

// Shortened; in full as a tooltip.
void draw_vector(const PanelContext& context, const char* label, const glm::dvec3& v) {
    begin_field(context, label);
    ImGui::AlignTextToFramePadding();
    // What is far below the last digit of the largest is the rounding of turns.
    constexpr double nothing_beside = 1e-12;
    const double largest = largest_of(v);
    const auto text = [&](double part) { return short_text(std::fabs(part) < nothing_beside * largest ? 0.0 : part); };
    ImGui::TextDisabled("%s, %s, %s", text(v.x).c_str(), text(v.y).c_str(), text(v.z).c_str());
    explain_item(shortest(v.x) + "\n" + shortest(v.y) + "\n" + shortest(v.z));
}

class CameraPanel {
public:
    CameraPanel(const PanelContext& context, SidePanelState& state) : context_(context), state_(state), camera_(context.camera) {}

    void draw() {
        draw_command_buttons(context_,
                             {{CommandId::use_view_as_camera, "Use this view", "use view"}, {CommandId::go_home, "Home", "home"}});
        vector("eye", "Move the camera's eye", &Camera::eye, with_eye);
        vector("centre", "Move the camera's centre", &Camera::center, with_center);
        if (camera_.orthographic()) {
            const NumberRule rule{.above_zero = true, .help = "How much of the scene the picture's shorter side shows."};
            number("side", rule, "Change the camera's side",
                   rounded_to(screen_side(camera_), last_digit(screen_side(camera_), side_digits)), with_screen_side);
        } else {
            const NumberRule rule{.low = narrowest_view,
                                  .high = widest_view,
                                  .usual_size = 50.0,
                                  .help = "Field of view, in degrees, over the picture's shorter side.",
                                  .unit = degree_sign};
            number("field of view", rule, "Change the field of view", rounded_to(field_of_view(camera_), last_angle_digit),
                   with_field_of_view);
        }
        number("roll",
               {.usual_size = 100.0, .help = "Turns the camera about where it looks, clockwise, in degrees.", .unit = degree_sign},
               "Roll the camera", rounded_to(roll_of(camera_), last_angle_digit) + 0.0, with_roll);
        draw_projection();
        draw_vector(context_, "right", camera_.right);
        draw_vector(context_, "up", camera_.up);
    }

private:
    // Makes the view that camera, by edits of the scene's. So that undoing the change gives this view back, one that is not the
    // scene's camera becomes it in a step of its own before.
    void change(const Camera& camera, const std::string& step, std::uint64_t gesture) {
        if (!changed_ && context_.camera != context_.document.scene().camera) {
            context_.actions.emplace_back(EditScene{ChangeCamera{context_.camera}, "Use of this view as the camera"});
        }
        changed_ = true;
        camera_ = camera;
        context_.actions.emplace_back(EditScene{ChangeCamera{camera, true}, step, gesture});
    }

    // What a drag of a number changes: nothing adds up, and back is back to the bit.
    const Camera& base_of(NumberChange kind) {
        if (kind != NumberChange::dragged) return camera_;
        CameraDrag& drag = state_.camera_drag;
        if (drag.gesture != context_.gesture) drag = {context_.gesture, camera_};
        return drag.camera;
    }

    // `with` makes a camera of one and the number.
    template <typename With>
    void edit(const std::string& name, const NumberRule& rule, const std::string& step, double value, const With& with) {
        const NumberChange kind = draw_number(context_, state_.numbers, name, rule, value);
        if (kind == NumberChange::none) return;
        const bool dragged = kind == NumberChange::dragged;
        const Camera base = base_of(kind);
        const Camera camera = dragged && value == state_.numbers.drag.from ? base : with(base, value);
        if (const auto fault = camera_fault(camera)) {
            if (!dragged) refuse_number(state_.numbers, name, "No camera: " + fault->what);
            return;
        }
        change(camera, step, dragged ? context_.gesture : 0);
    }

    template <typename With>
    void number(const char* name, const NumberRule& rule, const char* step, double value, const With& with) {
        begin_field(context_, name);
        edit(name, rule, step, value, with);
        draw_refusal(context_, state_.numbers, name);
    }

    // Three fields side by side, or, where they would be too narrow to be read, below each other.
    void vector(const char* label, const char* step, glm::dvec3 Camera::*part, Camera (*with)(const Camera&, const glm::dvec3&)) {
        begin_field(context_, label);
        const float whole = ImGui::CalcItemWidth();
        const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
        const float third = std::floor((whole - 2.0F * gap) / 3.0F);
        const bool stacked = third < 3.5F * ImGui::GetFontSize();
        constexpr std::array<const char*, 3> axes = {" x", " y", " z"};
        ImGui::BeginGroup();
        for (int i = 0; i < 3; ++i) {
            if (i > 0 && !stacked) ImGui::SameLine(0.0F, gap);
            ImGui::SetNextItemWidth(std::max(1.0F, stacked ? whole : third));
            const auto with_part = [&](const Camera& base, double value) {
                glm::dvec3 v = base.*part;
                v[i] = value;
                return with(base, v);
            };
            edit(std::string(label) + axes.at(static_cast<std::size_t>(i)), coordinate_rule(context_.bounds), step,
                 (camera_.*part)[i], with_part);
        }
        ImGui::EndGroup();
        for (const char* axis : axes) draw_refusal(context_, state_.numbers, std::string(label) + axis);
    }

    void draw_projection() {
        begin_field(context_, "projection");
        const std::vector<std::string> words(projection_names.begin(), projection_names.end());
        const auto chosen = draw_choice(context_, "projection", words, static_cast<std::size_t>(camera_.projection));
        if (!chosen) return;
        const double depth = depth_of(camera_, context_.bounds.middle());
        change(with_projection(camera_, static_cast<Projection>(*chosen), depth > 0.0 ? depth : 1.0), "Change the projection", 0);
    }

    const PanelContext& context_;
    SidePanelState& state_;
    Camera camera_;  // with all that changed in this frame
    bool changed_ = false;
};

}  // namespace

void draw_camera_panel(const PanelContext& context, SidePanelState& state) { CameraPanel(context, state).draw(); }

}  // namespace sphereview
