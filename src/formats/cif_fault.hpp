// Places of faults that gemmi finds in a CIF.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "formats/lines.hpp"

namespace sphereview {

// gemmi's message "NAME:LINE in data_BLOCK: ..." or "NAME: ..." as "NAME:LINE:COLUMN: found ..., expected ...". A message with a
// column, or whose words are not in the text, stays as it is.
std::string placed_cif_fault(const TextSource& source, const std::string& message);

// The place of a word of a loop or pair that begins in `line`, from 1. Words are numbered from 0: first the tags, one or more, then
// the values. npos if not found.
std::size_t place_of_cif_word(std::string_view text, std::size_t line, std::span<const std::string> tags, std::size_t number);

}  // namespace sphereview
