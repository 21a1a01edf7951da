#include "exact/exact_decision.hpp"

#include <algorithm>
#include <cmath>

#include "exact/rays.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// The sign of |c|^2 - r^2; 0 where double cannot tell.
inline int side_in_double(const glm::dvec3& c, double r) {
    const double distance = c.x * c.x + c.y * c.y + c.z * c.z;
    const double radius = r * r;
    // Both are within 6 units of 2^-53 while nothing over- or underflows; 16 leaves room for their difference and sum.
    const double doubt = 16.0 * double_unit * (distance + radius);
    const bool in_range = distance + radius > 1e-280 && distance + radius < 1e300;
    return !in_range ? 0 : distance - radius > doubt ? 1 : radius - distance > doubt ? -1 : 0;
}

EyeSide side_of_hard_sphere(const Sphere& sphere, const glm::dvec3& eye) {
    // The same with the largest number brought to [1/2, 1).
    const int exponent = exponent_of(std::max({largest_of(sphere.center), largest_of(eye), sphere.radius}));
    const int side =
        side_in_double(times_two_to(sphere.center, -exponent) - times_two_to(eye, -exponent), std::ldexp(sphere.radius, -exponent));
    if (side != 0) return side > 0 ? EyeSide::outside : EyeSide::inside;

    CommonScale scale;
    scale.include(eye);
    scale.include(sphere);
    const IntegerVector center = difference(scale.whole(sphere.center), scale.whole(eye));
    const Integer whole_radius = scale.whole(sphere.radius);
    const Integer exact_side = dot(center, center) - whole_radius * whole_radius;
    return exact_side > 0 ? EyeSide::outside : exact_side < 0 ? EyeSide::inside : EyeSide::on_surface;
}

}  // namespace

EyeSide eye_side(const Sphere& sphere, const glm::dvec3& eye) {
    // A scene asks this of each of a million spheres: what nearly all of them need comes first.
    const int side = side_in_double(sphere.center - eye, sphere.radius);
    if (side == 0) return side_of_hard_sphere(sphere, eye);
    return side > 0 ? EyeSide::outside : EyeSide::inside;
}

namespace {

// Whether the plane passes by the sphere: |C.N| > r |N| with N = right x up.
EyeSide side_of_plane(const Sphere& sphere, const Camera& camera) {
    CommonScale of_plane;
    of_plane.include(camera.right);
    of_plane.include(camera.up);
    const IntegerVector right = of_plane.whole(camera.right);
    const IntegerVector up = of_plane.whole(camera.up);
    const IntegerVector normal = {right[1] * up[2] - right[2] * up[1], right[2] * up[0] - right[0] * up[2],
                                  right[0] * up[1] - right[1] * up[0]};
    CommonScale scale;
    scale.include(camera.eye);
    scale.include(sphere);
    const Integer depth = dot(difference(scale.whole(sphere.center), scale.whole(camera.eye)), normal);
    const Integer radius = scale.whole(sphere.radius);
    return depth * depth > radius * radius * dot(normal, normal) ? EyeSide::outside : EyeSide::in_plane;
}

}  // namespace

EyeSide EyeSides::operator()(const Sphere& sphere) const {
    if (!camera_.orthographic()) return eye_side(sphere, camera_.eye);
    const glm::dvec3 c = sphere.center - camera_.eye;
    const double size = taxicab_length(c) + sphere.radius;
    if (size > smallest_double_size && size < largest_double_size) {
        // The normal is within 20 units of 2^-53, C within one, the sum within 5.
        const double doubt = 64.0 * double_unit * size;
        const double depth = std::fabs(dot(c, normal_));
        if (depth - sphere.radius > doubt) return EyeSide::outside;
        if (sphere.radius - depth > doubt) return EyeSide::in_plane;
    }
    return side_of_plane(sphere, camera_);
}

EyeSide origin_side(const Sphere& sphere, EyeSide side, const Camera& camera, PictureSize size, Pixel pixel) {
    if (side != EyeSide::in_plane) return side;
    const RayBasis<double> rays = ray_basis<double>(camera, size);
    const glm::dvec3 from_eye = sphere.center - camera.eye;
    const double reach = taxicab_length(from_eye) + sphere.radius + rays.reach;
    if (rays.in_range && reach > smallest_double_size && reach < largest_double_size) {
        // docs/exactness.md, "Orthographic rays": off by less than 17 units of the size's square.
        const glm::dvec3 c = from_eye - ray_origin(rays, size, pixel);
        const double difference = dot(c, c) - sphere.radius * sphere.radius;
        const double doubt = 64.0 * double_unit * (reach * reach);
        if (std::fabs(difference) > doubt) return difference > 0.0 ? EyeSide::outside : EyeSide::inside;
    }
    CommonScale scale;
    scale.include_origins(camera);
    scale.include(sphere);
    const ExactOrigin origin = exact_origin(camera, size, pixel, scale);
    const IntegerVector center = origin.to(scale.whole(sphere.center));
    const Integer radius = scale.whole(sphere.radius) * origin.factor;
    const Integer exact_side = dot(center, center) - radius * radius;
    return exact_side > 0 ? EyeSide::outside : exact_side < 0 ? EyeSide::inside : EyeSide::on_surface;
}

ExactRay::ExactRay(const Camera& camera, PictureSize size, Pixel pixel) : camera_(camera), size_(size), pixel_(pixel) {
    CommonScale scale;
    scale.include(camera);
    direction_ = exact_direction(camera, size, pixel, scale);
    square_ = dot(direction_, direction_);
}

std::optional<ExactRoot> ExactRay::hit(const Sphere& sphere) const {
    CommonScale scale;
    scale.include_origins(camera_);
    scale.include(sphere);
    const ExactOrigin origin = exact_origin(camera_, size_, pixel_, scale);
    auto root = smallest_positive_root(ExactQuadratic(sphere, origin, direction_, square_, scale));
    if (root) root->exponent = scale.exponent();
    return root;
}

}  // namespace sphereview
