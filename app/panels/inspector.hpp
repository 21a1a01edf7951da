// The pixel inspector: the arithmetic of the pixel under the pointer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "exact/explain.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

// All that an explanation depends on.
struct InspectedPlace {
    Pixel pixel;
    PictureSize size;  // of the picture that the pixel is in
    Camera camera;     // of the view
    std::uint64_t revision = 0;
    std::optional<Sun> sun{};  // in the shading that shows light

    bool operator==(const InspectedPlace&) const = default;
};

struct InspectedPixel {
    InspectedPlace place;
    PixelExplanation explanation;
    bool sun_shines = false;
    std::string sun{};  // whether it shines and why not, in words; "" where nothing is lit
};

// Draws into the current ImGui window. `pixel` is empty when the pointer is not in the picture.
void draw_inspector(const PanelContext& context, const std::optional<InspectedPixel>& pixel);

}  // namespace sphereview
