// The pixel inspector: the arithmetic of the pixel under the pointer.
#pragma once

#include <optional>

#include "exact/explain.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

struct InspectedPixel {
    Pixel pixel;
    PictureSize size;              // of the picture that the pixel is in
    PixelExplanation explanation;  // for the camera of the view
};

// Draws into the current ImGui window. `pixel` is empty when the pointer is not in the picture.
void draw_inspector(const PanelContext& context, const std::optional<InspectedPixel>& pixel);

}  // namespace sphereview
