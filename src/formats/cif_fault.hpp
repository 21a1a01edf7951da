// Where in a text of CIF is what gemmi finds wrong with it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "formats/lines.hpp"

namespace sphereview {

// gemmi's message "NAME:LINE in data_BLOCK: ..." or "NAME: ...", as "NAME:LINE:COLUMN: found ..., expected ...". A message that has
// a column, and one whose words are not in the text, stays as it is.
std::string placed_cif_fault(const TextSource& source, const std::string& message);

// Where a word of a loop or of a pair stands, which begins in that line, from 1: the first of its tags, of which there is one or
// more, is number 0, and the values come behind the tags. npos where it is not found.
std::size_t place_of_cif_word(std::string_view text, std::size_t line, std::span<const std::string> tags, std::size_t number);

}  // namespace sphereview
