// A box in the picture selects the spheres that are seen in it. Which these are may take seconds of exact work, so it is found out
// beside the loop; where it takes no time, as nearly always, the selection is there in the same redraw.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/background_job.hpp"
#include "edit/selection.hpp"
#include "exact/visible.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct ViewerState;

// One under way.
struct BoxSelection {
    std::uint64_t revision;  // of the document whose numbers it finds
    Selection before;        // what was selected then
    bool toggles;            // that, instead of replacing it
    std::shared_ptr<std::vector<std::uint32_t>> numbers;
    BackgroundJob job;
};

// The numbers of the spheres that pixels of the block show, which lies in the picture; ascending.
std::vector<std::uint32_t> spheres_seen(const Scene& scene, const Camera& camera, PictureSize size, const Block& block);

// Selects what is seen in the block of the window's picture, now or later. Another one that is under way ends.
void select_seen(ViewerState& state, const Block& block, bool toggles);

// Selects what was found, if it has been, unless something else was selected meanwhile. Returns whether one ended.
bool finish_box_selection(ViewerState& state);

}  // namespace sphereview
