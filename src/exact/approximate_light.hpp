// Whether a light shines on what a pixel shows, in 106 bits with bounds: the level between double and exact/exact_light.hpp.
// docs/exactness.md, "Light".
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "exact/nearest_hit.hpp"

namespace sphereview {

// How many of some points lie in a sphere's shadow.
enum class Shadow : std::uint8_t { none, unsure, all };

// Where a pixel's ray hits the sphere that it shows.
class ApproximateLitPoint {
public:
    // `side`: of the eye, or of the ray's origin, seen from the sphere. The references must outlive this object.
    ApproximateLitPoint(const Camera& camera, const ExactBasis& basis, PictureSize size, Pixel pixel, const Sphere& sphere,
                        EyeSide side);

    // The sign of n.L, with the normal turned to the eye; nothing when 106 bits are not enough.
    std::optional<int> facing(const glm::dvec3& direction) const;

    // Whether `other`, which must not contain the eye, blocks the light; `unsure` when 106 bits are not enough.
    Shadow shadow(const Sphere& other, const glm::dvec3& direction) const;

private:
    Shadow shadow_of(const ScaledSphere& other, const NearestHit& hit, const glm::dvec3& direction) const;

    const Camera& camera_;
    const ExactBasis& basis_;
    PictureSize size_;
    Pixel pixel_;
    const Sphere& sphere_;
    EyeSide side_;
    bool outside_;    // the ray begins outside the sphere
    double largest_;  // the size that scale_ is for
    SphereScale scale_;
    NearestHit hit_;
};

// All points within `error` of `point`, which is relative to the eye; both are the scene's times 2^exponent.
struct PointBall {
    glm::dvec3 point{0.0};
    double error = 0.0;
    int exponent = 0;
};

// The same for all points of a ball, none of which is inside the sphere.
Shadow approximate_shadow(const PointBall& ball, const glm::dvec3& eye, const Sphere& other, const glm::dvec3& direction);

}  // namespace sphereview
