#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/text.hpp"
#include "base/user_folders.hpp"
#include "panels/file_listing.hpp"
#include "panels/panel_context.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

constexpr const char* hidden_files_label = "Hidden files";

bool fits(const FileKind& kind, std::string_view name) {
    return name.find(kind.part) != std::string_view::npos &&
           std::ranges::any_of(kind.endings, [&](const std::string& ending) { return has_ending(name, ending); });
}

std::vector<std::string> listed_endings(const FileBrowser& browser) {
    if (browser.kinds.empty()) return {};
    if (!browser.saving) return browser.kinds[browser.kind].endings;
    std::vector<std::string> endings;
    for (const FileKind& kind : browser.kinds) endings.insert(endings.end(), kind.endings.begin(), kind.endings.end());
    return endings;
}

// What the name box says, as a file; a new name gets an ending.
fs::path chosen_file(const FileBrowser& browser) {
    fs::path path = typed_path(browser.name, path_from(browser.folder));
    const std::string name = text_from(path.filename());
    std::error_code none;
    const bool complete = std::ranges::any_of(browser.kinds, [&](const FileKind& kind) { return fits(kind, name); });
    const bool stays = browser.only_kinds ? fs::exists(path, none) && !fs::is_regular_file(path, none) : fs::exists(path, none);
    if (!browser.saving || complete || browser.kinds.empty() || stays) return path;
    const FileKind& kind = browser.kinds[browser.kind];
    return kind.endings.empty() ? path : path += path_from(kind.endings.front());
}

void note_listed(FileBrowser& browser, const fs::path& folder) {
    browser.folder = text_from(folder);
    browser.typed_folder = browser.folder;
    browser.listed_folder = browser.folder;
    browser.listed_hidden = browser.hidden_files;
    browser.listed_kind = browser.kind;
}

// Goes to a folder if it can be read; else stays, and says why. The name box gets the keyboard in any case.
bool enter(FileBrowser& browser, const fs::path& folder) {
    browser.focus = FileBrowser::Focus::name;
    Listing listing = list_folder(folder, listed_endings(browser), browser.hidden_files);
    browser.error = listing.error;
    if (!listing.error.empty()) return false;
    note_listed(browser, folder);
    browser.entries = std::move(listing.entries);
    sort_entries(browser.entries, browser.order);
    browser.to_top = true;
    return true;
}

// The first listing, or another after the owner set `folder`: of the nearest folder above that can be read.
void enter_nearest(FileBrowser& browser) {
    fs::path folder = typed_path(browser.folder, home_folder());
    std::string error = browser.listed_folder.empty() ? browser.error : "";  // of the owner
    while (!enter(browser, folder) && folder.has_relative_path()) {
        if (error.empty()) error = browser.error;
        folder = folder.parent_path();
    }
    if (!error.empty()) browser.error = error;
    note_listed(browser, folder);  // where not even the root can be read, there is nothing to try again
}

// Says what is wrong; the box with the fault keeps the keyboard.
Decision refuse(FileBrowser& browser, const std::string& why, FileBrowser::Focus focus = FileBrowser::Focus::name) {
    browser.error = why;
    browser.focus = focus;
    return {};
}

// To go away and call `accept`; where a file would be replaced, only once the person agrees.
Decision accept_file(Dialogs& dialogs, const std::string& path, bool replaces, std::function<void()> accept) {
    if (!replaces) return {true, std::move(accept)};
    const auto answer = [&dialogs, accept = std::move(accept)](bool agreed) {
        if (!agreed) return;
        dialogs.pop_back();
        accept();
    };
    Question question = replace_question("Replace the file?", shown_text(path) + "\n\nexists already.", answer);
    return {false, [&dialogs, question = std::move(question)] { dialogs.emplace_back(question); }};
}

// The button, Enter or a double click: goes where the path box says if something new stands there, or into a folder that
// was named; else this is the file.
Decision confirm(FileBrowser& browser, Dialogs& dialogs) {
    std::error_code none;
    browser.error.clear();
    if (browser.typed_folder != browser.folder) {
        const fs::path typed = typed_path(browser.typed_folder, path_from(browser.folder));
        const bool is_file = fs::is_regular_file(typed, none);
        const bool entered = enter(browser, is_file ? typed.parent_path() : typed);
        if (!entered) return refuse(browser, browser.error, FileBrowser::Focus::path);
        if (!is_file) return {};
        browser.name = text_from(typed.filename());  // as if the folder and the name had been chosen
    }
    if (trimmed(browser.name).empty()) return refuse(browser, browser.saving ? "The file needs a name." : "Choose a file.");
    const fs::path path = chosen_file(browser);
    if (fs::is_directory(path, none)) {
        if (!enter(browser, path)) return refuse(browser, browser.error);
        browser.name.clear();
        return {};
    }
    const bool exists = fs::exists(path, none);
    if (!browser.saving && !exists) return refuse(browser, "There is no file " + text_from(path) + ".");
    if (browser.saving && !fs::is_directory(path.parent_path(), none)) {
        return refuse(browser, "There is no folder " + text_from(path.parent_path()) + ".");
    }
    auto accept = [give = browser.accept, text = text_from(path), size = browser.size.value_or(PictureSize{})] {
        if (give) give(text, size);
    };
    return accept_file(dialogs, text_from(path), browser.saving && exists, std::move(accept));
}

