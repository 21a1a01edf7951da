// The platform's folders for a user's files, and for the files that came with the program. Asking creates nothing.
#pragma once

#include <filesystem>
#include <vector>

namespace sphereview {

// Empty when the system names none.
std::filesystem::path home_folder();

// Settings: $XDG_CONFIG_HOME or ~/.config, %APPDATA%, ~/Library/Application Support; each with /sphereview. Empty when the
// system names no home.
std::filesystem::path config_folder();

// State, such as recoveries: $XDG_STATE_HOME or ~/.local/state, %LOCALAPPDATA%, ~/Library/Application Support; each with
// /sphereview.
std::filesystem::path state_folder();

// Pictures: xdg-user-dirs' XDG_PICTURES_DIR, else ~/Pictures; the home folder if that is missing; else the temporary folder.
std::filesystem::path pictures_folder();

// On Windows the drives, as "C:\"; nothing elsewhere.
std::vector<std::filesystem::path> drives();

// The running program's file; empty if unknown.
std::filesystem::path program_file();

// PREFIX/share/sphereview, with the folder `scenes`, of a program in PREFIX/bin (on Windows in PREFIX). Empty if it is not
// installed.
std::filesystem::path share_folder(const std::filesystem::path& program = program_file());

// Makes the folder and its parents, if missing, for this user alone. False on failure.
bool make_user_folder(const std::filesystem::path& folder);

}  // namespace sphereview
