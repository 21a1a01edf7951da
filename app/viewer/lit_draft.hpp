// A quick lit picture of what the window shows already, before the exact one.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "app/render_picture.hpp"

namespace sphereview {

// The options of the draft: one sample a pixel, and fewer lights.
PictureOptions draft_options(const Scene& scene, PictureOptions options);

// Lights the picture whose pixels show the spheres `seen`: numbers or visible_background, doubtful guesses marked, row by row.
// Calls show() as light is added. `kept` gets which lights shine where.
Image lit_draft(const Scene& scene, const PictureOptions& options, std::span<const std::int32_t> seen,
                const std::function<void(Image)>& show, KeptLight* kept = nullptr);

}  // namespace sphereview
