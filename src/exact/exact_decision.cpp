#include "exact/exact_decision.hpp"

#include "exact/exact_quadratic.hpp"
#include "exact/visible.hpp"

namespace sphereview {

EyeSide eye_side(const Sphere& sphere, const glm::dvec3& eye) {
    const glm::dvec3 c = sphere.center - eye;
    const double distance = c.x * c.x + c.y * c.y + c.z * c.z;
    const double radius = sphere.radius * sphere.radius;
    // Both are within 6 units of 2^-53 while nothing over- or underflows; 16 leaves room for their difference and sum.
    const double doubt = 16.0 * double_unit * (distance + radius);
    const bool in_range = distance + radius > 1e-280 && distance + radius < 1e300;
    if (in_range && distance - radius > doubt) return EyeSide::outside;
    if (in_range && radius - distance > doubt) return EyeSide::inside;

    CommonScale scale;
    scale.include(eye);
    scale.include(sphere);
    const IntegerVector center = difference(scale.whole(sphere.center), scale.whole(eye));
    const Integer whole_radius = scale.whole(sphere.radius);
    const Integer side = dot(center, center) - whole_radius * whole_radius;
    return side > 0 ? EyeSide::outside : side < 0 ? EyeSide::inside : EyeSide::on_surface;
}

std::int32_t decide_exactly(const Camera& camera, PictureSize size, Pixel pixel, std::span<const Contender> contenders) {
    CommonScale scale;
    scale.include(camera);
    for (const Contender& contender : contenders) scale.include(*contender.sphere);
    const IntegerVector ray = exact_direction(camera, size, pixel, scale);
    const IntegerVector eye = scale.whole(camera.eye);

    std::int32_t visible = visible_background;
    std::optional<ExactRoot> nearest;
    for (const Contender& contender : contenders) {
        const auto root = smallest_positive_root(ExactQuadratic(*contender.sphere, eye, ray, scale));
        if (!root) continue;
        const int order = nearest ? compare(*root, *nearest) : -1;
        if (order < 0 || (order == 0 && contender.number < visible)) {
            nearest = root;
            visible = contender.number;
        }
    }
    return visible;
}

}  // namespace sphereview
