// The one place that turns text into a path and back. All text in this program is UTF-8; a path made of narrow text without these
// functions, also an implied one, would be in the system's own encoding.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/text.hpp"

namespace sphereview {

#ifdef _WIN32

// Not by the standard library, which throws for what is not well-formed.
inline std::filesystem::path path_from(std::string_view text) {
    const std::u16string units = utf16_from(text);
    return std::filesystem::path(std::wstring(units.begin(), units.end()));
}

inline std::string text_from(const std::filesystem::path& path) {
    return utf8_from(std::u16string(path.native().begin(), path.native().end()));
}

#else

inline std::filesystem::path path_from(std::string_view text) {
    return std::filesystem::path(std::u8string(text.begin(), text.end()));
}

inline std::string text_from(const std::filesystem::path& path) {
    const std::u8string text = path.u8string();
    return {text.begin(), text.end()};
}

#endif

// Whether it is a name of the network as only Windows has them, \\server\share..., which MinGW's library takes for a relative one.
bool is_network_name(const std::filesystem::path& path);

// As lexically_normal(), and a name of the network stays one.
std::filesystem::path normal_path(const std::filesystem::path& path);

}  // namespace sphereview
