// Whether a light shines on what a pixel shows, in exact integers: the signs of p + q sqrt(d). docs/light.md derives them.
#pragma once

#include <glm/vec3.hpp>

#include "exact/exact_quadratic.hpp"
#include "exact/filter.hpp"
#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// The two signs that decide whether a sphere blocks a light.
struct BlockingSigns {
    int along = 0;  // of m.L, with m from the sphere's centre to the point: negative if the centre lies towards the light
    int disc = 0;   // of (m.L)^2 - L.L (m.m - r^2): negative if the line to the light misses the sphere

    bool blocks() const { return along < 0 && disc >= 0; }
};

// Where a pixel's ray hits the sphere that it shows.
class ExactLitPoint {
public:
    // `side`: of the eye, or of the ray's origin, seen from the sphere. The references must outlive this object.
    ExactLitPoint(const Camera& camera, PictureSize size, Pixel pixel, const Sphere& sphere, EyeSide side);

    // The sign of n.L, with the normal turned to the eye.
    int facing(const glm::dvec3& direction) const;

    // `other`: must not contain the eye.
    BlockingSigns blocking(const Sphere& other, const glm::dvec3& direction) const;

private:
    // A m = v + root_sign sqrt(d) D, with m from a sphere's centre to the point.
    struct FromCenter {
        IntegerVector v;
        Integer d;
        Integer square_radius;  // times A^2, and the factor of the ray's origin, like m
    };
    FromCenter from_center_of(const Sphere& other) const;

    const Camera& camera_;
    PictureSize size_;
    Pixel pixel_;
    const Sphere& sphere_;
    int root_sign_;
    IntegerVector ray_;
    Integer square_;  // A = D.D
};

}  // namespace sphereview
