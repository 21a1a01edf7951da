// The line at the bottom of the window.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "panels/messages.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

struct Status {
    std::string renderer;        // "llvmpipe (LLVM 15.0.6, 256 bits)"
    double frame_seconds = 0.0;  // of the last traced frame
    int step = 1;                // its grid; more than 1: coarse
    std::optional<Pixel> pixel;  // under the pointer
    PictureSize size;
    std::optional<std::uint32_t> sphere;  // that the pixel shows
    std::size_t hidden = 0;               // spheres: HiddenSpheres counts them
};

// Draws into the current ImGui window, one line high. Its columns stay where they are while numbers change.
void draw_status_bar(const PanelContext& context, const Status& status);

}  // namespace sphereview
