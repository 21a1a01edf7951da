// Decides what float could not: in double with its own bound, then exactly.
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
    std::int64_t integer_tests = 0;  // of spheres, for the pixels decided exactly: those that 106 bits could not tell apart

    DecisionCounts& operator+=(const DecisionCounts& other);
};

enum class DecisionLevel { in_float, in_double, exactly };

// What it takes to decide a pixel: float with the bound assumed of GPUs, double, or exact integers. `lists` as for Resolver.
DecisionLevel decision_level(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, Pixel pixel,
                             const CandidateLists* lists = nullptr);

// Turns what a renderer wrote into the numbers of the exact picture. What is passed in must outlive it.
class Resolver {
public:
    // With the lists of the picture it tries only the spheres that a pixel can show, without them all.
    Resolver(const Scene& scene, const DrawnSpheres& drawn, PictureSize size, const CandidateLists* lists = nullptr);
    // The picture that another camera than the scene's sees.
    Resolver(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, const CandidateLists* lists);

    // The number in the scene of the sphere that the pixel shows, or visible_background; `level` says what it took.
    std::int32_t resolve(Pixel pixel, DecisionLevel& level) const;

    // Certifies a block: indices among the drawn spheres become numbers in the scene, doubtful pixels are resolved.
    // Calls progress() now and then, from this thread, with the part that is done, 0..1.
    DecisionCounts certify(const Block& block, std::span<std::int32_t> visible,
                           const std::function<void(double)>& progress = nullptr) const;

    // Only turns indices, best guesses included, into numbers in the scene.
    void accept_guesses(std::span<std::int32_t> visible) const;

private:
    // Resolves some pixels of one cell: at most 64, all in the same tiles. It writes the number for each, and counts.
    DecisionCounts resolve(std::span<const Pixel> pixels, std::span<std::int32_t> numbers) const;
    // The pixels' unit directions, and where the rays begin, relative to the eye. Returns whether they are as exact as error_scale_
    // takes them to be.
    bool aim(std::span<const Pixel> pixels, std::span<glm::dvec3> rays, std::span<glm::dvec3> origins) const;
    // Certifies a part of the block that is no higher than a cell.
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
