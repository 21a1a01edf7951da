// Shades the pixels of exports on the CPU. Twin: shaders/surface.frag.
#pragma once

#include <cstdint>
#include <span>

#include "exact/exact_decision.hpp"
#include "exact/rays.hpp"
#include "exact/visible.hpp"
#include "image/image.hpp"
#include "light/light_set.hpp"
#include "scene/scene.hpp"
#include "shade/shading.hpp"

namespace sphereview {

// An image for a picture: RGBA with a transparent background, else RGB.
Image make_picture(PictureSize size, const Background& background);

// Distances of hits are in eighths, so that no sum or difference of the scene's doubles overflows.
inline constexpr double shading_scale = 0.125;

// The range of the hits' distances from the rays' origins. In perspective it depends on the eye alone, not on the view's direction.
struct DepthRange {
    double nearest = 0.0;
    double farthest = 1.0;

    bool operator==(const DepthRange&) const = default;
};

// The range of all shown spheres, at least 1/256 of `farthest` wide: float could not resolve a narrower one.
DepthRange depth_range(const Scene& scene, const Camera& camera);

// For drafts: a part, 0..1, of a light's sky that counts as free of shadows.
struct FreeSky {
    Light light{};
    double part = 0.0;
};

// The bytes are the same on every machine and of every compiler: double precision, only + - * / and square roots, never contracted
// or reordered; flat colours are what the scene says, byte for byte. docs/shading.md has the formulae.
class PictureShader {
public:
    // The scene must outlive this object.
    PictureShader(const Scene& scene, const Camera& camera, PictureSize size, Shading shading, const Background& background);

    // Colours one block of the picture from its visible spheres (scene numbers or visible_background), row by row. `picture` may be
    // a part of the whole: its top left pixel is `origin` of that. `light`: of each pixel of the block, for the shading `studio`;
    // else empty. `free` is added to it.
    void shade(const Block& block, std::span<const std::int32_t> visible, Image& picture, Pixel origin = {},
               std::span<const LightVector> light = {}, const FreeSky& free = {}) const;

    // The colour of one pixel.
    Color color(Pixel pixel, std::int32_t visible, const LightVector& light = {}) const;

private:
    void shade_row(int x, int y, std::span<const std::int32_t> visible, std::span<const LightVector> light, const FreeSky& free,
                   std::uint8_t* out, std::size_t channels) const;
    // The power of two that a sphere's lengths are multiplied by.
    int scale_for(const Sphere& sphere) const;

    const Scene& scene_;
    Camera camera_;
    EyeSides sides_;
    PictureSize size_;
    Shading shading_;
    Background background_;
    int scale_;              // of lengths, as a power of two, for most spheres
    RayBasis<double> rays_;  // in that scale
    CameraAxes axes_;
    DepthRange range_;
    double inverse_range_ = 1.0;
};

}  // namespace sphereview
