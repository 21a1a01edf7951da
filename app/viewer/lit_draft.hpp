// A lit picture before there is an exact one, of what the window shows already.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "app/render_picture.hpp"

namespace sphereview {

// Lights the picture whose pixels show these spheres: numbers or visible_background, doubtful guesses marked, row by row. With one
// sample a pixel, whatever the options say, and with no more lights than a draft needs. Calls show() as light is added.
Image lit_draft(const Scene& scene, const PictureOptions& options, std::span<const std::int32_t> seen,
                const std::function<void(Image)>& show);

}  // namespace sphereview
