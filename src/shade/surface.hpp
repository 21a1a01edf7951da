// Where a ray meets a sphere that it is known to hit: what colours are made of. docs/shading.md. Twin: shaders/surface.frag.
#pragma once

#include <glm/vec3.hpp>

#include "exact/rays.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Lengths here are eighths of the scene's, so that no sum or difference of its doubles overflows.
inline constexpr double shading_scale = 0.125;

// What the hits of a scene lie between, seen from an eye: the same in every direction that it may look.
struct DepthRange {
    double nearest = 0.0;
    double farthest = 1.0;

    bool operator==(const DepthRange&) const = default;
};

// Of all spheres that are not hidden. At least 1/256 of `farthest` wide: narrower, float could not tell what lies where.
DepthRange depth_range(const Scene& scene, const glm::dvec3& eye);

// A sphere as its pixels need it.
struct ShadedSphere {
    glm::dvec3 center;  // relative to the eye
    double radius;
    double inverse_radius;
    double side;  // 1: the eye is outside and sees the near root; -1: inside or on the surface, the far one
};

ShadedSphere shaded_sphere(const Sphere& sphere, const glm::dvec3& eye);

}  // namespace sphereview
