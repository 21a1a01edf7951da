// Where rays hit spheres, and which hits lie in the shadow of a sphere, in double with a bound. docs/light.md, "Deciding".
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "exact/approximate_light.hpp"
#include "exact/filter.hpp"
#include "exact/nearest_hit.hpp"
#include "exact/rays.hpp"
#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// The exact point is within `error` of `point`, which is relative to the eye. An infinite error: nothing is known. Lengths here and
// below are in the unit of their HitPlaces.
struct HitPlace {
    glm::dvec3 point{0.0};
    double error = 0.0;
};

// A distance along a pixel's ray, within `half` of `middle`. Infinite: nothing is known. Takes half of a HitPlace's memory.
struct HitDistance {
    double middle;
    double half;
};

// The way from a sphere's centre to a place, along the unit vector to a light and across it. Each is off by less than `doubt`, for
// any point within the place's error (docs/exactness.md, "Light", "In double").
struct PlaceOffset {
    double along = 0.0;
    double across = 0.0;
    double doubt = 0.0;
};

// `center`: relative to the eye. The sum of all sizes must be between smallest_double_size and largest_double_size, and the place's
// error finite.
PlaceOffset offset_from(const HitPlace& place, const glm::dvec3& center, double radius, const glm::dvec3& direction);

// A pixel's ray: its origin relative to the eye, and its direction of length 1; both rounded.
struct PixelRay {
    glm::dvec3 origin;
    glm::dvec3 direction;
};

class HitPlaces {
public:
    // The camera must outlive this object. The unit of length is 2^-scale of the scene's. Spheres whose size in this unit is more
    // than a factor of 2^290 from 1 are not in_range(); scale_for() gives a fitting scale.
    HitPlaces(const Camera& camera, PictureSize size, int scale = 0);

    // The scale at which a sphere and its distance from the eye are about 1.
    static int scale_for(const Sphere& sphere, const glm::dvec3& eye);

    // A point of the scene relative to the eye, and a length of the scene, in this unit.
    glm::dvec3 from_eye(const glm::dvec3& point) const { return point * factor_ - scaled_eye_; }
    double scaled(double length) const { return length * factor_; }
    // Whether double can tell anything of the sphere.
    bool in_range(const Sphere& sphere) const;

    PixelRay ray(Pixel pixel) const;

    // The hit of the sphere that the ray's pixel shows. `side`: the eye's, here and below.
    HitPlace at(const PixelRay& ray, const Sphere& sphere, EyeSide side) const { return at(ray, distance(ray, sphere, side)); }
    // The same in two steps.
    HitDistance distance(const PixelRay& ray, const Sphere& sphere, EyeSide side) const;
    // In 106 bits, for a sphere so much larger than its distance from the eye that double's bounds are too wide.
    HitDistance sharper_distance(Pixel pixel, const Sphere& sphere, EyeSide side) const;
    HitPlace at(const PixelRay& ray, const HitDistance& distance) const;

    // Whether the pixel's ray begins outside the sphere.
    bool begins_outside(Pixel pixel, const Sphere& sphere, EyeSide side) const;

    // Whether the normal, turned to the eye, is less than a right angle from the light's direction at all points within the place's
    // error. Nothing where double cannot tell.
    std::optional<bool> faces(const HitPlace& place, const Sphere& sphere, const glm::dvec3& direction, bool outside) const;

    // Whether none or all of the ball lies in the shadow of `other`, which must not contain the eye.
    Shadow shadow(const HitPlace& ball, const Sphere& other, const glm::dvec3& direction) const;
    // The same, in 106 bits where double's roundings leave the answer open.
    Shadow sharper_shadow(const HitPlace& ball, const Sphere& other, const glm::dvec3& direction) const;

    const Camera& camera() const { return camera_; }
    PictureSize size() const { return size_; }
    const ExactBasis& exact_basis() const { return exact_basis_; }

private:
    const Camera& camera_;
    PictureSize size_;
    int scale_;
    double factor_;  // 2^scale
    glm::dvec3 scaled_eye_;
    RayBasis<double> rays_;
    glm::dvec3 parallel_;  // the direction of all rays, if they are parallel
    ExactBasis exact_basis_;
    double error_scale_;
};

}  // namespace sphereview
