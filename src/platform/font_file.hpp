// A readable system font.
#pragma once

#include <string>

namespace sphereview {

enum class FontFamily {
    sans_serif,
    monospaced  // all letters equally wide: for columns
};

// The file of the system's usual font that ImGui can read (TrueType or OpenType outlines, not a collection's later face), by
// fontconfig, or Windows' font of menus; "" for none.
std::string system_font_file(FontFamily family = FontFamily::sans_serif);

}  // namespace sphereview
