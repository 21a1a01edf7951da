// Recognises texts that no format here reads by several of their lines.
#pragma once

#include <string_view>

namespace sphereview {

// The kind in words, as of foreign_kind(); "" if unknown. `text`: the beginning of a file. `code`: the same behind comments.
std::string_view kind_of_lines(std::string_view text, std::string_view code);

}  // namespace sphereview
