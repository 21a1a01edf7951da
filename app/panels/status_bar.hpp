// The line at the bottom of the window, and messages over the picture.
#pragma once

#include <optional>
#include <string>

#include "panels/panel_context.hpp"

namespace sphereview {

struct Status {
    std::string renderer;        // "llvmpipe (LLVM 15.0.6, 256 bits)"
    double frame_seconds = 0.0;  // of the last traced frame
    int step = 1;                // its grid; more than 1: coarse
    std::optional<Pixel> pixel;  // under the pointer
    PictureSize size;
    std::optional<std::uint32_t> sphere;  // that the pixel shows
};

// Draws into the current ImGui window, one line high.
void draw_status_bar(const PanelContext& context, const Status& status);

// What is told over the picture.
struct Messages {
    std::string announcement;  // "Saved /home/a/b.png"; the owner takes it away after a while
    std::string scene_error;   // FILE:LINE:COLUMN: ... while the file is broken; stays until it is not
    std::string shader_error;  // the log, while a shader is broken
};

// Draws windows of its own inside the area (screen coordinates). Sets `dismissed` when the person closes the scene error.
struct MessageArea {
    float x = 0.0F;
    float y = 0.0F;
    float width = 0.0F;
    float height = 0.0F;
};
void draw_messages(const PanelContext& context, const Messages& messages, const MessageArea& area);

}  // namespace sphereview
