#include "base/path.hpp"

namespace sphereview {

bool is_network_name([[maybe_unused]] const std::filesystem::path& path) {
#ifdef _WIN32
    const std::wstring& name = path.native();
    const auto is_slash = [](wchar_t unit) { return unit == L'\\' || unit == L'/'; };
    return name.size() > 2 && is_slash(name[0]) && is_slash(name[1]) && !is_slash(name[2]);
#else
    return false;
#endif
}

std::filesystem::path normal_path(const std::filesystem::path& path) {
    std::filesystem::path normal = path.lexically_normal();
#ifdef _WIN32
    if (is_network_name(path) && !is_network_name(normal)) normal = L"\\" + normal.native();
#endif
    return normal;
}

}  // namespace sphereview
