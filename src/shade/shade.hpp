// From visible spheres to colours, on the CPU: an export's pixels.
#pragma once

#include <cstdint>
#include <span>

#include "exact/visible.hpp"
#include "image/image.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// An image for a scene's picture: RGBA where the background is transparent, else RGB.
Image make_picture(PictureSize size, const Background& background);

// Colours one block of `picture` from its visible spheres (scene numbers or visible_background), row by row. Every colour
// is what the scene says, byte for byte.
void shade_flat(const Scene& scene, const Background& background, const Block& block, std::span<const std::int32_t> visible,
                Image& picture);

}  // namespace sphereview
