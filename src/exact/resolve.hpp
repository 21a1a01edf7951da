// Decides what float could not: in double with its own bound, then exactly.
#pragma once

#include <cstdint>
#include <span>

#include "exact/drawn.hpp"
#include "exact/rays.hpp"
#include "exact/visible.hpp"

namespace sphereview {

// How many pixels were decided at each level.
struct DecisionCounts {
    std::int64_t in_float = 0;
    std::int64_t in_double = 0;
    std::int64_t exactly = 0;

    DecisionCounts& operator+=(const DecisionCounts& other);
};

enum class DecisionLevel { in_float, in_double, exactly };

// What it takes to decide a pixel: float with the bound assumed of GPUs, double, or exact integers.
DecisionLevel decision_level(const Scene& scene, const DrawnSpheres& drawn, PictureSize size, Pixel pixel);

// Turns what a renderer wrote into the numbers of the exact picture. The scene and its drawn spheres must outlive it.
class Resolver {
public:
    Resolver(const Scene& scene, const DrawnSpheres& drawn, PictureSize size);

    // The number in the scene of the sphere that the pixel shows, or visible_background; `level` says what it took.
    std::int32_t resolve(Pixel pixel, DecisionLevel& level) const;

    // Certifies a block: indices among the drawn spheres become numbers in the scene, doubtful pixels are resolved.
    DecisionCounts certify(const Block& block, std::span<std::int32_t> visible) const;

    // Only turns indices, best guesses included, into numbers in the scene.
    void accept_guesses(std::span<std::int32_t> visible) const;

private:
    const Scene& scene_;
    const DrawnSpheres& drawn_;
    PictureSize size_;
    RayFrame<double> frame_;
    double error_scale_;
};

}  // namespace sphereview
