// An X server without a screen, for one test, and what xdotool cannot do there.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "support/picture.hpp"
#include "support/program.hpp"

namespace sphereview::test {

struct ScreenOptions {
    int width = 1000;  // a wider picture takes software longer and shows no more
    int height = 800;
    int dpi = 96;  // of text (the resource Xft.dpi); twice as many: text is twice as large
};

// Xvfb on a display of its own, until destruction.
class XServer {
public:
    explicit XServer(const ScreenOptions& options = {});

    // ":99"
    const std::string& display() const { return display_; }
    // As a crash would.
    void kill();
    void hang();  // answers nothing any more
    // What the screen shows, RGB.
    Picture screen() const;
    // How many pixels the program's window gives as its icons, all of them together.
    std::size_t icon_pixels() const;
    // What a window manager sends to the program's window when its close button is pressed (WM_DELETE_WINDOW).
    void press_close_button() const;
    // Drags files from another program's window to (x, y) in the program's and drops them (XDND, version 5). Returns whether
    // the window accepted and took them.
    bool drop(const std::vector<std::string>& paths, int x, int y) const;

private:
    std::unique_ptr<Running> xvfb_;
    std::string display_;
};

}  // namespace sphereview::test
