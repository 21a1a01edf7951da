// For the file dialog: paths as a person types them, and the table of a folder's entries.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/path.hpp"
#include "panels/dialogs.hpp"

namespace sphereview {

// The typed text as an absolute path, without white space around it: ~ is the home folder, a relative path lies in `folder`.
std::filesystem::path typed_path(std::string_view typed, const std::filesystem::path& folder);

struct Listing {
    std::vector<FileEntry> entries;  // ".." first, then folders, then files; unsorted
    std::string error;               // why there is no listing
};

// The folder's folders, and its files with one of the endings (empty: all). Hidden ones, whose names begin with a dot, only with
// `hidden_files`. Errors of the file system go into `error`.
Listing list_folder(const std::filesystem::path& folder, const std::vector<std::string>& endings, bool hidden_files);

// ".." first, then folders, then files. By names in any letter case, also where size or date are equal.
void sort_entries(std::vector<FileEntry>& entries, const FileOrder& order);

// "812 B", "3.4 kB", "132 MB"; "2026-11-29 04:35" in local time.
std::string size_text(std::uint64_t bytes);
std::string date_text(std::int64_t seconds);

enum class Clicked { nothing, entry, twice };
struct ClickedEntry {
    Clicked clicked = Clicked::nothing;
    FileEntry entry{};
};

// Draws the browser's entries as a table of that height. Returns the entry that was clicked.
ClickedEntry draw_entries(const PanelContext& context, FileBrowser& browser, float height);

}  // namespace sphereview
