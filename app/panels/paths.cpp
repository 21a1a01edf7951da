#include "panels/paths.hpp"

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

}  // namespace sphereview
