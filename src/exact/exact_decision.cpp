#include "exact/exact_decision.hpp"

#include <algorithm>
#include <cmath>

#include "exact/visible.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

glm::dvec3 divided_by_two_to(const glm::dvec3& v, int exponent) {
    return {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
}

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
    int exponent = 0;
    std::frexp(std::max({largest_of(sphere.center), largest_of(eye), sphere.radius}), &exponent);
    const int side = side_in_double(divided_by_two_to(sphere.center, exponent) - divided_by_two_to(eye, exponent),
                                    std::ldexp(sphere.radius, -exponent));
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

ExactRay::ExactRay(const Camera& camera, PictureSize size, Pixel pixel) : eye_(camera.eye) {
    CommonScale scale;
    scale.include(camera);
    direction_ = exact_direction(camera, size, pixel, scale);
    square_ = dot(direction_, direction_);
}

std::optional<ExactRoot> ExactRay::hit(const Sphere& sphere) const {
    CommonScale scale;
    scale.include(eye_);
    scale.include(sphere);
    auto root = smallest_positive_root(ExactQuadratic(sphere, scale.whole(eye_), direction_, square_, scale));
    if (root) root->exponent = scale.exponent();
    return root;
}

std::int32_t decide_exactly(const Camera& camera, PictureSize size, Pixel pixel, std::span<const Contender> contenders) {
    const ExactRay ray(camera, size, pixel);
    std::int32_t visible = visible_background;
    std::optional<ExactRoot> nearest;
    for (const Contender& contender : contenders) {
        auto root = ray.hit(*contender.sphere);
        if (!root) continue;
        const int order = nearest ? compare(*root, *nearest) : -1;
        if (order < 0 || (order == 0 && contender.number < visible)) {
            nearest = std::move(root);
            visible = contender.number;
        }
    }
    return visible;
}

}  // namespace sphereview
