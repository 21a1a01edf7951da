// A pixel's nearest hit so far, and whether another sphere's is nearer: in 106 bits (exact/approximate.hpp), then in integers.
// docs/exactness.md, "Differences".
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "exact/approximate.hpp"
#include "exact/exact_decision.hpp"
#include "exact/filter.hpp"
#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

using ApproximateVector = std::array<Approximate, 3>;

inline Approximate dot(const ApproximateVector& a, const ApproximateVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A number times 2^exponent. A result that may have lost bits becomes 0, with an error (docs/exactness.md, "What is too small").
Approximate moved(const Approximate& value, int exponent);

// A sphere relative to the eye, in units of a SphereScale.
struct ScaledSphere {
    const Sphere* sphere = nullptr;
    std::int32_t number = 0;  // in the scene: the lower one wins ties
    EyeSide side = EyeSide::outside;
    int exponent = 0;             // the scale's
    ApproximateVector center;     // relative to the eye; exact, except for parts too small for the scale
    Approximate radius;           // likewise
    Approximate c;                // center . center - radius^2, with the eye for the origin of rays
    glm::dvec3 position{0.0};     // of the centre in the scene, for differences; infinite if beyond the scale
    double position_error = 0.0;  // of each component
};

// A sphere's size for comparing hits: the largest component of its centre relative to the eye, or its radius; infinite if a
// difference overflows.
double size_from(const glm::dvec3& eye, const Sphere& sphere);

inline constexpr int size_exponent = 400;

// The power of two that brings the largest of some spheres' sizes to 2^400, so that squares can be computed for spheres of any
// size. Numbers below 2^-1000 become 0, with that for an error.
class SphereScale {
public:
    // `largest` as of size_from().
    SphereScale(const glm::dvec3& eye, double largest);

    ScaledSphere operator()(const Sphere& sphere, std::int32_t number, EyeSide side) const;
    // The exponent of the power.
    int exponent() const { return exponent_; }

private:
    double scaled(double value) const { return value * first_ * second_; }

    glm::dvec3 eye_;
    int exponent_ = 0;
    double first_;
    double second_;
    double part_ = 1.0;  // factor for operands of differences, so that none overflows
};

// The exact form of RayBasis (exact/rays.hpp): m D = m forward + across right + upward up. Orthographic: D = forward, and the ray
// begins at (across right + upward up) / m from the eye.
struct ExactBasis {
    ApproximateVector forward;
    glm::dvec3 right{0.0};
    glm::dvec3 up{0.0};
    double error = 0.0;  // of each component of each vector, if one was too small beside the largest
    bool orthographic = false;
    int edge_exponent = 0;  // right and up are the scene's times 2^-edge_exponent

    explicit ExactBasis(const Camera& camera);

    // across right + upward up of a pixel.
    ApproximateVector in_plane(PictureSize size, Pixel pixel) const;
    // m D of a pixel; orthographic: D.
    ApproximateVector ray(PictureSize size, Pixel pixel) const;
    // Where the ray begins, relative to the eye, times 2^exponent.
    ApproximateVector origin(PictureSize size, Pixel pixel, int exponent) const;
};

class NearestHit {
public:
    // The references must outlive this object.
    NearestHit(const Camera& camera, const ExactBasis& basis, PictureSize size, Pixel pixel);

    // Makes the sphere the nearest if its hit is nearer, or as near and its number lower. Returns whether it did. The sphere must
    // be on the scale of the nearest so far.
    bool challenge(const ScaledSphere& sphere);

    // Makes a sphere that the pixel is known to show the nearest, without tests.
    void take(const ScaledSphere& sphere) { best_ = best_of(sphere); }

    // Puts the nearest so far, if any, on the scale of the next spheres, which must not be smaller.
    void rescale(const SphereScale& scale);

    // The number of the nearest sphere; visible_background for none.
    std::int32_t visible() const;
    // The number of spheres that needed integers.
    std::int64_t in_integers() const { return in_integers_; }

    // The nearest sphere; null before a hit.
    const ScaledSphere* sphere() const { return best_ ? &best_->sphere : nullptr; }
    // The hit, relative to the eye.
    const ApproximateVector& point() const { return best_->point; }
    // A direction of the ray: in perspective the point.
    const ApproximateVector& ahead() const { return basis_.orthographic ? ray_ : best_->point; }
    // Where the ray begins, relative to the eye, times 2^exponent; 0 in perspective.
    const ApproximateVector& origin(int exponent) const;
    // The distance from the origin to the point.
    Approximate distance() const { return best_->square_t / sqrt(square_); }
    // The power of the point with respect to another sphere on its scale: |m|^2 - r^2, with m from the sphere's centre to the
    // point.
    Approximate power(const ScaledSphere& sphere) const;

private:
    struct Best {
        ScaledSphere sphere;
        Approximate square_t;  // A t
        ApproximateVector point;
        std::optional<ExactRoot> exact;  // once it was asked for
    };

    ApproximateVector center(const ScaledSphere& sphere) const;  // relative to the ray's origin
    Approximate c(const ScaledSphere& sphere) const;             // likewise
    std::optional<EyeSide> side(const ScaledSphere& sphere) const;
    Approximate along(const ScaledSphere& sphere) const;  // b
    Approximate discriminant(const ScaledSphere& sphere, const Approximate& b) const;
    // The sign of power(), computed in another way.
    std::optional<int> power_sign_by_differences(const ScaledSphere& sphere) const;
    // -1: the sphere's hit is nearer than the best, 0: as near, 1: farther, or none; nothing when 106 bits are not enough.
    std::optional<int> order(const ScaledSphere& sphere) const;
    std::optional<int> order_of_the_first(const ScaledSphere& sphere) const;
    // order() for a sphere seen from outside that is nearer if it is hit at all.
    std::optional<int> order_before_all(const ScaledSphere& sphere, const Approximate& b) const;
    const ExactRay& exact_ray();
    Best best_of(const ScaledSphere& sphere) const;

    const Camera& camera_;
    const ExactBasis& basis_;
    PictureSize size_;
    Pixel pixel_;
    ApproximateVector ray_;
    Approximate square_;  // A
    mutable ApproximateVector origin_{};
    mutable std::optional<int> origin_exponent_;  // the exponent of origin_
    std::optional<Best> best_;
    std::unique_ptr<ExactRay> exact_ray_;  // once it was asked for
    std::int64_t in_integers_ = 0;
};

}  // namespace sphereview
