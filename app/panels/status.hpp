// The status line at the window's bottom, and messages over the picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "edit/document.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

// Work beside the window's loop.
struct WorkShown {
    std::string text;                // "Reading big.txt: 35 of 70 MB"
    std::optional<double> fraction;  // 0..1, if known
    bool can_cancel = false;
};

struct Messages {
    std::string announcement;  // "Saved /home/a/b.png"; removed by the owner after a while
    std::string scene_error;   // FILE:LINE:COLUMN: ... while the file is broken
    std::string shader_error;  // the log, while a shader is broken
    std::optional<WorkShown> work{};
    std::optional<WorkShown> film{};  // may take hours: shown out of the way
    std::string hint{};               // shown while there is no announcement
    std::string scene_gone{};         // about the scene's file, while it is missing
};

// The sizes of the marks in the lower corners and in the upper right one, in ImGui's coordinates.
struct CornerMarks {
    ImVec2 left{};
    ImVec2 right{};
    ImVec2 legend{};
};

// Draws windows inside the picture's `area`, and removes the errors that the person closes. An announcement stands above the marks.
// The log is in the second font of ImGui's atlas, a monospaced one, if there is one. Widgets: "message announcement", also for the
// hint, "message scene error", "message shader error", "message scene gone", "close scene error", "close shader error", "close
// scene gone", "message work", "cancel work", "message film", "cancel film".
struct CancelledWork {
    bool work = false;
    bool film = false;
};
CancelledWork draw_messages(const PanelContext& context, Messages& messages, const Rectangle& area, const CornerMarks& marks = {});

struct Status {
    std::string renderer;        // "llvmpipe (LLVM 15.0.6, 256 bits)"
    double trace_seconds = 0.0;  // of the last trace
    int step = 1;                // of the picture; above 1: coarse
    std::optional<Pixel> pixel;  // under the pointer
    PictureSize size;
    std::optional<std::uint32_t> sphere;    // the sphere that the pixel shows
    std::vector<std::string> properties{};  // the properties to tell of that sphere, in any letter case
};

// Draws into the current ImGui window, one line high. Columns stay in place while numbers change.
void draw_status_bar(const PanelContext& context, const Status& status);

}  // namespace sphereview
