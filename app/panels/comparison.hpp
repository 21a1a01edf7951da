// What comparing somebody's own picture with the right one has found.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <string>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

struct ComparisonWords {
    std::string picture;                 // its file's name
    PictureSize size{};                  // of the picture
    std::string counts{};                // "1,234 of 10,000 pixels differ from the right picture."
    std::vector<std::string> verdict{};  // the likeliest mistake first; nothing for an equal picture
    struct Share {
        std::string words;
        std::int64_t pixels = 0;
        Color mark;  // in the picture of the difference
    };
    std::vector<Share> shares{};
    struct Example {
        Pixel pixel;
        std::string words;
    };
    std::vector<Example> examples{};
};

// As a window that fills `area`; its close button makes `open` false. `difference`: the picture of the
// difference as a texture of ImGui's, if it is there. A click on an example, or into the difference, pins that pixel and returns to
// the scene's own camera, which pictures are compared by. Widgets: "comparison", "difference", "example 0".
void draw_comparison(const PanelContext& context, const ComparisonWords& comparison, const ImTextureID* difference,
                     const Rectangle& area, bool& open);

}  // namespace sphereview
