// Where rays hit spheres, and whether a light shines there, in double with a bound, and in integers where that is not enough.
// docs/light.md, "Deciding".
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "exact/filter.hpp"
#include "exact/rays.hpp"
#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// The exact point is within `error` of `point`, which is relative to the eye. Infinite: nothing is known. Lengths here and below
// are in the unit of the HitPlaces that they come from.
struct HitPlace {
    glm::dvec3 point{0.0};
    double error = 0.0;
};

// Along a pixel's ray, within `half` of `middle`. Infinite: nothing is known. Half as large as a place, where a million are kept.
struct HitDistance {
    double middle;
    double half;
};

// From a sphere's centre to a place, along the unit vector to a light and across it: each is off by less than `doubt`, for any
// point within the place's error (docs/exactness.md, "Light", "In double").
struct PlaceOffset {
    double along = 0.0;
    double across = 0.0;
    double doubt = 0.0;
};

// `center`: relative to the eye, as the place is. The sum of all sizes must be between smallest_double_size and
// largest_double_size, and the place's error finite.
PlaceOffset offset_from(const HitPlace& place, const glm::dvec3& center, double radius, const glm::dvec3& direction);

// How many of some points lie in a sphere's shadow, as far as double can tell.
enum class Shadow : std::uint8_t { none, unsure, all };

class HitPlaces {
public:
    // The camera must outlive it. Its unit of length is 2^-scale of the scene's: double knows nothing of a sphere whose size, as
    // scale_for() has it, is more than a factor of 2^290 from 1 in this unit.
    HitPlaces(const Camera& camera, PictureSize size, int scale = 0);

    // The scale at which a sphere and its distance from the eye are about 1.
    static int scale_for(const Sphere& sphere, const glm::dvec3& eye);

    // In the unit, relative to the eye; and a length of the scene in the unit.
    glm::dvec3 from_eye(const glm::dvec3& point) const { return point * factor_ - scaled_eye_; }
    double scaled(double length) const { return length * factor_; }
    // Whether double can tell anything of the sphere.
    bool in_range(const Sphere& sphere) const;

    // Of the sphere that the pixel shows. `side`: the eye's, here and below.
    HitPlace at(Pixel pixel, const Sphere& sphere, EyeSide side) const { return at(pixel, distance(pixel, sphere, side)); }
    // The same in two steps.
    HitDistance distance(Pixel pixel, const Sphere& sphere, EyeSide side) const;
    HitPlace at(Pixel pixel, const HitDistance& distance) const;

    // Whether the pixel's ray begins outside the sphere.
    bool begins_outside(Pixel pixel, const Sphere& sphere, EyeSide side) const;

    // Whether the normal, turned to the eye, is less than a right angle from the light's direction.
    bool faces(Pixel pixel, const Sphere& sphere, EyeSide side, const glm::dvec3& direction) const;

    // Whether another sphere, outside of which the eye lies, keeps the light from the point.
    bool blocked(Pixel pixel, const Sphere& sphere, EyeSide side, const Sphere& other, const glm::dvec3& direction) const {
        return blocked(at(pixel, sphere, side), pixel, sphere, side, other, direction);
    }
    // The same; `place` is what at() said of the point.
    bool blocked(const HitPlace& place, Pixel pixel, const Sphere& sphere, EyeSide side, const Sphere& other,
                 const glm::dvec3& direction) const;

    // The same of all points within `ball.error` of `ball.point`.
    Shadow shadow(const HitPlace& ball, const Sphere& other, const glm::dvec3& direction) const;

private:
    const Camera& camera_;
    PictureSize size_;
    int scale_;
    double factor_;  // 2^scale
    glm::dvec3 scaled_eye_;
    RayBasis<double> rays_;
    double error_scale_;
};

}  // namespace sphereview
