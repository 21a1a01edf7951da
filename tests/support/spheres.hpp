// Scenes by their spheres.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

inline Scene scene_of(std::vector<Sphere> spheres) {
    Scene scene;
    scene.spheres = std::move(spheres);
    return scene;
}

// So many, all alike.
inline Scene scene_of_alike(std::size_t count) { return scene_of(std::vector<Sphere>(count)); }

using Centers = std::vector<glm::dvec3>;

inline Centers centers_of(const Scene& scene) {
    Centers centers;
    for (const Sphere& sphere : scene.spheres) centers.push_back(sphere.center);
    return centers;
}

}  // namespace sphereview
