// The scene's saved views, as a list of names.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "base/text.hpp"
#include "panels/side_panel.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

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
