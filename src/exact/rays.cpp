#include "exact/rays.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "exact/filter.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// Where rays begin: the edges divided by the side.
template <typename Real>
void set_origins(RayBasis<Real>& basis, const Camera& camera, PictureSize size, int scale) {
    const double side = size.shorter_side();
    const glm::dvec3 right = times_two_to(camera.right, scale) / side;
    const glm::dvec3 up = times_two_to(camera.up, scale) / side;
    // 1 % covers the rounding here.
    const double reach = 1.01 * (taxicab_length(right) * size.width + taxicab_length(up) * size.height);
    constexpr double most = sizeof(Real) == sizeof(float) ? 0x1p55 : 0x1p900;
    const bool fits = reach < most && std::min(largest_of(right), largest_of(up)) > 0x1p-900;
    basis.orthographic = true;
    basis.in_range = basis.in_range && fits;
    basis.right = fits ? glm::vec<3, Real>(right) : glm::vec<3, Real>(Real(0));
    basis.up = fits ? glm::vec<3, Real>(up) : glm::vec<3, Real>(Real(0));
    basis.reach = fits ? static_cast<Real>(reach) : Real(0);
}

}  // namespace

template <typename Real>
RayBasis<Real> ray_basis(const Camera& camera, PictureSize size, int scale) {
    // A quarter first: the difference of two doubles, or its product with the side's mantissa, may overflow. Only powers of
    // two besides that mantissa: for the default camera nothing is rounded.
    int side_exponent = 0;
    const double side = std::frexp(size.shorter_side(), &side_exponent);
    const glm::dvec3 axis = side * (camera.center * 0.25 - camera.eye * 0.25);
    const double longest_axis = largest_of(axis);
    const int exponent = exponent_of(longest_axis);
    const int edge_exponent = -exponent - side_exponent - 2;

    // |across| and |upward| stay below 2^32; rays below 2^limit keep their squares finite.
    constexpr int limit = sizeof(Real) == sizeof(float) ? 60 : 500;
    const int longest_edge = exponent_of(std::max(largest_of(camera.right), largest_of(camera.up))) + edge_exponent + 32;
    RayBasis<Real> basis;
    basis.forward = glm::vec<3, Real>(times_two_to(axis, -exponent));
    if (camera.orthographic()) {
        basis.in_range = longest_axis > 0x1p-900;
        set_origins(basis, camera, size, scale);
        return basis;
    }
    // Below 2^-900 a quarter may have lost bits, or everything.
    basis.in_range = longest_edge < limit && longest_axis > 0x1p-900;
    const int edges = std::min(edge_exponent, edge_exponent - (longest_edge - limit));
    basis.right = glm::vec<3, Real>(times_two_to(camera.right, edges));
    basis.up = glm::vec<3, Real>(times_two_to(camera.up, edges));
    return basis;
}

template RayBasis<float> ray_basis<float>(const Camera&, PictureSize, int);
template RayBasis<double> ray_basis<double>(const Camera&, PictureSize, int);

double ray_condition(const Camera& camera) {
    const glm::dvec3 axis = camera.center * 0.5 - camera.eye * 0.5;
    const glm::dvec3 forward = times_two_to(axis, -exponent_of(largest_of(axis)));
    const glm::dvec3 right = times_two_to(camera.right, -exponent_of(largest_of(camera.right)));
    const glm::dvec3 up = times_two_to(camera.up, -exponent_of(largest_of(camera.up)));
    const glm::dvec3 normal = glm::normalize(glm::cross(right, up));
    const double off_plane = std::fabs(glm::dot(forward, normal));
    const double in_plane = glm::length(forward - glm::dot(forward, normal) * normal);
    // docs/exactness.md, "Rays"; 1 % covers the rounding here and right and up that are not quite perpendicular.
    return 1.01 * (std::sqrt(3.0) + (1.0 + std::sqrt(2.0)) * in_plane / off_plane);
}

double filter_condition(const Camera& camera) { return camera.orthographic() ? orthographic_condition : ray_condition(camera); }

}  // namespace sphereview