// What of the choices below the list cannot be.
std::string fault_of_choice(const FileBrowser& browser) {
    const std::string fault = size_fault(browser);
    return fault.empty() && browser.film ? browser.film->judged.fault : fault;
}

// A text box that is typed into does not see that its text was replaced. So each folder has a box of its own.
bool text_box(const FileBrowser& browser, const char* label, std::string& text, ImGuiInputTextFlags flags) {
    ImGui::PushID(browser.listed_folder.c_str());
    const bool edited = ImGui::InputText(label, &text, flags);
    ImGui::PopID();
    return edited;
}

// Gives the keyboard to the next item if `browser.focus` names its box.
void focus_next(FileBrowser& browser, FileBrowser::Focus box) {
    if (browser.focus != box) return;
    focus_next_box();
    browser.focus = FileBrowser::Focus::none;
}

void draw_path(const PanelContext& context, FileBrowser& browser) {
    const bool up = ImGui::Button("Up");
    note_widget(context, "browser up");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
    focus_next(browser, FileBrowser::Focus::path);
    text_box(browser, "##path", browser.typed_folder, ImGuiInputTextFlags_None);
    note_widget(context, "browser path");
    if (up) enter(browser, path_from(browser.folder).parent_path());
}

// The home folder and the owner's places.
void draw_places(const PanelContext& context, FileBrowser& browser, const ImVec2& size) {
    fs::path chosen;
    const auto place = [&](const std::string& label, const std::string& widget, const fs::path& folder) {
        const std::string path = text_from(folder);
        if (ImGui::Selectable((as_label(label) + "###" + widget).c_str(), path == browser.folder)) chosen = folder;
        note_widget(context, widget);
        explain_item(shown_text(path));
    };
    if (ImGui::BeginChild("places", size, true)) {
        if (!home_folder().empty()) place("Home", "browser home", home_folder());
        for (const fs::path& drive : drives()) place(text_from(drive), "drive " + text_from(drive), drive);
        if (!browser.places.empty()) ImGui::TextDisabled("Recent");
        for (std::size_t i = 0; i < browser.places.size(); ++i) {
            const fs::path folder = path_from(browser.places[i]);
            place(folder.has_filename() ? text_from(folder.filename()) : browser.places[i], "place " + std::to_string(i), folder);
        }
    }
    ImGui::EndChild();
    if (!chosen.empty()) enter(browser, chosen);
}

std::string label_of(const FileKind& kind) {
    const bool few = !kind.endings.empty() && kind.endings.size() <= 3;
    return as_label(kind.name + (few ? " (" + joined(kind.endings, ", ") + ")" : ""));
}

void choose_kind(FileBrowser& browser, std::size_t kind) {
    const auto old = std::ranges::find_if(browser.kinds, [&](const FileKind& one) { return fits(one, browser.name); });
    browser.kind = kind;
    if (!browser.saving || old == browser.kinds.end() || browser.kinds[kind].endings.empty()) return;
    if (old->part != browser.kinds[kind].part) {
        browser.name = browser.kinds[kind].usual;
        return;
    }
    const auto ending = std::ranges::find_if(old->endings, [&](const std::string& one) { return has_ending(browser.name, one); });
    browser.name.resize(browser.name.size() - ending->size());
    browser.name += browser.kinds[kind].endings.front();
}

// To save, the kind is the one that the name says.
void follow_name(FileBrowser& browser) {
    const auto named = std::ranges::find_if(browser.kinds, [&](const FileKind& kind) { return fits(kind, browser.name); });
    if (browser.saving && named != browser.kinds.end()) browser.kind = static_cast<std::size_t>(named - browser.kinds.begin());
}

