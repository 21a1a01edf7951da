#include "panels/row_menu.hpp"

#include <imgui.h>

namespace sphereview {

namespace {

constexpr const char* popup = "row menu";

bool item(const PanelContext& context, CommandId id) {
    const CommandInfo& info = info_of(id);
    const std::string label(info.label);
    const bool chosen = ImGui::MenuItem(label.c_str(), first_shortcut(info.shortcut).c_str(), false, context.enabled(id));
    note_widget(context, "row menu " + label);
    return chosen;
}

}  // namespace

void open_row_menu() { ImGui::OpenPopup(popup); }

void draw_row_menu(const PanelContext& context, SidePanelState& state) {
    if (!ImGui::BeginPopup(popup)) return;
    const std::optional<std::uint32_t> primary = context.selection.primary();
    if (item(context, CommandId::rename) && primary) start_renaming(state, context.document.scene(), *primary);
    for (const CommandId id : {CommandId::duplicate, CommandId::hide, CommandId::remove, CommandId::move_up, CommandId::move_down,
                               CommandId::center_on_selection}) {
        if (id == CommandId::move_up || id == CommandId::center_on_selection) ImGui::Separator();
        if (item(context, id)) context.actions.emplace_back(RunCommand{id});
    }
    ImGui::EndPopup();
}

}  // namespace sphereview
