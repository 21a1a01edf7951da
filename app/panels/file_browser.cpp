#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "panels/dialog_parts.hpp"
#include "panels/file_listing.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

// What the name box says, as a file; a new name gets an ending.
fs::path chosen_file(const FileBrowser& browser) {
    fs::path path = typed_path(browser.name, path_from(browser.folder));
    const auto fits = [&](const std::string& ending) { return has_ending(text_from(path.filename()), ending); };
    std::error_code none;
    if (browser.saving && !fs::exists(path, none) && !browser.endings.empty() && std::ranges::none_of(browser.endings, fits)) {
        path += path_from(browser.endings.front());
    }
    return path;
}

// Goes to a folder if it can be read; else stays, and says why.
bool enter(FileBrowser& browser, const fs::path& folder) {
    Listing listing = list_folder(folder, browser.endings, browser.hidden_files);
    browser.error = listing.error;
    if (!listing.error.empty()) return false;
    browser.folder = text_from(folder);
    browser.typed_folder = browser.folder;
    browser.listed_folder = browser.folder;
    browser.listed_hidden = browser.hidden_files;
    browser.entries = std::move(listing.entries);
    browser.focus_name = true;
    return true;
}

// The first listing, or another after the owner set `folder`: of the nearest folder above that can be read.
void enter_nearest(FileBrowser& browser) {
    fs::path folder = typed_path(browser.folder, home_folder());
    std::string error;
    while (!enter(browser, folder) && folder.has_relative_path()) {
        if (error.empty()) error = browser.error;
        folder = folder.parent_path();
    }
    if (!error.empty()) browser.error = error;
    // Where not even the root can be read, there is nothing to try again.
    browser.folder = text_from(folder);
    browser.typed_folder = browser.folder;
    browser.listed_folder = browser.folder;
    browser.listed_hidden = browser.hidden_files;
}

// The button, Enter or a double click: goes where the path box says if something new stands there, or into a folder that
// was named; else this is the file.
Decision confirm(FileBrowser& browser, Dialogs& dialogs) {
    std::error_code none;
    browser.error.clear();
    if (browser.typed_folder != browser.folder) {
        const fs::path typed = typed_path(browser.typed_folder, path_from(browser.folder));
        if (!fs::is_regular_file(typed, none)) {
            enter(browser, typed);
            return {};
        }
        // A file: as if its folder and its name had been chosen.
        if (!enter(browser, typed.parent_path())) return {};
        browser.name = text_from(typed.filename());
    }
    if (browser.name.find_first_not_of(" \t") == std::string::npos) {
        browser.error = browser.saving ? "The file needs a name." : "Choose a file.";
        return {};
    }
    const fs::path path = chosen_file(browser);
    if (fs::is_directory(path, none)) {
        if (enter(browser, path)) browser.name.clear();
        return {};
    }
    const bool exists = fs::exists(path, none);
    if (!browser.saving && !exists) browser.error = "There is no file " + text_from(path) + ".";
    if (browser.saving && !fs::is_directory(path.parent_path(), none)) {
        browser.error = "There is no folder " + text_from(path.parent_path()) + ".";
    }
    if (!browser.error.empty()) return {};
    auto accept = [give = browser.accept, text = text_from(path)] {
        if (give) give(text);
    };
    if (!browser.saving || !exists) return {true, std::move(accept)};
    return {false, [&dialogs, text = text_from(path), accept = std::move(accept)] { ask_to_replace(dialogs, text, accept); }};
}

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
