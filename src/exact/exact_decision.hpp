// The last word on visibility: exact integers on common powers of two. Nothing is rounded, nothing overflows.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "exact/exact_quadratic.hpp"
#include "exact/filter.hpp"
#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// On which side of the sphere's surface the eye lies.
EyeSide eye_side(const Sphere& sphere, const glm::dvec3& eye);

// A pixel's ray in integers. The ray has a power of two of its own, and so has each sphere with the eye: numbers are as long as
// these need, whatever else is in the scene.
class ExactRay {
public:
    ExactRay(const Camera& camera, PictureSize size, Pixel pixel);

    // Where it hits a sphere. Roots of one ray can be compared.
    std::optional<ExactRoot> hit(const Sphere& sphere) const;

private:
    glm::dvec3 eye_;
    IntegerVector direction_;
    Integer square_;
};

// A sphere that a pixel may show.
struct Contender {
    std::int32_t number;  // ties are won by the lower one
    const Sphere* sphere;
};

// The number of the contender whose smallest positive root is smallest, or visible_background when none has one.
std::int32_t decide_exactly(const Camera& camera, PictureSize size, Pixel pixel, std::span<const Contender> contenders);

}  // namespace sphereview
