#include "base/user_folders.hpp"

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

#ifdef _WIN32
#include <windows.h>
#elif defined(__APPLE__)
#include <mach-o/dyld.h>

#include <cstdint>
#endif

#include "base/text.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

constexpr const char* program = "sphereview";

// What the variable names, if that is an absolute path: all others are to be ignored (XDG Base Directory Specification).
#ifdef _WIN32
fs::path from_environment(const wchar_t* variable) {
    const wchar_t* value = _wgetenv(variable);
#else
fs::path from_environment(const char* variable) {
    const char* value = std::getenv(variable);
#endif
    const fs::path path = value == nullptr ? fs::path() : fs::path(value);
    return path.is_absolute() ? path : fs::path();
}

fs::path below(const fs::path& folder, const fs::path& name) { return folder.empty() ? fs::path() : folder / name; }

#if !defined(_WIN32) && !defined(__APPLE__)

// A folder of the user's own choice, or the one that the specification gives.
fs::path xdg_folder(const char* variable, const char* otherwise) {
    const fs::path chosen = from_environment(variable);
    return chosen.empty() ? below(home_folder(), otherwise) : chosen;
}

// By the file of xdg-user-dirs, which has lines like XDG_PICTURES_DIR="$HOME/Pictures"; empty when it says nothing. The last one
// counts, as for a shell.
fs::path chosen_pictures_folder() {
    constexpr std::string_view key = "XDG_PICTURES_DIR=";
    constexpr std::string_view home = "$HOME";
    const fs::path choices = below(xdg_folder("XDG_CONFIG_HOME", ".config"), "user-dirs.dirs");
    fs::path chosen;
    if (std::error_code ignored; !fs::is_regular_file(choices, ignored)) return chosen;  // a FIFO would be waited for
    std::ifstream file(choices);
    for (std::string line; std::getline(file, line);) {
        const std::string_view setting = trimmed(line);
        if (!setting.starts_with(key)) continue;
        std::string path;
        std::istringstream(std::string(setting.substr(key.size()))) >> std::quoted(path);
        if ((path + "/").starts_with(std::string(home) + "/")) path.replace(0, home.size(), home_folder().string());
        if (fs::path(path).is_absolute()) chosen = path;
    }
    return chosen;
}

#else

fs::path chosen_pictures_folder() { return {}; }

#endif

bool is_folder(const fs::path& path) {
    std::error_code ignored;
    return !path.empty() && fs::is_directory(path, ignored);
}

}  // namespace

#ifdef _WIN32
fs::path home_folder() { return from_environment(L"USERPROFILE"); }
fs::path config_folder() { return below(from_environment(L"APPDATA"), program); }
fs::path state_folder() { return below(from_environment(L"LOCALAPPDATA"), program); }
#elif defined(__APPLE__)
fs::path home_folder() { return from_environment("HOME"); }
fs::path config_folder() { return below(home_folder(), fs::path("Library/Application Support") / program); }
fs::path state_folder() { return config_folder(); }
#else
fs::path home_folder() { return from_environment("HOME"); }
fs::path config_folder() { return below(xdg_folder("XDG_CONFIG_HOME", ".config"), program); }
fs::path state_folder() { return below(xdg_folder("XDG_STATE_HOME", ".local/state"), program); }
#endif

fs::path pictures_folder() {
    fs::path home = home_folder();
    const fs::path chosen = chosen_pictures_folder();
    fs::path pictures = chosen.empty() ? below(home, "Pictures") : chosen;
    if (is_folder(pictures)) return pictures;
    if (is_folder(home)) return home;
    std::error_code error;
    return fs::temp_directory_path(error);
}

std::vector<fs::path> drives() {
    std::vector<fs::path> found;
#ifdef _WIN32
    const DWORD letters = GetLogicalDrives();
    for (int i = 0; i < 26; ++i) {
        if ((letters >> i & 1U) != 0) found.emplace_back(std::string(1, static_cast<char>('A' + i)) + ":\\");
    }
#endif
    return found;
}

fs::path program_file() {
#if defined(__linux__)
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error);
#elif defined(__APPLE__)
    std::string name(4096, '\0');
    auto size = static_cast<std::uint32_t>(name.size());
    return _NSGetExecutablePath(name.data(), &size) == 0 ? fs::path(name.c_str()) : fs::path();
#elif defined(_WIN32)
    std::wstring name(32768, L'\0');
    name.resize(GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
    return name;
#else
    return {};
#endif
}

fs::path share_folder(const fs::path& file) {
    if (file.empty()) return {};
#ifdef _WIN32
    const fs::path prefix = file.parent_path();
#else
    const fs::path prefix = file.parent_path().parent_path();
#endif
    const fs::path folder = prefix / "share" / program;
    return is_folder(folder) ? folder : fs::path();
}

bool make_user_folder(const fs::path& folder) {
    std::error_code error;
    if (folder.empty()) return false;
    if (fs::is_directory(folder, error)) return true;
    if (folder.has_parent_path() && folder.parent_path() != folder && !make_user_folder(folder.parent_path())) return false;
    // Another process may have made it meanwhile: then it is there, but is not ours to change.
    if (fs::create_directory(folder, error)) fs::permissions(folder, fs::perms::owner_all, error);
    return fs::is_directory(folder, error);
}

}  // namespace sphereview
