#include "base/watched_places.hpp"

#include <deque>
#include <system_error>

namespace sphereview {

namespace fs = std::filesystem;

namespace {

// Follows a path link by link. Returns the folder that it leads to, or nothing when it leads to a file, or nowhere.
fs::path follow(const fs::path& path, std::vector<WatchedPlace>& places) {
    constexpr int most_links = 40;  // as many as Linux follows
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    fs::path reached = absolute.root_path();
    std::deque<fs::path> ahead;
    for (const fs::path& part : absolute.relative_path()) ahead.push_back(part);
    for (int links = 0; !ahead.empty() && links <= most_links;) {
        const fs::path part = ahead.front();
        ahead.pop_front();
        if (part.empty() || part == ".") continue;
        if (part == "..") {
            reached = reached.parent_path();
            continue;
        }
        const fs::file_status status = fs::symlink_status(reached / part, error);
        if (fs::is_symlink(status)) {
            places.push_back({reached, part.string(), true});
            const fs::path target = fs::read_symlink(reached / part, error);
            if (target.is_absolute()) reached = target.root_path();
            std::deque<fs::path> detour;
            for (const fs::path& step : target.relative_path()) detour.push_back(step);
            ahead.insert(ahead.begin(), detour.begin(), detour.end());
            ++links;
        } else if (fs::is_directory(status)) {
            reached /= part;
        } else {
            places.push_back({reached, part.string(), !ahead.empty()});
            return {};
        }
    }
    return ahead.empty() ? reached : fs::path();
}

}  // namespace

std::vector<WatchedPlace> watched_places(const std::string& path) {
    std::vector<WatchedPlace> places;
    const fs::path folder = follow(path, places);
    if (folder.empty()) return places;
    places.push_back({folder, "", false});
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_symlink(ignored)) follow(entry->path(), places);
    }
    return places;
}

}  // namespace sphereview
