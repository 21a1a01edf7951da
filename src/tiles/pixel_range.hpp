// The pixels that a sphere can cover, conservatively. Only the centres of pixels count: a sphere smaller than a pixel is listed
// only where a ray can hit it. Derivation: docs/exactness.md, "Tiles".
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "exact/candidates.hpp"
#include "scene/camera.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

// The coarse grid that stands for a picture while it moves. One pixel of each step x step pixels is traced: a texel of the grid.
// `step` is a power of two, 1 for the picture itself. A camera that moves through many spheres makes lists for the traced pixels
// alone: most small spheres are missed by all of them, so that lists, uploads and drawing shrink with the grid.
struct PixelGrid {
    PictureSize picture;
    int step = 1;

    // A picture itself is the grid of its pixels.
    PixelGrid(PictureSize of = {}, int traced_step = 1) : picture(of), step(traced_step) {}

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

// The rays of all pixels with number i on this axis lie in a plane; a = 2i + 1 - count. Perspective: the plane goes through the eye
// and has the normal base + a step, which points towards greater i. Orthographic: the normal is `base` for all, and the plane's
// points P, relative to the eye, have P.base = -a shift, where shift is below 0.
struct PixelAxis {
    glm::dvec3 base{0.0};
    glm::dvec3 step{0.0};
    double shift = 0.0;
    double base_base = 0.0;  // the scalar products, for the length of the normal
    double base_step = 0.0;
    double step_step = 0.0;
    int count = 0;
};

// The planes through the rays of each column and row of pixels.
class PixelPlanes {
public:
    // `scale`: the drawn spheres'.
    PixelPlanes(const Camera& camera, PictureSize size, int scale);

    // A range outside which no ray through a pixel's centre hits the sphere, a member of DrawnSpheres::center_radius.
    PixelRange range(const glm::vec4& sphere) const;

    // A lower bound on the distance of the sphere's hits from their rays' origins.
    float nearest_distance(const glm::vec4& sphere) const {
        constexpr double tolerance = 0x1p-21;  // of |x| + |y| + |z| + r, for the rounding to float of the input and of the result
        if (sphere.w == 0.0F) return 0.0F;     // the eye on the surface: the sphere may be hit right before it
        const glm::dvec3 center(sphere);
        const double radius = std::fabs(static_cast<double>(sphere.w));
        const double all = taxicab_length(center) + radius + reach_;
        const double nearest = orthographic_ ? nearest_depth(sphere) : std::fabs(glm::length(center) - radius);
        return static_cast<float>(std::max(0.0, nearest - tolerance * all));
    }

    // The range of each sphere, many at a time. `ranges` has as many places.
    void ranges(std::span<const glm::vec4> spheres, std::span<PixelRange> ranges) const;

private:
    double nearest_depth(const glm::vec4& sphere) const;  // of an orthographic picture

    PixelAxis columns_;
    PixelAxis rows_;
    glm::dvec3 view_{0.0};  // of length 1; every ray has a positive product with it
    bool orthographic_ = false;
    double reach_ = 0.0;  // of the rays' origins (RayBasis)
    bool usable_ = true;  // false: nothing is known, every range is the whole picture
};

}  // namespace sphereview
