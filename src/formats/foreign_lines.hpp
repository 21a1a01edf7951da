// What a text is that no format here reads, where only several of its lines show it.
#pragma once

#include <string_view>

namespace sphereview {

// In words, as foreign_kind() has them; "" where that is not known. `text`: the beginning of a file. `code`: the same behind
// comments.
std::string_view kind_of_lines(std::string_view text, std::string_view code);

}  // namespace sphereview
