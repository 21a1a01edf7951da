// Which file may include what: the arrows between the rooms (docs/architecture.md).
#pragma once

#include <string>
#include <string_view>

namespace sphereview {

// What is wrong with a line of a file in `room` ("scene", "app"), or "" for a good #include and for any other line.
std::string include_fault(std::string_view room, std::string_view line);

// Whether the table knows the room.
bool is_room(std::string_view name);

}  // namespace sphereview
