// Turns text into a path and back. All text in this program is UTF-8, so no other code may do this: a path made of narrow text,
// also implicitly, would be in the system's encoding.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/text.hpp"

namespace sphereview {

#ifdef _WIN32

// The standard library would throw for text that is not well-formed.
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

// Whether the path is Windows' name of the network, \\server\share..., which MinGW's library takes for a relative path.
bool is_network_name(const std::filesystem::path& path);

// As lexically_normal(), but keeps a name of the network.
std::filesystem::path normal_path(const std::filesystem::path& path);

}  // namespace sphereview
