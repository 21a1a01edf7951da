// Paths as a person types and reads them: UTF-8, with ~ for the home folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sphereview {

std::filesystem::path path_from(std::string_view text);
std::string text_from(const std::filesystem::path& path);

// The user's home folder; empty when the system names none.
std::filesystem::path home_folder();

// What was typed, without white space around it, as an absolute path: ~ is the home folder, a relative path lies in `folder`.
std::filesystem::path typed_path(std::string_view typed, const std::filesystem::path& folder);

// Whether a file's name has one of the endings (".txt"), in capitals or not.
bool has_ending(std::string_view name, std::string_view ending);

}  // namespace sphereview
