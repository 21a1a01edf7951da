// The page in an empty window: files, examples, and things to try.
#pragma once

#include <string>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

// A scene that came with the program.
struct ExampleScene {
    std::string path;
    std::string title;  // "Planets"
};

struct StartPage {
    std::vector<ExampleScene> examples;  // in the page's order
    int chosen = -1;                     // the row for Enter, moved by the arrow keys; -1: none yet
};

// The examples in PREFIX/share/sphereview/scenes of an installed program, or in `scenes` of a folder above a built one.
std::vector<ExampleScene> example_scenes();

// The width of the picture that the page needs.
float start_page_room(const PanelContext& context);

// Draws a window in the middle of the picture's `area`. Rows are clicked, or, with `has_keys`, chosen with arrow keys and Enter.
// Widgets: "start page", "start open", "start recent 0", "start example 0", "start command 0".
void draw_start_page(const PanelContext& context, StartPage& page, const std::vector<std::string>& recent, const Rectangle& area,
                     bool has_keys);

}  // namespace sphereview
