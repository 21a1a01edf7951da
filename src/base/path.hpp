// The one place that turns text into a path and back. All text in this program is UTF-8; a path made of narrow text without these
// functions, also an implied one, would be in the system's own encoding.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sphereview {

inline std::filesystem::path path_from(std::string_view text) {
    return std::filesystem::path(std::u8string(text.begin(), text.end()));
}

inline std::string text_from(const std::filesystem::path& path) {
    const std::u8string text = path.u8string();
    return {text.begin(), text.end()};
}

}  // namespace sphereview
