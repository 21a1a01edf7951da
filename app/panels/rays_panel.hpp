// The panel of the rays in space: the eye's picture, the choice of rays, and what the pixel's ray meets.
#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "panels/panel_context.hpp"

namespace sphereview {

// The rays that are drawn besides a single pixel's: none, its row's, or the whole picture's.
enum class RaysShown { one, row, all };

// Every how many-th pixel's ray is drawn, in a row and in a column: powers of two.
struct RayChoice {
    RaysShown shown = RaysShown::one;
    int in_row = 1;      // for a row alone
    int in_picture = 1;  // for the whole picture

    int every() const { return shown == RaysShown::row ? in_row : in_picture; }
    bool operator==(const RayChoice&) const = default;
};

// What the panel shows.
struct RaysFacts {
    PictureSize size{};                    // of the eye's picture
    std::optional<ImTextureID> picture{};  // the eye's picture, once made; of any size of the same shape
    std::optional<glm::dvec2> place{};     // of the drawn ray's pixel, from the picture's top left corner
    bool pinned = false;                   // the pixel is pinned; else it follows the pointer
    std::string meets{};                   // what the ray meets, in words
    std::string light{};                   // whether the sun shines there; "" without a sun
    std::size_t rays = 0;                  // number of rays drawn besides
    std::size_t hits = 0;                  // number of those that end on a sphere
    int least_every = 1;                   // bounds of RayChoice::every()
    int most_every = 1;
};

struct RaysAnswer {
    std::optional<Pixel> pointed{};  // the pixel of the eye's picture under the pointer
    bool clicked = false;
    bool beside = false;      // with Shift
    ImVec2 size{0.0F, 0.0F};  // of the panel
};

// Draws a window in the upper left corner of the picture's `area`. Widgets: "rays", "rays picture", "rays one", "rays row", "rays
// all", "rays finer", "rays coarser", "rays end".
RaysAnswer draw_rays_panel(const PanelContext& context, const RaysFacts& facts, RayChoice& choice, const Rectangle& area);

}  // namespace sphereview
