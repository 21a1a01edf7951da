// Recognises files that no format here reads.
#pragma once

#include <string_view>

namespace sphereview {

// The kind of a file for a message, such as "a JPEG picture", by its beginning; "" if unknown. No file that a format here reads may
// begin so: a new format removes its line.
std::string_view foreign_kind(std::string_view head);
inline constexpr std::string_view binary_data = "binary data";  // if no more is known

// The same by the name's ending, for files whose beginning tells nothing.
std::string_view foreign_kind_of_name(std::string_view name);

}  // namespace sphereview
