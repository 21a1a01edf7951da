// One pixel's visible sphere by exact roots alone, one sphere after the other.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "exact/exact_decision.hpp"
#include "exact/visible.hpp"

namespace sphereview {

// A sphere that a pixel may show.
struct Contender {
    std::int32_t number;  // ties are won by the lower one
    const Sphere* sphere;
};

// The number of the contender whose smallest positive root is smallest, or visible_background when none has one.
inline std::int32_t decide_exactly(const Camera& camera, PictureSize size, Pixel pixel, std::span<const Contender> contenders) {
    const ExactRay ray(camera, size, pixel);
    std::int32_t visible = visible_background;
    std::optional<ExactRoot> nearest;
    for (const Contender& contender : contenders) {
        auto root = ray.hit(*contender.sphere);
        if (!root) continue;
        const int order = nearest ? compare(*root, *nearest) : -1;
        if (order < 0 || (order == 0 && contender.number < visible)) {
            nearest = std::move(root);
            visible = contender.number;
        }
    }
    return visible;
}

}  // namespace sphereview
