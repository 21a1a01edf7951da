// The coarse grid that stands for a picture while it moves.
#pragma once

#include <algorithm>
#include <bit>

#include "exact/candidates.hpp"
#include "scene/camera.hpp"

namespace sphereview {

// One pixel of each step x step pixels is traced: a texel of the grid. `step` is a power of two, 1 for the picture itself.
// A camera that moves through many spheres makes lists for the traced pixels alone: most small spheres are missed by all of
// them, so that lists, uploads and drawing shrink with the grid.
struct PixelGrid {
    PictureSize picture;
    int step = 1;

    int shift() const { return std::countr_zero(static_cast<unsigned>(step)); }
    PictureSize size() const { return {side(picture.width), side(picture.height)}; }

    // The column of the pixel that is traced for a column of texels; the same for rows. Twin: shaders/trace.frag.
    int traced_column(int texel) const { return traced(texel, picture.width); }
    int traced_row(int texel) const { return traced(texel, picture.height); }

    // The texels whose pixels are in the range.
    PixelRange texels(const PixelRange& pixels) const {
        return {first(pixels.left), first(pixels.top), last(pixels.right, picture.width), last(pixels.bottom, picture.height)};
    }

    // The pixels for which these texels stand.
    PixelRange pixels(const PixelRange& texels) const {
        if (texels.empty()) return {};
        return {texels.left * step, texels.top * step, std::min((texels.right + 1) * step, picture.width) - 1,
                std::min((texels.bottom + 1) * step, picture.height) - 1};
    }

private:
    int side(int count) const { return (count + step - 1) / step; }
    int traced(int texel, int count) const { return std::min(texel * step + step / 2, count - 1); }
    int first(int pixel) const { return (pixel - step / 2 + step - 1) >> shift(); }
    // At the picture's edge the last texel's pixel may be nearer than a step.
    int last(int pixel, int count) const { return pixel == count - 1 ? side(count) - 1 : (pixel - step / 2) >> shift(); }
};

}  // namespace sphereview
