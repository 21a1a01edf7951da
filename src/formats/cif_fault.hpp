// Where in a text of CIF is what gemmi finds wrong with it.
#pragma once

#include <string>
#include <string_view>

#include "formats/lines.hpp"

namespace sphereview {

// gemmi's message "NAME:LINE in data_BLOCK: ..." or "NAME: ...", as "NAME:LINE:COLUMN: found ..., expected ...". A message that has
// a column, and one whose words are not in the text, stays as it is.
std::string placed_cif_fault(const TextSource& source, const std::string& message);

}  // namespace sphereview
