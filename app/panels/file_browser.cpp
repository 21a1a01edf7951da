#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "panels/dialog_parts.hpp"
#include "panels/file_choice.hpp"
#include "panels/labels.hpp"
#include "panels/paths.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

// A text box that is being typed into does not see that its text was replaced; that of another folder is another box.
bool text_box(const FileBrowser& browser, const char* label, std::string& text, ImGuiInputTextFlags flags) {
    ImGui::PushID(browser.listed_folder.c_str());
    const bool edited = ImGui::InputText(label, &text, flags);
    ImGui::PopID();
    return edited;
}

void draw_places(const PanelContext& context, FileBrowser& browser) {
    const bool up = ImGui::Button("Up");
    note_widget(context, "browser up");
    ImGui::SameLine();
    ImGui::BeginDisabled(home_folder().empty());
    const bool home = ImGui::Button("Home");
    ImGui::EndDisabled();
    note_widget(context, "browser home");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
    text_box(browser, "##path", browser.typed_folder, ImGuiInputTextFlags_None);
    note_widget(context, "browser path");
    if (up) enter(browser, path_from(browser.folder).parent_path());
    if (home) enter(browser, home_folder());
}

enum class Clicked { nothing, entry, twice };

Clicked draw_entry(const PanelContext& context, const FileBrowser::Entry& entry, bool chosen) {
    Clicked clicked = Clicked::nothing;
    const ImVec2 begin = ImGui::GetCursorScreenPos();
    // The name is drawn apart, because a label must not hold every character that a file's name may.
    if (ImGui::Selectable("##entry", chosen, ImGuiSelectableFlags_AllowDoubleClick)) {
        clicked = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) ? Clicked::twice : Clicked::entry;
    }
    note_widget(context, "entry " + entry.name);
    const std::string shown = on_one_line(entry.name) + (entry.is_folder ? "/" : "");
    const ImU32 color = ImGui::GetColorU32(entry.is_folder ? ImGuiCol_CheckMark : ImGuiCol_Text);
    ImGui::GetWindowDrawList()->AddText(begin, color, shown.data(), shown.data() + shown.size());
    return clicked;
}

// Returns the entry that was clicked, with how.
std::pair<Clicked, FileBrowser::Entry> draw_entries(const PanelContext& context, FileBrowser& browser, float height) {
    std::pair<Clicked, FileBrowser::Entry> result{Clicked::nothing, {}};
    ImGui::PushID(browser.listed_folder.c_str());  // another folder's list begins at its top
    if (ImGui::BeginChild("entries", {0.0F, height}, true)) {
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(browser.entries.size()));
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                const FileBrowser::Entry& entry = browser.entries[static_cast<std::size_t>(i)];
                ImGui::PushID(i);
                const Clicked clicked = draw_entry(context, entry, !entry.is_folder && entry.name == browser.name);
                ImGui::PopID();
                if (clicked != Clicked::nothing) result = {clicked, entry};
            }
        }
        if (browser.entries.empty()) ImGui::TextDisabled("Nothing here.");
    }
    ImGui::EndChild();
    ImGui::PopID();
    return result;
}

void draw_name(const PanelContext& context, FileBrowser& browser) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Name");
    ImGui::SameLine();
    const float check_box =
        ImGui::CalcTextSize("Hidden files").x + ImGui::GetFrameHeight() + 3.0F * ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetNextItemWidth(-check_box);
    if (std::exchange(browser.focus_name, false) || ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    // What was typed last is meant: a name here, or a folder above.
    if (text_box(browser, "##name", browser.name, ImGuiInputTextFlags_AutoSelectAll)) browser.typed_folder = browser.folder;
    note_widget(context, "browser name");
    ImGui::SameLine();
    ImGui::Checkbox("Hidden files", &browser.hidden_files);
    note_widget(context, "browser hidden");
}

}  // namespace

Decision draw_content(const PanelContext& context, FileBrowser& browser, const DialogKeys& keys, Dialogs& dialogs) {
    if (browser.listed_folder.empty() || browser.folder != browser.listed_folder) enter_nearest(browser);
    if (browser.hidden_files != browser.listed_hidden) enter_nearest(browser);
    draw_places(context, browser);
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 padding = ImGui::GetStyle().ItemSpacing;
    // The name, the buttons and what is wrong stand below the list; that line is always there, so that nothing jumps.
    const float error_height = std::max(fault_height(browser.error, width), ImGui::GetTextLineHeight());
    const float below = 2.0F * ImGui::GetFrameHeight() + error_height + 3.0F * padding.y;
    const float least = 3.0F * ImGui::GetTextLineHeightWithSpacing();
    const auto [clicked, entry] = draw_entries(context, browser, std::max(least, ImGui::GetContentRegionAvail().y - below));
    draw_name(context, browser);
    if (browser.error.empty()) {
        ImGui::Dummy({0.0F, error_height});
    } else {
        draw_fault(browser.error, width);
    }
    const FormEnd end = draw_form_end(context, "browser", browser.saving ? "Save" : "Open", true, keys);

    if (end == FormEnd::cancel) return {true, {}};
    if (end == FormEnd::ok) return confirm(browser, dialogs);
    if (clicked == Clicked::nothing) return {};
    browser.typed_folder = browser.folder;
    if (entry.is_folder) {
        const fs::path folder = path_from(browser.folder);
        if (clicked == Clicked::twice) enter(browser, entry.name == ".." ? folder.parent_path() : folder / path_from(entry.name));
        return {};
    }
    browser.name = entry.name;
    return clicked == Clicked::twice ? confirm(browser, dialogs) : Decision{};
}

}  // namespace sphereview
