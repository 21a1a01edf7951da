// What xdotool cannot do: reading the screen, the close button, dropping files.
#pragma once

#include <string>
#include <vector>

#include "support/picture.hpp"

namespace sphereview::test {

// What a desktop's settings say of a screen: dots per inch for text (the resource Xft.dpi).
void set_text_resolution(const std::string& display, int dpi);

// What the screen shows, RGB.
Picture read_screen(const std::string& display);

// What a window manager sends when a window's close button is pressed (WM_DELETE_WINDOW), to the program's window.
void press_close_button(const std::string& display);

// Drags files from another program's window onto the program's window at (x, y) and drops them (XDND, version 5). Returns
// whether the window accepted and took them.
bool drop_files(const std::string& display, const std::vector<std::string>& paths, int x, int y);

}  // namespace sphereview::test
