// What the window tells: the line at its bottom, and messages over the picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "edit/document.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

// What goes on beside the window's loop.
struct WorkShown {
    std::string text;                // "Reading big.txt: 35 of 70 MB"
    std::optional<double> fraction;  // 0..1, where it is known
    bool can_cancel = false;
};

struct Messages {
    std::string announcement;  // "Saved /home/a/b.png"; the owner takes it away after a while
    std::string scene_error;   // FILE:LINE:COLUMN: ... while the file is broken; stays until it is not
    std::string shader_error;  // the log, while a shader is broken
    std::optional<WorkShown> work{};
    std::optional<WorkShown> film{};  // which may be made for hours: out of the way
    std::string hint{};               // shown where there is no announcement
    std::string scene_gone{};         // the scene's file, while it is not there
};

// How large what is drawn in the picture's corners is, from the corner on, in ImGui's coordinates: in the lower ones and in the
// upper right one.
struct CornerMarks {
    ImVec2 left{};
    ImVec2 right{};
    ImVec2 legend{};
};

// Draws windows of its own inside the area, which is the picture's, and takes away the errors that the person closes. What is
// announced stands above the marks that it would lie on. The log is in
// the second font of ImGui's atlas, if there is one: a monospaced one. Widgets: "message announcement", also for the hint, "message
// scene error", "message shader error", "message scene gone", "close scene error", "close shader error", "close scene gone",
// "message work", "cancel work", "message film", "cancel film".
struct CancelledWork {
    bool work = false;
    bool film = false;
};
CancelledWork draw_messages(const PanelContext& context, Messages& messages, const Rectangle& area, const CornerMarks& marks = {});

struct Status {
    std::string renderer;        // "llvmpipe (LLVM 15.0.6, 256 bits)"
    double trace_seconds = 0.0;  // of the last trace
    int step = 1;                // its grid; more than 1: coarse
    std::optional<Pixel> pixel;  // under the pointer
    PictureSize size;
    std::optional<std::uint32_t> sphere;    // that the pixel shows
    std::vector<std::string> properties{};  // whose values of that sphere are told, by name in any letter case
};

// Draws into the current ImGui window, one line high. Its columns stay where they are while numbers change.
void draw_status_bar(const PanelContext& context, const Status& status);

}  // namespace sphereview
