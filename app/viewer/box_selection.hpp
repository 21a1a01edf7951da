// A box in the picture selects the spheres that are seen in it. Which these are may take seconds of exact work, so it is found out
// beside the loop; where it takes no time, as nearly always, the selection is there in the same redraw.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/visible.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct ViewerState;

// The numbers of the spheres that pixels of the block show, which lies in the picture; ascending.
std::vector<std::uint32_t> spheres_seen(const Scene& scene, const Camera& camera, PictureSize size, const Block& block);

// Selects what is seen in the block of the window's picture, now or later (state.selecting), unless something else is selected or
// numbers become others meanwhile. Another one that is under way ends.
void select_seen(ViewerState& state, const Block& block, bool toggles);

}  // namespace sphereview
