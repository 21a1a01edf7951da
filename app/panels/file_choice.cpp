#include "panels/file_choice.hpp"

#include <algorithm>
#include <utility>

#include "panels/file_listing.hpp"
#include "panels/paths.hpp"

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

}  // namespace

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

}  // namespace sphereview
