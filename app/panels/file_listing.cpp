#include "panels/file_listing.hpp"

#include <algorithm>
#include <cstdlib>

#include "base/text.hpp"

namespace sphereview {

namespace fs = std::filesystem;

fs::path path_from(std::string_view text) { return fs::path(std::u8string(text.begin(), text.end())); }

std::string text_from(const fs::path& path) {
    const std::u8string text = path.u8string();
    return {text.begin(), text.end()};
}

fs::path home_folder() {
    for (const char* variable : {"HOME", "USERPROFILE"}) {
        const char* home = std::getenv(variable);
        if (home != nullptr && *home != '\0') return path_from(home);
    }
    return {};
}

fs::path typed_path(std::string_view typed, const fs::path& folder) {
    std::string_view text = trimmed(typed);
    fs::path path;
    if (text == "~" || text.starts_with("~/")) {
        text.remove_prefix(text == "~" ? 1 : 2);
        path = home_folder() / path_from(text);
    } else {
        path = folder / path_from(text);  // an absolute path replaces the folder
    }
    path = path.lexically_normal();
    // "/a/b/" is the folder "/a/b".
    return path.has_filename() || !path.has_relative_path() ? path : path.parent_path();
}

bool has_ending(std::string_view name, std::string_view ending) { return lower_case(name).ends_with(lower_case(ending)); }

namespace {

bool is_wanted(const FileBrowser::Entry& entry, const std::vector<std::string>& endings, bool hidden_files) {
    if (!hidden_files && entry.name.starts_with('.')) return false;
    if (entry.is_folder || endings.empty()) return true;
    return std::ranges::any_of(endings, [&](const std::string& ending) { return has_ending(entry.name, ending); });
}

void sort_for_reading(std::vector<FileBrowser::Entry>& entries) {
    // In lower case once for each, not once for each comparison: folders of many thousands are read too.
    struct Keyed {
        std::string key;
        FileBrowser::Entry entry;
    };
    std::vector<Keyed> keyed;
    keyed.reserve(entries.size());
    for (FileBrowser::Entry& entry : entries) keyed.push_back({lower_case(entry.name), std::move(entry)});
    std::ranges::sort(keyed, [](const Keyed& a, const Keyed& b) {
        if (a.entry.is_folder != b.entry.is_folder) return a.entry.is_folder;
        return a.key != b.key ? a.key < b.key : a.entry.name < b.entry.name;
    });
    std::ranges::transform(keyed, entries.begin(), [](Keyed& one) { return std::move(one.entry); });
}

}  // namespace

Listing list_folder(const fs::path& folder, const std::vector<std::string>& endings, bool hidden_files) {
    Listing listing;
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        std::error_code unknown;  // a link that leads nowhere is a file
        FileBrowser::Entry found{text_from(entry->path().filename()), entry->is_directory(unknown)};
        if (is_wanted(found, endings, hidden_files)) listing.entries.push_back(std::move(found));
    }
    if (error) return {{}, "Cannot read " + text_from(folder) + ": " + error.message()};
    sort_for_reading(listing.entries);
    if (folder.has_relative_path()) listing.entries.insert(listing.entries.begin(), {"..", true});
    return listing;
}

}  // namespace sphereview
