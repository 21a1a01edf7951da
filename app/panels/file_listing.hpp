// What lies in a folder, for the file browser.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "panels/dialogs.hpp"

namespace sphereview {

struct Listing {
    std::vector<FileBrowser::Entry> entries;  // folders first, each kind by name without regard to capitals; ".." before all
    std::string error;                        // why there is no listing: no such folder, not to be read
};

// Folders, and files with one of the endings (empty: all). Hidden ones, whose names begin with a dot, only if asked for.
// Throws nothing that a file system can cause.
Listing list_folder(const std::filesystem::path& folder, const std::vector<std::string>& endings, bool hidden_files);

}  // namespace sphereview
