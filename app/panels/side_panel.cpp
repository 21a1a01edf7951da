#include "panels/side_panel.hpp"

#include <imgui.h>

#include <algorithm>

#include "base/text.hpp"
#include "panels/field.hpp"
#include "panels/scene_panel.hpp"
#include "panels/sphere_editor.hpp"
#include "panels/sphere_list.hpp"
#include "panels/text_input.hpp"

namespace sphereview {

namespace {

constexpr float fewest_rows = 5.0F;

void draw_buttons(const PanelContext& context, SidePanelState& state) {
    // The command shows what it finds all hidden.
    const SharedValues& shared = shared_of_selection(context, state);
    const char* hide = shared.count > 0 && shared.hidden == shared.count ? "Show###hide" : "Hide###hide";
    const std::vector<float> widths = button_widths({"Add", "Duplicate", "Delete", hide});
    draw_command_button(context, CommandId::add_sphere, "Add", "add", widths[0]);
    ImGui::SameLine();
    draw_command_button(context, CommandId::duplicate, "Duplicate", "duplicate", widths[1]);
    ImGui::SameLine();
    draw_command_button(context, CommandId::remove, "Delete", "delete", widths[2]);
    ImGui::SameLine();
    draw_command_button(context, CommandId::hide, hide, "hide", widths[3]);
}

void select_filtered(const PanelContext& context, SidePanelState& state) {
    // What was typed in this frame is looked for in the next.
    const Document& document = context.document;
    if (state.search.filter() != state.filter || state.searched_names != document.names_revision()) return;
    state.search.finish(document.scene());
    std::vector<std::uint32_t> numbers = state.search.found();
    if (ImGui::GetIO().KeyCtrl) {
        const auto& others = context.selection.numbers();
        numbers.insert(numbers.begin(), others.begin(), others.end());
    }
    Selection selection;
    selection.set(std::move(numbers));
    context.actions.emplace_back(SelectSpheres{std::move(selection)});
}

void draw_filter(const PanelContext& context, SidePanelState& state) {
    const float side = ImGui::GetFrameHeight();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float select = ImGui::CalcTextSize("Select").x + 2.0F * ImGui::GetStyle().FramePadding.x;
    const float buttons = state.filter.empty() ? 0.0F : side + select + 2.0F * gap;
    ImGui::SetNextItemWidth(std::max(1.0F, ImGui::GetContentRegionAvail().x - buttons));
    input_text("##filter", "Filter by name or number", state.filter);
    note_widget(context, "filter");
    if (state.filter.empty()) return;
    ImGui::SameLine(0.0F, gap);
    if (ImGui::Button("Select##filtered", {select, side})) select_filtered(context, state);
    note_widget(context, "select filtered");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Select what the filter shows; with Ctrl, besides what is selected");
    ImGui::SameLine(0.0F, gap);
    if (ImGui::Button("x##clear filter", {side, side})) state.filter.clear();
    note_widget(context, "clear filter");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Show all spheres");
}

std::string count_in_words(const PanelContext& context, const SidePanelState& state) {
    const std::size_t count = context.document.scene().spheres.size();
    const std::string all = in_groups(count) + (count == 1 ? " sphere" : " spheres");
    if (!state.filter.empty()) {
        const std::string found = in_groups(state.search.found().size()) + " of " + all;
        return state.search.done() ? found : found + ", " + fixed(100.0 * state.search.part(), 0) + " % looked at";
    }
    return context.selection.size() > 1 ? all + ", " + in_groups(context.selection.size()) + " selected" : all;
}

}  // namespace

void draw_side_panel(const PanelContext& context, SidePanelState& state) {
    draw_buttons(context, state);
    draw_filter(context, state);
    // The list takes what the rest leaves; where that is too little, the panel scrolls.
    const float least = fewest_rows * ImGui::GetFrameHeight();
    draw_sphere_list(context, state, std::max(least, ImGui::GetContentRegionAvail().y - state.below_list));
    const float below = ImGui::GetCursorPosY();
    ImGui::TextDisabled("%s", count_in_words(context, state).c_str());
    if (ImGui::CollapsingHeader("Sphere", ImGuiTreeNodeFlags_DefaultOpen)) draw_sphere_editor(context, state);
    if (ImGui::CollapsingHeader("Scene", ImGuiTreeNodeFlags_DefaultOpen)) draw_scene_panel(context);
    state.below_list = ImGui::GetCursorPosY() - below + ImGui::GetStyle().ItemSpacing.y;
}

}  // namespace sphereview
