// What a file is that no format here reads.
#pragma once

#include <string_view>

namespace sphereview {

// In words for a message: "a JPEG picture" or "a GROMACS file", by what the file begins with; "" where that is not known. No file
// that a format here reads begins so: a format that is added takes its own line away.
std::string_view foreign_kind(std::string_view head);

}  // namespace sphereview
