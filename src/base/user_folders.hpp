// Where the platform wants a program's files of this user, and where those are that came with the program. Nothing is created by
// asking.
#pragma once

#include <filesystem>
#include <vector>

namespace sphereview {

// The user's home folder; empty when the system names none.
std::filesystem::path home_folder();

// Settings: $XDG_CONFIG_HOME or ~/.config, %APPDATA%, ~/Library/Application Support; each with /sphereview. Empty when the
// system names no home.
std::filesystem::path config_folder();

// What survives a crash: $XDG_STATE_HOME or ~/.local/state, %LOCALAPPDATA%, ~/Library/Application Support; with /sphereview.
std::filesystem::path state_folder();

// Pictures: xdg-user-dirs' XDG_PICTURES_DIR, else ~/Pictures; the home folder if that is missing; else the temporary folder.
std::filesystem::path pictures_folder();

// On Windows the drives that there are, as "C:\"; nothing elsewhere.
std::vector<std::filesystem::path> drives();

// The running program's file; empty where the system does not say.
std::filesystem::path program_file();

// What was installed with a program in PREFIX/bin (on Windows in PREFIX): PREFIX/share/sphereview, with the folder `scenes`. Empty
// when nothing was.
std::filesystem::path share_folder(const std::filesystem::path& program = program_file());

// Makes the folder, and those above it, for this user alone where they are missing. False when it is not there then.
bool make_user_folder(const std::filesystem::path& folder);

}  // namespace sphereview
