#include "panels/help.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

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

void text(std::string_view words) { ImGui::TextUnformatted(words.data(), words.data() + words.size()); }

void cell(std::string_view words) {
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0.0F);
    text(words);
    ImGui::PopTextWrapPos();
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
    text(title);
    ImGui::PopStyleColor();
}

float width_of(std::string_view words) { return ImGui::CalcTextSize(words.data(), words.data() + words.size()).x; }

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

}  // namespace sphereview
