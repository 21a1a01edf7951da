// A scene as both renderers take it: floats relative to the eye, only what is drawn.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// The spheres that are not hidden, in file order.
struct DrawnSpheres {
    std::vector<glm::vec4> center_radius;  // centre relative to the eye (subtracted in double), radius
    std::vector<std::int32_t> numbers;     // their numbers in the scene; empty when nothing is hidden: i is i
};

DrawnSpheres drawn_spheres(const Scene& scene);

// Turns indices among the drawn spheres into numbers in the scene; visible_background stays.
void to_scene_numbers(const DrawnSpheres& spheres, std::span<std::int32_t> visible);

// How many spheres of the scene are drawn.
std::size_t count_drawn(const Scene& scene);

// The rays of a picture: pixel (x, y) looks along forward + across right + upward up, with the whole numbers of
// ray_coefficients(). Scaled so that the largest component of `forward` lies in [0.5, 1).
struct RayFrame {
    glm::vec3 forward;
    glm::vec3 right;
    glm::vec3 up;
};

RayFrame ray_frame(const Camera& camera, PictureSize size);

}  // namespace sphereview
