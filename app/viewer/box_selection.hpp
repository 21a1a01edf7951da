// Selects the spheres that are seen in a box of the picture. Finding them exactly may take seconds, so a job beside the loop does
// it; nearly always it is done within the same redraw.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/visible.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct ViewerState;

// The numbers of the spheres that the block's pixels show, ascending. The block must lie in the picture.
std::vector<std::uint32_t> spheres_seen(const Scene& scene, const Camera& camera, PictureSize size, const Block& block);

// Selects what is seen in the block of the window's picture, now or later (state.selecting); not if the selection or the numbers
// change meanwhile. Ends an earlier call's job.
void select_seen(ViewerState& state, const Block& block, bool toggles);

}  // namespace sphereview
