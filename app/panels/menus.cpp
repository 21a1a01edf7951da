#include "panels/menus.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "panels/file_listing.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

constexpr auto mouse_table = std::to_array<MouseHelp>({
    {"Left-drag on a selected sphere", "Moves the selected spheres parallel to the screen; with Shift in depth."},
    {"Ctrl+wheel over a selected sphere", "Scales the selected spheres."},
    {"Left-drag elsewhere", "Orbits."},
    {"Middle-drag or Shift+left-drag", "Pans."},
    {"Right-drag or wheel", "Zooms at the pointer."},
    {"Click on a sphere", "Selects it; a click beside all spheres selects none."},
    {"Ctrl+click on a sphere", "Adds it to the selection, or takes it out."},
    {"Ctrl+left-drag", "Selects the spheres that are seen in the box; with Shift they join, or if all were selected, leave."},
    {"Double-click on a sphere", "Brings it to the middle of the picture."},
    {"Ctrl+click on a slider", "Types the value."},
    {"File dropped on the window", "Opens the scene in it."},
});

void cell(std::string_view words) {
    ImGui::TableNextColumn();
    wrapped_text(words);
}

// Of the columns of the commands' tables: the shortcut's and the name's; the help has the rest.
struct Widths {
    float what = 0.0F;
    float name = 0.0F;
};

// Without the name's column if that has no width.
bool begin_table(const char* id, float what, float name) {
    if (!ImGui::BeginTable(id, name > 0.0F ? 3 : 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_PadOuterX)) return false;
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, what);
    if (name > 0.0F) ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, name);
    ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
    return true;
}

void heading(std::string_view title) {
    ImGui::Dummy(ImVec2(0.0F, 0.3F * ImGui::GetTextLineHeight()));
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    wrapped_text(title);
    ImGui::PopStyleColor();
}

Widths widest() {
    Widths widths;
    for (const CommandInfo& info : all_commands()) {
        widths.what = std::max(widths.what, width_of(every_shortcut(info.shortcut)));
        widths.name = std::max(widths.name, width_of(info.label));
    }
    return widths;
}

void draw_mouse() {
    float widest_mouse = 0.0F;
    for (const MouseHelp& line : mouse_table) widest_mouse = std::max(widest_mouse, width_of(line.mouse));
    heading("Mouse");
    if (!begin_table("mouse", widest_mouse, 0.0F)) return;
    for (const MouseHelp& line : mouse_table) {
        cell(line.mouse);
        cell(line.help);
    }
    ImGui::EndTable();
}

// A table for each menu.
void draw_commands() {
    const Widths widths = widest();
    std::string_view menu;
    bool in_table = false;
    for (const CommandInfo& info : all_commands()) {
        if (info.menu != menu) {
            if (in_table) ImGui::EndTable();
            menu = info.menu;
            heading(menu);
            in_table = begin_table(std::string(menu).c_str(), widths.what, widths.name);
        }
        if (!in_table) continue;
        cell(every_shortcut(info.shortcut));
        cell(info.label);
        cell(info.help);
    }
    if (in_table) ImGui::EndTable();
}

}  // namespace

std::span<const MouseHelp> mouse_help() { return mouse_table; }

void draw_help(const PanelContext& context, bool& open) {
    if (!open) return;
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    const ImVec2 size(std::min(860.0F * context.scale, 0.95F * viewport->WorkSize.x),
                      std::min(640.0F * context.scale, 0.9F * viewport->WorkSize.y));
    ImGui::SetNextWindowPos(viewport->GetWorkCenter(), ImGuiCond_Appearing, ImVec2(0.5F, 0.5F));
    ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
    if (ImGui::Begin("Keys and mouse###help", &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        draw_mouse();
        draw_commands();
    }
    ImGui::End();
}

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

// Notes a menu's title before it is drawn: ImGui's last item is another once the menu is open.
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
        const std::string folder = shown_text(text_from(path.parent_path().filename()));
        if (ImGui::MenuItem(label.c_str(), folder.c_str())) context.actions.emplace_back(OpenFile{recent[i]});
        note_widget(context, "recent " + std::to_string(i));
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", shown_text(recent[i]).c_str());
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
