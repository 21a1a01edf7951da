// One point of a picture, and what lights are asked of it: in double, in 106 bits, and in integers where these are not enough.
#pragma once

#include <cstdint>
#include <optional>

#include "exact/approximate_light.hpp"
#include "exact/exact_light.hpp"
#include "light/hit_places.hpp"

namespace sphereview {

// Keeps what questions have in common: for a point of which much is asked.
class AskedPoint {
public:
    // Of the sphere that the pixel shows. `side`: the eye's. `place`: of the point, where one is known better than double finds it.
    // `in_integers`: counts the questions that need integers; may be null. What is passed in must outlive it.
    AskedPoint(const HitPlaces& places, Pixel pixel, const Sphere& sphere, EyeSide side,
               const std::optional<HitPlace>& place = std::nullopt, std::int64_t* in_integers = nullptr);

    // Whether the normal, turned to the eye, is less than a right angle from the light's direction.
    bool faces(const glm::dvec3& direction);

    // Whether another sphere, outside of which the eye lies, keeps the light from the point.
    bool blocked(const Sphere& other, const glm::dvec3& direction);

private:
    const ApproximateLitPoint& approximate();
    const ExactLitPoint& exact();

    const HitPlaces& places_;
    Pixel pixel_;
    const Sphere& sphere_;
    EyeSide side_;
    HitPlace place_;
    std::optional<ApproximateLitPoint> approximate_;  // once it was asked for, and below
    std::optional<ExactLitPoint> exact_;
    std::int64_t* in_integers_;
};

}  // namespace sphereview
