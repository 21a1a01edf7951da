// Any shading of a picture, on the CPU: an export's pixels.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "exact/visible.hpp"
#include "image/image.hpp"
#include "shade/shading.hpp"
#include "shade/surface.hpp"

namespace sphereview {

// An image for a scene's picture: RGBA where the background is transparent, else RGB.
Image make_picture(PictureSize size, const Background& background);

// The bytes are the same on every machine and of every compiler: double precision, only
// + - * / and square roots, never contracted or reordered; flat colours are what the scene says, byte for byte. What a colour is
// made of is in docs/shading.md.
class PictureShader {
public:
    // Of the scene as the camera sees it. The scene must outlive it.
    PictureShader(const Scene& scene, const Camera& camera, PictureSize size, Shading shading, const Background& background);

    // Colours one block of the picture from its visible spheres (scene numbers or visible_background), row by row. `picture` may be
    // a part of the whole: its top left pixel is `origin` of that.
    void shade(const Block& block, std::span<const std::int32_t> visible, Image& picture, Pixel origin = {}) const;

    // Of one pixel.
    Color color(Pixel pixel, std::int32_t visible) const;

private:
    std::array<std::uint8_t, 4> pixel_of(std::int32_t number) const;
    void shade_row(int x, int y, std::span<const std::int32_t> visible, std::uint8_t* out, std::size_t channels) const;

    const Scene& scene_;
    glm::dvec3 eye_;
    PictureSize size_;
    Shading shading_;
    Background background_;
    RayBasis<double> rays_;
    CameraAxes axes_;
    DepthRange range_;
    double inverse_range_ = 1.0;
};

}  // namespace sphereview
