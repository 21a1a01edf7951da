// Any shading of a picture, on the CPU: an export's pixels. Twin: shaders/surface.frag.
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

// An image for a scene's picture: RGBA where the background is transparent, else RGB.
Image make_picture(PictureSize size, const Background& background);

// Distances of hits are eighths of the scene's, so that no sum or difference of its doubles overflows.
inline constexpr double shading_scale = 0.125;

// What the hits of a scene lie between, as far from where their rays begin. In perspective it depends on the eye alone: it is the
// same in every direction that it may look.
struct DepthRange {
    double nearest = 0.0;
    double farthest = 1.0;

    bool operator==(const DepthRange&) const = default;
};

// Of all spheres that are not hidden. At least 1/256 of `farthest` wide: narrower, float could not tell what lies where.
DepthRange depth_range(const Scene& scene, const Camera& camera);

// A part, 0..1, of a light's sky that counts as if nothing were in its way: of drafts.
struct FreeSky {
    Light light{};
    double part = 0.0;
};

// The bytes are the same on every machine and of every compiler: double precision, only
// + - * / and square roots, never contracted or reordered; flat colours are what the scene says, byte for byte. What a colour is
// made of is in docs/shading.md.
class PictureShader {
public:
    // Of the scene as the camera sees it. The scene must outlive it.
    PictureShader(const Scene& scene, const Camera& camera, PictureSize size, Shading shading, const Background& background);

    // Colours one block of the picture from its visible spheres (scene numbers or visible_background), row by row. `picture` may be
    // a part of the whole: its top left pixel is `origin` of that. `light`: of each pixel of the block, for the shading `studio`;
    // else empty. `free` is added to it.
    void shade(const Block& block, std::span<const std::int32_t> visible, Image& picture, Pixel origin = {},
               std::span<const LightVector> light = {}, const FreeSky& free = {}) const;

    // Of one pixel.
    Color color(Pixel pixel, std::int32_t visible, const LightVector& light = {}) const;

private:
    void shade_row(int x, int y, std::span<const std::int32_t> visible, std::span<const LightVector> light, const FreeSky& free,
                   std::uint8_t* out, std::size_t channels) const;
    // The power of two that the scene's lengths are multiplied by where they are a sphere's hits'.
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
