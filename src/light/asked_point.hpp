// Decides for one point of a picture whether lights reach it: in double, then in 106 bits, then in integers.
#pragma once

#include <cstdint>
#include <optional>

#include "exact/approximate_light.hpp"
#include "exact/exact_light.hpp"
#include "light/hit_places.hpp"

namespace sphereview {

// Keeps what several questions about one point have in common.
class AskedPoint {
public:
    // `sphere`: the one that the pixel shows. `side`: the eye's. `place`: the point's, if known better than double finds it.
    // `in_integers`: counts the questions that need integers; may be null. The references must outlive this object.
    AskedPoint(const HitPlaces& places, Pixel pixel, const Sphere& sphere, EyeSide side,
               const std::optional<HitPlace>& place = std::nullopt, std::int64_t* in_integers = nullptr);

    // Whether the normal, turned to the eye, is less than a right angle from the light's direction.
    bool faces(const glm::dvec3& direction);

    // Whether `other`, which must not contain the eye, keeps the light from the point.
    bool blocked(const Sphere& other, const glm::dvec3& direction);

private:
    const ApproximateLitPoint& approximate();
    const ExactLitPoint& exact();

    const HitPlaces& places_;
    Pixel pixel_;
    const Sphere& sphere_;
    EyeSide side_;
    HitPlace place_;
    std::optional<ApproximateLitPoint> approximate_;  // made when first needed, as exact_
    std::optional<ExactLitPoint> exact_;
    std::int64_t* in_integers_;
};

}  // namespace sphereview
