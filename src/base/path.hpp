// The one place that turns text into a path and back. All text in this program is UTF-8; a path made of narrow text without these
// functions, also an implied one, would be in the system's own encoding.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sphereview {

// Names of files on Windows are 16-bit units that are usually, but not always, UTF-16. A half of a surrogate pair that stands alone
// becomes the three bytes that UTF-8 would have for it (WTF-8), and so comes back unchanged.
std::string utf8_from(std::u16string_view units);
// The way back; each byte that belongs to no character becomes U+FFFD.
std::u16string utf16_from(std::string_view text);

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
