#include "panels/help.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace sphereview {

namespace {

constexpr auto mouse_table = std::to_array<MouseHelp>({
    {"Left-drag on a selected sphere", "Moves the selected spheres parallel to the screen; with Shift in depth."},
    {"Ctrl+wheel over a selected sphere", "Changes its radius."},
    {"Left-drag elsewhere", "Orbits."},
    {"Middle-drag or Shift+left-drag", "Pans."},
    {"Right-drag or wheel", "Zooms at the pointer."},
    {"Click on a sphere", "Selects it; a click beside all spheres selects none."},
    {"Ctrl+click on a sphere", "Adds it to the selection, or takes it out."},
    {"Double-click on a sphere", "Brings it to the middle of the picture."},
    {"Ctrl+click on a slider", "Types the value."},
    {"File dropped on the window", "Opens the scene in it."},
});

void text(std::string_view words) { ImGui::TextUnformatted(words.data(), words.data() + words.size()); }

// The next row of a table of two columns: what a person does, what comes of it.
void row(std::string_view what, std::string_view meaning) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    text(what);
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0.0F);
    text(meaning);
    ImGui::PopTextWrapPos();
}

bool begin_table(const char* id, float first_column) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_PadOuterX)) return false;
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, first_column);
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

float widest_first_column() {
    float width = 0.0F;
    for (const MouseHelp& line : mouse_table) width = std::max(width, width_of(line.mouse));
    for (const CommandInfo& info : all_commands()) width = std::max(width, width_of(every_shortcut(info.shortcut)));
    return width + ImGui::GetTextLineHeight();
}

// The commands' tables have one line each: "Ctrl+S    Save: Writes the scene to its file."
void draw_commands(float first_column) {
    std::string_view menu;
    bool in_table = false;
    for (const CommandInfo& info : all_commands()) {
        if (info.menu != menu) {
            if (in_table) ImGui::EndTable();
            menu = info.menu;
            heading(menu);
            in_table = begin_table(std::string(menu).c_str(), first_column);
        }
        if (in_table) row(every_shortcut(info.shortcut), std::string(info.label) + ": " + std::string(info.help));
    }
    if (in_table) ImGui::EndTable();
}

}  // namespace

std::span<const MouseHelp> mouse_help() { return mouse_table; }

void draw_help(const PanelContext& context, bool& open) {
    if (!open) return;
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    const ImVec2 size(std::min(760.0F * context.scale, 0.95F * viewport->WorkSize.x),
                      std::min(640.0F * context.scale, 0.9F * viewport->WorkSize.y));
    ImGui::SetNextWindowPos(viewport->GetWorkCenter(), ImGuiCond_Appearing, ImVec2(0.5F, 0.5F));
    ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
    if (ImGui::Begin("Keys and mouse###help", &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        const float first_column = widest_first_column();
        heading("Mouse");
        if (begin_table("mouse", first_column)) {
            for (const MouseHelp& line : mouse_table) row(line.mouse, line.help);
            ImGui::EndTable();
        }
        draw_commands(first_column);
    }
    ImGui::End();
}

}  // namespace sphereview
