// How much room a scene takes up.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace sphereview {

// What the spheres that are not hidden take up. Of an empty scene: what the default screen shows at z = 200.
struct SceneBounds {
    glm::dvec3 low{-100.0, -100.0, 100.0};
    glm::dvec3 high{100.0, 100.0, 300.0};
    double largest_radius = 20.0;
    std::size_t hidden = 0;  // how many spheres are

    glm::dvec3 middle() const { return 0.5 * low + 0.5 * high; }
    // The longest side, but not less than the largest sphere: more than 0, and finite.
    double extent() const;
};
SceneBounds bounds_of(const Scene& scene);

}  // namespace sphereview
