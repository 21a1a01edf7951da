// Decides the pixels that float could not: in double with its own bound, then exactly.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "exact/candidates.hpp"
#include "exact/drawn.hpp"
#include "exact/nearest_hit.hpp"
#include "exact/rays.hpp"
#include "exact/visible.hpp"

namespace sphereview {

// How many pixels were decided at each level.
struct DecisionCounts {
    std::int64_t in_float = 0;
    std::int64_t in_double = 0;
    std::int64_t exactly = 0;
    std::int64_t integer_tests = 0;  // tests of spheres that 106 bits could not decide

    DecisionCounts& operator+=(const DecisionCounts& other);
};

enum class DecisionLevel { in_float, in_double, exactly };

// The level that decides a pixel: float with the bound assumed of GPUs, double, or exact arithmetic. `lists`: as for Resolver.
DecisionLevel decision_level(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, Pixel pixel,
                             const CandidateLists* lists = nullptr);

// Turns a renderer's result into the numbers of the exact picture. The references must outlive this object.
class Resolver {
public:
    // With the picture's `lists` tries only the spheres that a pixel can show, else all.
    Resolver(const Scene& scene, const DrawnSpheres& drawn, PictureSize size, const CandidateLists* lists = nullptr);
    // The picture of another camera than the scene's.
    Resolver(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, const CandidateLists* lists);

    // The number of the sphere that the pixel shows, or visible_background. Sets `level`.
    std::int32_t resolve(Pixel pixel, DecisionLevel& level) const;

    // Certifies a block: indices among the drawn spheres become numbers in the scene, doubtful pixels are resolved. Calls
    // progress() with the finished part, 0..1, from this thread.
    DecisionCounts certify(const Block& block, std::span<std::int32_t> visible,
                           const std::function<void(double)>& progress = nullptr) const;

    // Turns indices, best guesses included, into numbers in the scene, and resolves nothing.
    void accept_guesses(std::span<std::int32_t> visible) const;

private:
    // Resolves at most 64 pixels of one cell, all in the same tiles.
    DecisionCounts resolve(std::span<const Pixel> pixels, std::span<std::int32_t> numbers) const;
    // The unit directions of the pixels' rays, and the origins relative to the eye. Returns whether they are as exact as
    // error_scale_ needs.
    bool aim(std::span<const Pixel> pixels, std::span<glm::dvec3> rays, std::span<glm::dvec3> origins) const;
    // Certifies a part of the block, at most as high as a cell.
    DecisionCounts certify_piece(const Block& piece, const Block& block, std::span<std::int32_t> visible) const;

    const Sphere& sphere(std::size_t index) const { return scene_.spheres[static_cast<std::size_t>(drawn_.number(index))]; }

    const Scene& scene_;
    const DrawnSpheres& drawn_;
    const Camera& camera_;
    const CandidateLists* lists_;
    PictureSize size_;
    RayBasis<double> basis_;
    double error_scale_;
    ExactBasis exact_basis_;
    int cell_shift_;  // a cell is a square of pixels that try the same spheres; its side is 2^this
};

}  // namespace sphereview
