// A lit picture before there is an exact one, of what the window shows already.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "app/render_picture.hpp"

namespace sphereview {

// What is asked for instead of the picture: one sample a pixel, and no more lights than a draft needs.
PictureOptions draft_options(const Scene& scene, PictureOptions options);

// Lights the picture whose pixels show these spheres: numbers or visible_background, doubtful guesses marked, row by row. Calls
// show() as light is added; `kept` is given which lights shine where.
Image lit_draft(const Scene& scene, const PictureOptions& options, std::span<const std::int32_t> seen,
                const std::function<void(Image)>& show, KeptLight* kept = nullptr);

}  // namespace sphereview
