// A readable system font.
#pragma once

#include <string>

namespace sphereview {

// The file of the system's usual sans-serif font that ImGui can read (TrueType or OpenType outlines, not a collection's later
// face), by fontconfig; "" where there is no fontconfig or no such font.
std::string system_font_file();

}  // namespace sphereview
