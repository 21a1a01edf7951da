// Where rays hit spheres, and which places lie in whose shadow, in double with a bound. docs/light.md, "Deciding".
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

// Where the ray of a pixel begins, relative to the eye, and its direction, of length 1; rounded.
struct PixelRay {
    glm::dvec3 origin;
    glm::dvec3 direction;
};

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

    PixelRay ray(Pixel pixel) const;

    // Of the sphere that the ray's pixel shows. `side`: the eye's, here and below.
    HitPlace at(const PixelRay& ray, const Sphere& sphere, EyeSide side) const { return at(ray, distance(ray, sphere, side)); }
    // The same in two steps.
    HitDistance distance(const PixelRay& ray, const Sphere& sphere, EyeSide side) const;
    // In 106 bits, for a sphere that is so much larger than its distance from the eye that double says too little.
    HitDistance sharper_distance(Pixel pixel, const Sphere& sphere, EyeSide side) const;
    HitPlace at(const PixelRay& ray, const HitDistance& distance) const;

    // Whether the pixel's ray begins outside the sphere.
    bool begins_outside(Pixel pixel, const Sphere& sphere, EyeSide side) const;

    // Whether the normal, turned to the eye, is less than a right angle from the light's direction, at all points within the
    // place's error; nothing where double cannot tell.
    std::optional<bool> faces(const HitPlace& place, const Sphere& sphere, const glm::dvec3& direction, bool outside) const;

    // How many of the points within `ball.error` of `ball.point` lie in the shadow of another sphere, outside of which the eye
    // lies.
    Shadow shadow(const HitPlace& ball, const Sphere& other, const glm::dvec3& direction) const;
    // The same, in 106 bits where double's own roundings leave it open.
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
    glm::dvec3 parallel_;  // the direction of all rays, where it is one
    ExactBasis exact_basis_;
    double error_scale_;
};

}  // namespace sphereview
