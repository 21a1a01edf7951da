// What an empty window offers: files, examples, and what to try first.
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
    std::vector<ExampleScene> examples;  // in the order that they are offered
    int chosen = -1;                     // the row that Enter takes, as the arrow keys move it; -1: none yet
};

// The examples that are there: in PREFIX/share/sphereview/scenes of an installed program, or in `scenes` of a folder above one that
// was built and not installed.
std::vector<ExampleScene> example_scenes();

// How wide a picture the page asks for.
float start_page_room(const PanelContext& context);

// Draws a window of its own in the middle of `area`, which is the picture's. Its rows are clicked, or chosen with the arrow keys
// and taken with Enter where `has_keys`. Widgets: "start page", "start open", "start recent 0", "start example 0", "start command
// 0".
void draw_start_page(const PanelContext& context, StartPage& page, const std::vector<std::string>& recent, const Rectangle& area,
                     bool has_keys);

}  // namespace sphereview
