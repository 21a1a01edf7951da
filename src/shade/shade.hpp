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

// Colours one block of a picture from its visible spheres (scene numbers or visible_background), row by row. Every colour
// is what the scene says, byte for byte. `picture` may be a part of the whole: its top left pixel is `origin` of that.
void shade_flat(const Scene& scene, const Background& background, const Block& block, std::span<const std::int32_t> visible,
                Image& picture, Pixel origin = {});

}  // namespace sphereview
