// The last word on visibility: exact integers on a common power of two. Nothing is rounded, nothing overflows.
#pragma once

#include <cstdint>
#include <span>

#include "exact/filter.hpp"
#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// On which side of the sphere's surface the eye lies.
EyeSide eye_side(const Sphere& sphere, const glm::dvec3& eye);

// A sphere that a pixel may show.
struct Contender {
    std::int32_t number;  // ties are won by the lower one
    const Sphere* sphere;
};

// The number of the contender whose smallest positive root is smallest, or visible_background when none has one.
std::int32_t decide_exactly(const Camera& camera, PictureSize size, Pixel pixel, std::span<const Contender> contenders);

}  // namespace sphereview
