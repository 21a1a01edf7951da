#include "panels/menu_bar.hpp"

#include <imgui.h>

#include "base/text.hpp"
#include "panels/labels.hpp"
#include "panels/paths.hpp"

namespace sphereview {

namespace {

// What the menu says now: undoing and redoing name the step.
std::string label_of(const PanelContext& context, const CommandInfo& info) {
    std::string label(info.label);
    if (info.id == CommandId::undo && context.document.can_undo()) label += " " + context.document.undo_name();
    if (info.id == CommandId::redo && context.document.can_redo()) label += " " + context.document.redo_name();
    return as_label(label);
}

std::string history_text(const PanelContext& context) {
    const auto megabytes = [](std::size_t bytes) { return static_cast<double>(bytes) / 1048576.0; };
    return "Steps to undo: " + fixed(megabytes(context.document.history_bytes()), 1) + " of " +
           fixed(megabytes(context.document.most_history_bytes()), 0) + " MB; beyond that the oldest are forgotten.";
}

void draw_item(const PanelContext& context, const CommandInfo& info) {
    const bool enabled = !context.enabled || context.enabled(info.id);
    const bool checked = context.checked && context.checked(info.id);
    // The label changes with the step; what follows "###" is the same widget for ImGui all the time.
    const std::string label = label_of(context, info) + "###" + std::string(info.label);
    if (ImGui::MenuItem(label.c_str(), first_shortcut(info.shortcut).c_str(), checked, enabled)) {
        context.actions.emplace_back(RunCommand{info.id});
    }
    note_widget(context, "item " + std::string(info.label));
    if (info.id != CommandId::undo && info.id != CommandId::redo) return;
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", history_text(context).c_str());
}

// A menu's title where it is about to be drawn: once it is open, the last item is another.
void note_menu(const PanelContext& context, const std::string& name) {
    if (context.rectangles == nullptr) return;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    (*context.rectangles)["menu " + name] = {low.x, low.y, low.x + width, low.y + ImGui::GetTextLineHeight()};
}

void draw_recent(const PanelContext& context, const std::vector<std::string>& recent) {
    note_menu(context, "Open recent");
    if (!ImGui::BeginMenu("Open recent", !recent.empty())) return;
    for (std::size_t i = 0; i < recent.size(); ++i) {
        const std::filesystem::path path = path_from(recent[i]);
        ImGui::PushID(static_cast<int>(i));
        const std::string label = as_label(text_from(path.filename())) + "###recent";
        const std::string folder = on_one_line(text_from(path.parent_path().filename()));
        if (ImGui::MenuItem(label.c_str(), folder.c_str())) context.actions.emplace_back(OpenFile{recent[i]});
        note_widget(context, "recent " + std::to_string(i));
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", on_one_line(recent[i]).c_str());
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

void draw_submenu(const PanelContext& context, const CommandInfo& first) {
    const std::string name(first.submenu);
    note_menu(context, name);
    if (!ImGui::BeginMenu(name.c_str())) return;
    for (const CommandInfo& info : all_commands()) {
        if (info.menu == first.menu && info.submenu == first.submenu) draw_item(context, info);
    }
    ImGui::EndMenu();
}

void draw_menu(const PanelContext& context, const std::string& menu, const std::vector<std::string>& recent) {
    note_menu(context, menu);
    if (!ImGui::BeginMenu(menu.c_str())) return;
    bool first = true;
    std::string_view submenu;
    for (const CommandInfo& info : all_commands()) {
        if (info.menu != menu) continue;
        if (info.separator_before && !first) ImGui::Separator();
        if (info.submenu.empty()) {
            draw_item(context, info);
        } else if (info.submenu != submenu) {
            draw_submenu(context, info);
        }
        submenu = info.submenu;
        if (info.id == CommandId::file_open) draw_recent(context, recent);
        first = false;
    }
    ImGui::EndMenu();
}

}  // namespace

float draw_menu_bar(const PanelContext& context, const std::vector<std::string>& recent) {
    if (!ImGui::BeginMainMenuBar()) return 0.0F;
    std::string_view menu;
    for (const CommandInfo& info : all_commands()) {
        if (info.menu == menu) continue;
        menu = info.menu;
        draw_menu(context, std::string(menu), recent);
    }
    const float height = ImGui::GetWindowSize().y;
    ImGui::EndMainMenuBar();
    return height;
}

}  // namespace sphereview
