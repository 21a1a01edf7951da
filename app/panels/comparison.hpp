// The result of comparing somebody's own picture with the right one.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <optional>
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
    std::function<std::string(Pixel)> at{};  // a pixel's found and expected colour; none for an equal picture
};

// The picture that is shown.
enum class ComparedPicture { difference, found, right };

struct ComparisonView {
    bool open = true;
    ComparedPicture picture = ComparedPicture::difference;
};

// Draws a window that fills `area`; its close button makes `view.open` false. `picture`: a texture of `view.picture`, if there is
// one, in which the examples are marked. A click on an example, or into the picture, pins that pixel and returns to the scene's own
// camera, by which pictures are compared. `pinned`: a pixel whose found and expected colour is shown. Widgets: "comparison",
// "difference" (whichever picture is shown), "show difference", "show found", "show right", "example 0".
void draw_comparison(const PanelContext& context, const ComparisonWords& comparison, const ImTextureID* picture,
                     std::optional<Pixel> pinned, const Rectangle& area, ComparisonView& view);

}  // namespace sphereview
