// The rays of a picture in floating point, and how far they can be trusted.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "base/square_root.hpp"
#include "scene/camera.hpp"

namespace sphereview {

// Pixel (x, y) looks along forward + across right + upward up, with the whole numbers of ray_coefficients(). Scaled so that
// the largest component of `forward` lies in [0.5, 1); each component is within 2 units in the last place of the exact one.
template <typename Real>
struct RayBasis {
    glm::vec<3, Real> forward;
    glm::vec<3, Real> right;
    glm::vec<3, Real> up;
    // False when the camera's numbers are so large or small that what is above does not hold; they are finite all the same.
    bool in_range = true;
};

template <typename Real>
RayBasis<Real> ray_basis(const Camera& camera, PictureSize size);

// The ray through a pixel's centre, of length 1.
template <typename Real>
glm::vec<3, Real> unit_ray(const RayBasis<Real>& frame, PictureSize size, Pixel pixel) {
    const RayCoefficients coefficients = ray_coefficients(size, pixel);
    const glm::vec<3, Real> d =
        (frame.forward + static_cast<Real>(coefficients.upward) * frame.up) + static_cast<Real>(coefficients.across) * frame.right;
    return d * (Real(1) / square_root(d.x * d.x + d.y * d.y + d.z * d.z));
}

// kappa of docs/exactness.md: no pixel's |forward| + |across right| + |upward up| exceeds kappa |ray|. At least sqrt(3);
// large when the screen's centre lies far off the axis.
double ray_condition(const Camera& camera);

}  // namespace sphereview
