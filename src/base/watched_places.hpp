// The folders in which something must happen for a path to lead to another content.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sphereview {

// A name in a folder, or "" for all names in it.
struct WatchedPlace {
    std::filesystem::path folder;
    std::string name;
    bool leads_there = false;  // a symbolic link on the way, or what is missing on it; else the file itself

    bool operator==(const WatchedPlace&) const = default;
};

// For a file: itself, and each symbolic link on the way to it. For a folder: all in it, and the same for the links in it. Where
// something is missing on the way, the last place is there.
std::vector<WatchedPlace> watched_places(const std::string& path);

}  // namespace sphereview
