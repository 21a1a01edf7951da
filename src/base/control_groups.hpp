// What Linux says of memory in its files, and the limits of control groups there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sphereview {

// The number in a file, or behind `key` at the start of one of its lines; nothing for other words ("max") and missing files, and
// elsewhere than on Linux.
std::optional<std::uint64_t> number_in_file(const std::string& path, std::string_view key = {});

// Bytes that are left of the limits of this process's control groups and of those around them, of version 1 or 2; nothing where
// they set none, and elsewhere than on Linux. `root`: the folder that holds /proc and /sys.
std::optional<std::uint64_t> memory_left_in_groups(const std::string& root = "");

}  // namespace sphereview
