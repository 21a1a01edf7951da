// What a file is that no format here reads.
#pragma once

#include <string_view>

namespace sphereview {

// In words for a message: "a JPEG picture" or "a GROMACS file", by what the file begins with; "" where that is not known. No file
// that a format here reads begins so: a format that is added takes its own line away.
std::string_view foreign_kind(std::string_view head);
inline constexpr std::string_view binary_data = "binary data";  // where no more is known

// The same by the ending of a name, for files whose beginning tells nothing.
std::string_view foreign_kind_of_name(std::string_view name);

}  // namespace sphereview
