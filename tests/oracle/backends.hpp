// The pictures of the backends, as numbers of visible spheres.
#pragma once

#include <cstdint>
#include <vector>

#include "app/backend.hpp"
#include "exact/resolve.hpp"
#include "image/image.hpp"
#include "oracle/difference.hpp"

namespace sphereview::oracle {

// Those that are compared: SPHEREVIEW_BACKENDS ("cpu,egl"), or all of this system.
std::vector<Backend> tested_backends();

// Costs with which scenes of a few thousand spheres already have tiles of several sizes.
TileCosts with_small_budget(TileCosts costs);

// One at a time in a process.
OpenBackend opened(Backend backend);

// The flat picture, as an export makes it.
Image flat_picture(OpenBackend& backend, const Scene& scene, PictureSize size, bool certify = true,
                   DecisionCounts* counts = nullptr);

// For each pixel the number of the visible sphere or -1, read from a flat picture that numbers the spheres by colours.
std::vector<std::int32_t> visible_spheres(OpenBackend& backend, const Trial& trial, bool certify = true,
                                          DecisionCounts* counts = nullptr);

}  // namespace sphereview::oracle
