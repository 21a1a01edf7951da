// Text for a font with ASCII alone.
#pragma once

#include <string>
#include <string_view>

namespace sphereview {

// Replaces letters with accents by those without, a few signs by words ("deg", "u" for micro), and other characters by "?".
// Characters that are not printed are left out.
std::string in_ascii(std::string_view text);

}  // namespace sphereview
