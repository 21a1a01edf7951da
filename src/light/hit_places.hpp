// Where rays hit spheres, and whether a light shines there, in double with a bound, and in integers where that is not enough.
#pragma once

#include <glm/vec3.hpp>

#include "exact/filter.hpp"
#include "exact/rays.hpp"
#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// The exact point is within `error` of `point`, which is relative to the eye. Infinite: nothing is known.
struct HitPlace {
    glm::dvec3 point{0.0};
    double error = 0.0;
};

// Along a pixel's ray, within `half` of `middle`. Infinite: nothing is known. Half as large as a place, where a million are kept.
struct HitDistance {
    double middle;
    double half;
};

class HitPlaces {
public:
    // The camera must outlive it.
    HitPlaces(const Camera& camera, PictureSize size);

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

    const glm::dvec3& eye() const { return camera_.eye; }

private:
    const Camera& camera_;
    PictureSize size_;
    RayBasis<double> rays_;
    double error_scale_;
};

}  // namespace sphereview
