// Text for a font that has ASCII alone.
#pragma once

#include <string>
#include <string_view>

namespace sphereview {

// Letters without their accents, a few signs in other words ("deg", "u" for micro), and "?" for each other character. What is not
// printed is left out.
std::string in_ascii(std::string_view text);

}  // namespace sphereview
