// The rays of a picture in floating point, and their condition.
#pragma once

#include "base/square_root.hpp"
#include "scene/camera.hpp"

namespace sphereview {

// Perspective: pixel (x, y) looks from the eye along forward + across right + upward up, with the whole numbers of
// ray_coefficients(), scaled so that the largest component of `forward` lies in [0.5, 1). Orthographic: the pixel looks along
// `forward` from across right + upward up, relative to the eye, in scene units times 2^scale. Each component is within 2 units in
// the last place of the exact one.
template <typename Real>
struct RayBasis {
    glm::vec<3, Real> forward;
    glm::vec<3, Real> right;
    glm::vec<3, Real> up;
    bool orthographic = false;
    // An upper bound on |x| + |y| + |z| of the rays' origins; 0 in perspective.
    Real reach = 0;
    // False if the camera's numbers are too large or small for the bounds above. All numbers are finite all the same.
    bool in_range = true;
};

// `scale`: DrawnSpheres::scale for rays among drawn spheres, 0 for rays in the scene.
template <typename Real>
RayBasis<Real> ray_basis(const Camera& camera, PictureSize size, int scale = 0);

// The direction of the ray through a pixel's centre, of length 1.
template <typename Real>
glm::vec<3, Real> unit_ray(const RayBasis<Real>& basis, PictureSize size, Pixel pixel) {
    const RayCoefficients coefficients = ray_coefficients(size, pixel);
    const glm::vec<3, Real> d = basis.orthographic ? basis.forward
                                                   : (basis.forward + static_cast<Real>(coefficients.upward) * basis.up) +
                                                         static_cast<Real>(coefficients.across) * basis.right;
    return d * (Real(1) / square_root(d.x * d.x + d.y * d.y + d.z * d.z));
}

// The origin of that ray, relative to the eye.
template <typename Real>
glm::vec<3, Real> ray_origin(const RayBasis<Real>& basis, PictureSize size, Pixel pixel) {
    if (!basis.orthographic) return glm::vec<3, Real>(Real(0));
    const RayCoefficients coefficients = ray_coefficients(size, pixel);
    return static_cast<Real>(coefficients.upward) * basis.up + static_cast<Real>(coefficients.across) * basis.right;
}

// kappa of docs/exactness.md: no pixel's |forward| + |across right| + |upward up| exceeds kappa |ray|. At least sqrt(3);
// large when the screen's centre lies far off the axis.
double ray_condition(const Camera& camera);

// The kappa for error_scale().
double filter_condition(const Camera& camera);

}  // namespace sphereview
