// The panel beside the rays in space: what the eye sees, which of its rays are drawn, and what the pixel's ray meets.
#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "panels/panel_context.hpp"

namespace sphereview {

// Which rays are drawn besides a single pixel's: of its row, or of the whole picture.
enum class RaysShown { one, row, all };

// Each so many-th pixel's ray of a row, and of a column: powers of two.
struct RayChoice {
    RaysShown shown = RaysShown::one;
    int in_row = 1;      // of a row alone
    int in_picture = 1;  // of the whole picture

    int every() const { return shown == RaysShown::row ? in_row : in_picture; }
    bool operator==(const RayChoice&) const = default;
};

// What the panel shows.
struct RaysFacts {
    PictureSize size{};                    // of the picture that the eye sees
    std::optional<ImTextureID> picture{};  // that picture, once it is made; of any size of the same shape
    std::optional<glm::dvec2> place{};     // of the pixel whose ray is drawn, in pixels from the picture's top left corner
    bool pinned = false;                   // that pixel; else it follows the pointer
    std::string meets{};                   // what its ray meets, in words
    std::string light{};                   // and whether the sun shines there; "" where no sun does
    std::size_t rays = 0;                  // so many are drawn besides,
    std::size_t hits = 0;                  // and so many of them end on a sphere
    int least_every = 1;                   // how near to each other they may be
    int most_every = 1;
};

struct RaysAnswer {
    std::optional<Pixel> pointed{};  // the pixel of the eye's picture under the pointer
    bool clicked = false;
    bool beside = false;      // with Shift
    ImVec2 size{0.0F, 0.0F};  // of the panel
};

// Draws a window in the upper left corner of the area, which is the picture's. Widgets: "rays", "rays picture", "rays one", "rays
// row", "rays all", "rays finer", "rays coarser", "rays end".
RaysAnswer draw_rays_panel(const PanelContext& context, const RaysFacts& facts, RayChoice& choice, const Rectangle& area);

}  // namespace sphereview