void draw_name(const PanelContext& context, FileBrowser& browser, float width) {
    std::vector<std::string> kinds;
    for (const FileKind& kind : browser.kinds) kinds.push_back(label_of(kind));
    const float kinds_width = kinds.size() > 1 ? widest_of(kinds) + 2.0F * ImGui::GetFrameHeight() : 0.0F;
    const bool kinds_below = kinds_width > 0.4F * width;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Name");
    ImGui::SameLine();
    const float left = ImGui::GetCursorPosX();
    const bool beside = kinds_width > 0.0F && !kinds_below;
    ImGui::SetNextItemWidth(-(beside ? kinds_width + ImGui::GetStyle().ItemSpacing.x : 1.0F));
    if (ImGui::IsWindowAppearing()) browser.focus = FileBrowser::Focus::name;
    focus_next(browser, FileBrowser::Focus::name);
    if (text_box(browser, "##name", browser.name, ImGuiInputTextFlags_AutoSelectAll)) {
        browser.typed_folder = browser.folder;  // what was typed last is meant: a name here, or a folder above
        browser.error.clear();                  // of another name nothing is known yet
        follow_name(browser);
    }
    note_widget(context, "browser name");
    if (kinds_width <= 0.0F) return;
    // No kind's words are cut off: where they would leave too little for the name, they go below it.
    if (beside) {
        ImGui::SameLine();
    } else {
        ImGui::SetCursorPosX(left);
    }
    ImGui::SetNextItemWidth(std::min(kinds_width, ImGui::GetContentRegionAvail().x));
    if (const auto chosen = draw_choice(context, "browser kind", kinds, browser.kind)) choose_kind(browser, *chosen);
}

// All but the buttons. The list takes what the rest leaves. Returns the entry that was clicked, with how.
ClickedEntry draw_form(const PanelContext& context, FileBrowser& browser) {
    draw_path(context, browser);
    const float width = ImGui::GetContentRegionAvail().x;
    if (browser.below_list <= 0.0F) {  // nothing is drawn yet: at least as much, so that ImGui does not scroll to the name
        const float lines = 1.0F + (browser.size ? 2.0F : 0.0F) + (browser.marks ? 1.0F : 0.0F) + (browser.film ? 8.0F : 0.0F);
        browser.below_list = lines * ImGui::GetFrameHeightWithSpacing();
    }
    const float fewest = browser.film || browser.size ? 2.0F : 5.0F;  // lines: a form leaves less room in a small window
    const float room = ImGui::GetContentRegionAvail().y - browser.below_list - ImGui::GetStyle().ItemSpacing.y;
    const float height = std::max(fewest * ImGui::GetTextLineHeightWithSpacing(), std::floor(room));
    draw_places(context, browser, {0.22F * width, height});
    ImGui::SameLine();
    auto clicked = draw_entries(context, browser, height);
    const float below = ImGui::GetCursorPosY();
    draw_name(context, browser, width);
    if (browser.size) draw_size(context, browser);
    if (browser.marks) {
        draw_checkbox(context, "With " + browser.marks->words, browser.marks->drawn, "export marks",
                      "What the window shows over its picture");
    }
    if (browser.film) draw_film_form(context, *browser.film);
    browser.below_list = ImGui::GetCursorPosY() - below;
    return clicked;
}

}  // namespace

Decision draw_content(const PanelContext& context, FileBrowser& browser, const DialogKeys& keys, Dialogs& dialogs) {
    const bool other_files =
        browser.hidden_files != browser.listed_hidden || (!browser.saving && browser.kind != browser.listed_kind);
    if (browser.listed_folder.empty()) follow_name(browser);  // the one that the owner offers
    if (browser.listed_folder.empty() || browser.folder != browser.listed_folder || other_files) enter_nearest(browser);
    if (browser.film) judge(*browser.film, text_from(chosen_file(browser)));
    // What is wrong and the buttons stay in sight, whatever of the rest has to be scrolled.
    const float width = ImGui::GetContentRegionAvail().x;
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const std::string unfit = fault_of_choice(browser);
    const std::string& fault = browser.error.empty() ? unfit : browser.error;
    const float told_height = std::max(fault_height(fault, width), ImGui::GetTextLineHeight());
    const float ends =
        form_end_width(context) + ImGui::GetStyle().ItemSpacing.x + ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
    const bool hidden_beside = width >= ends + width_of(hidden_files_label);
    const float end_lines = hidden_beside ? 1.0F : 2.0F;
    ImGui::BeginChild("form", {0.0F, -(told_height + gap + end_lines * ImGui::GetFrameHeightWithSpacing())});
    const auto [clicked, entry] = draw_form(context, browser);
    ImGui::EndChild();
    // A line is always there, so that nothing jumps.
    const float top = ImGui::GetCursorPosY();
    if (!fault.empty()) {
        draw_fault(fault, width);
    } else if (browser.film) {
        draw_film_summary(context, *browser.film);
    }
    ImGui::SetCursorPosY(top + told_height + gap);
    const char* const ok = browser.size ? "Export" : browser.saving ? "Save" : "Open";
    const bool possible = unfit.empty();
    const FormEnd end = draw_form_end(context, "browser", ok, possible, keys);
    if (hidden_beside) ImGui::SameLine();
    draw_checkbox(context, hidden_files_label, browser.hidden_files, "browser hidden");

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
    follow_name(browser);
    return clicked == Clicked::twice && possible ? confirm(browser, dialogs) : Decision{};
}

}  // namespace sphereview
