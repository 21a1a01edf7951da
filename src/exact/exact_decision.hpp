// The last level of visibility: exact integers on common powers of two. Nothing is rounded, nothing overflows.
#pragma once

#include <optional>

#include "exact/exact_quadratic.hpp"
#include "exact/filter.hpp"
#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// The side of the sphere's surface on which the eye lies.
EyeSide eye_side(const Sphere& sphere, const glm::dvec3& eye);

// The side of a camera's eye for each of many spheres.
class EyeSides {
public:
    explicit EyeSides(const Camera& camera) : camera_(camera) {
        if (camera.orthographic()) normal_ = camera_axes(camera).ahead;
    }

    EyeSide operator()(const Sphere& sphere) const;

private:
    Camera camera_;
    glm::dvec3 normal_{0.0};  // of the plane that orthographic rays begin in, of length 1
};

// The side of the sphere's surface on which a pixel's ray begins: never in_plane. `side`: the eye's.
EyeSide origin_side(const Sphere& sphere, EyeSide side, const Camera& camera, PictureSize size, Pixel pixel);

// A pixel's ray in integers. The ray has its own power of two, and so has each sphere with the ray's origin: the length of numbers
// does not depend on the rest of the scene.
class ExactRay {
public:
    ExactRay(const Camera& camera, PictureSize size, Pixel pixel);

    // The hit of a sphere. Roots of one ray can be compared.
    std::optional<ExactRoot> hit(const Sphere& sphere) const;

private:
    Camera camera_;
    PictureSize size_;
    Pixel pixel_;
    IntegerVector direction_;
    Integer square_;
};

}  // namespace sphereview
