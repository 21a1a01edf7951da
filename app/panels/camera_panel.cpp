// The camera's numbers: of the view, which an edit makes the scene's camera; and the scene's saved views, as a list of names.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
    Camera camera_;  // with all that changed in this redraw
    bool changed_ = false;
};

}  // namespace

void draw_camera_panel(const PanelContext& context, SidePanelState& state) { CameraPanel(context, state).draw(); }

namespace {

std::string title_of(const SavedView& view) { return "view '" + shown_text(view.name) + "'"; }

class SavedViews {
public:
    SavedViews(const PanelContext& context, SidePanelState& state)
        : context_(context), state_(state), views_(context.document.scene().views) {}

    void draw() {
        if (state_.renamed_view.of && *state_.renamed_view.of >= views_.size()) state_.renamed_view = {};
        begin_field(context_, "views");
        draw_command_buttons(context_, {{CommandId::save_view, "Save this view", "save view"}});
        for (std::size_t i = 0; i < views_.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            draw_row(i);
            ImGui::PopID();
        }
        if (!state_.view_fault.empty()) {
            fault_text(state_.view_fault);
            note_widget(context_, "view fault");
        }
    }

private:
    static std::string widget_of(std::size_t i) { return "view " + std::to_string(i); }

    void change(std::vector<SavedView> views, const std::string& step) {
        state_.view_fault.clear();
        context_.actions.emplace_back(EditScene{ChangeViews{std::move(views)}, step});
    }

    void draw_row(std::size_t i) {
        const float side = ImGui::GetFrameHeight();
        const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
        const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x - side - gap);
        if (state_.renamed_view.of == i) {
            ImGui::SetNextItemWidth(width);
            if (draw_renaming(context_, state_.renamed_view, "view name")) accept_name(i);
        } else {
            draw_view(i, {width, side});
        }
        ImGui::SameLine(0.0F, gap);
        if (draw_button(context_, "x", widget_of(i) + " delete", "Delete this view", true, {side, side})) remove(i);
    }

    void draw_view(std::size_t i, ImVec2 size) {
        const SavedView& view = views_[i];
        ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, ImVec2(0.0F, 0.5F));
        const std::string label = as_label(view.name) + "###view";
        const bool shown = view.camera == context_.camera;
        const bool clicked = ImGui::Selectable(label.c_str(), shown, ImGuiSelectableFlags_AllowDoubleClick, size);
        ImGui::PopStyleVar();
        note_widget(context_, widget_of(i));
        explain_item(shown_text(view.name) + "\nClick to go there, double-click to rename; the right button has more.");
        if (clicked && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            start_renaming_view(state_, context_.document.scene(), i);
        } else if (clicked) {
            context_.actions.emplace_back(ShowView{view.camera});
        }
        draw_menu(i);
    }

    void draw_menu(std::size_t i) {
        if (!ImGui::BeginPopupContextItem("##menu")) return;
        const auto item = [&](const char* label, bool enabled = true) {
            const bool chosen = ImGui::MenuItem(label, nullptr, false, enabled);
            note_widget(context_, widget_of(i) + " " + label);
            return chosen;
        };
        const SavedView& view = views_[i];
        if (item("Go there")) context_.actions.emplace_back(ShowView{view.camera});
        if (item("Rename")) start_renaming_view(state_, context_.document.scene(), i);
        if (item("Set to what is seen now", view.camera != context_.camera)) {
            std::vector<SavedView> views = views_;
            views[i].camera = context_.camera;
            change(std::move(views), "Change " + title_of(view));
        }
        if (item("Delete")) remove(i);
        ImGui::EndPopup();
    }

    void remove(std::size_t i) {
        std::vector<SavedView> views = views_;
        views.erase(views.begin() + static_cast<std::ptrdiff_t>(i));
        change(std::move(views), "Delete " + title_of(views_[i]));
        state_.renamed_view = {};
    }

    void accept_name(std::size_t i) {
        // What Escape gives back may be a name that was refused.
        const bool given_up = key_pressed(ImGuiKey_Escape);
        const std::string name = std::exchange(state_.renamed_view, {}).name;
        if (given_up || name == views_[i].name) return state_.view_fault.clear();
        std::string fault = view_name_fault(name);
        if (std::ranges::find(views_, name, &SavedView::name) != views_.end()) fault = "the name of another view";
        if (!fault.empty()) {
            state_.view_fault = in_quotes(name) + " is " + fault + ". The view keeps its name.";
            // The keys that follow are still meant for the name, and not for the window.
            if (key_pressed(ImGuiKey_Enter)) state_.renamed_view.start(i, name);
            return;
        }
        std::vector<SavedView> views = views_;
        views[i].name = name;
        change(std::move(views), "Rename " + title_of(views_[i]));
    }

    const PanelContext& context_;
    SidePanelState& state_;
    const std::vector<SavedView>& views_;
};

}  // namespace

bool draw_renaming(const PanelContext& context, Renaming& renaming, const char* widget) {
    if (renaming.focus) focus_next_box();
    ImGui::InputTextWithHint((std::string("##") + widget).c_str(), "name", &renaming.name, ImGuiInputTextFlags_AutoSelectAll);
    note_widget(context, widget);
    if (ImGui::IsItemActive()) renaming.focus = false;
    return ImGui::IsItemDeactivated();
}

EditScene saved_view_of(const Scene& scene, const Camera& camera) {
    std::string name;
    for (std::size_t number = 1; name.empty(); ++number) {
        const std::string candidate = "view " + std::to_string(number);
        if (std::ranges::find(scene.views, candidate, &SavedView::name) == scene.views.end()) name = candidate;
    }
    std::vector<SavedView> views = scene.views;
    views.push_back({name, camera});
    return {ChangeViews{std::move(views)}, "Save " + title_of(SavedView{name, {}})};
}

void start_renaming_view(SidePanelState& state, const Scene& scene, std::size_t view) {
    state.open_camera = true;
    state.renamed_view.start(view, scene.views[view].name);
    state.view_fault.clear();
}

void draw_saved_views(const PanelContext& context, SidePanelState& state) {
    ImGui::PushID("views");
    SavedViews(context, state).draw();
    ImGui::PopID();
}

}  // namespace sphereview
