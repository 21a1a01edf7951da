#include "light/hit_places.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "base/square_root.hpp"
#include "exact/exact_decision.hpp"
#include "exact/exact_light.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

// The roundings of the few operations below, together, relative to the sizes of their operands: 64 units.
constexpr double few_roundings = 64.0 * double_unit;

// From a sphere's centre to a point, along the unit vector to the light and across; and how far these may be off.
struct Offset {
    double along = 0.0;
    double across = 0.0;
    double doubt = 0.0;
};

Offset offset(const HitPlace& place, const glm::dvec3& eye, const Sphere& sphere, const glm::dvec3& direction) {
    const glm::dvec3 center = sphere.center - eye;
    const double size = taxicab_length(place.point) + taxicab_length(center) + sphere.radius;
    if (!(size > smallest_double_size && size < largest_double_size)) return {0.0, 0.0, unknown};
    const glm::dvec3 l = unit(direction);
    const glm::dvec3 m = place.point - center;
    const double along = dot(m, l);
    const glm::dvec3 across = m - along * l;
    return {along, square_root(dot(across, across)), 1.01 * (place.error + few_roundings * size)};
}

}  // namespace

HitPlaces::HitPlaces(const Camera& camera, PictureSize size)
    : camera_(camera),
      size_(size),
      rays_(ray_basis<double>(camera, size)),
      error_scale_(error_scale(filter_condition(camera), double_unit)) {
    if (!rays_.in_range || !(error_scale_ < 1.0)) error_scale_ = unknown;
}

HitDistance HitPlaces::distance(Pixel pixel, const Sphere& sphere, EyeSide side) const {
    const glm::dvec3 center = sphere.center - camera_.eye;
    const double size = taxicab_length(center) + sphere.radius + rays_.reach;
    if (!(size > smallest_double_size && size < largest_double_size) || error_scale_ == unknown) return {0.0, unknown};
    const glm::dvec3 ray = unit_ray(rays_, size_, pixel);
    const glm::dvec3 c = center - ray_origin(rays_, size_, pixel);
    const auto [low, high] = hit_bounds(side, c.x, c.y, c.z, sphere.radius, error_scale_ * size, ray.x, ray.y, ray.z);
    if (!std::isfinite(low) || !std::isfinite(high)) return {0.0, unknown};
    return {0.5 * low + 0.5 * high, 0.5 * high - 0.5 * low};
}

HitPlace HitPlaces::at(Pixel pixel, const HitDistance& distance) const {
    const auto& [middle, half] = distance;
    if (half == unknown) return {glm::dvec3(0.0), unknown};
    const glm::dvec3 ray = unit_ray(rays_, size_, pixel);
    // error_scale() is more than what the ray is off; twice that covers the roundings here as well.
    const double error = 1.01 * (half + 2.0 * error_scale_ * (std::fabs(middle) + half + rays_.reach));
    return {rays_.orthographic ? ray_origin(rays_, size_, pixel) + middle * ray : middle * ray, error};
}

bool HitPlaces::begins_outside(Pixel pixel, const Sphere& sphere, EyeSide side) const {
    return origin_side(sphere, side, camera_, size_, pixel) == EyeSide::outside;
}

bool HitPlaces::faces(Pixel pixel, const Sphere& sphere, EyeSide side, const glm::dvec3& direction) const {
    const Offset o = offset(at(pixel, sphere, side), camera_.eye, sphere, direction);
    if (std::fabs(o.along) > o.doubt) return (o.along > 0.0) == begins_outside(pixel, sphere, side);
    return ExactLitPoint(camera_, size_, pixel, sphere, side).facing(direction) > 0;
}

bool HitPlaces::blocked(const HitPlace& place, Pixel pixel, const Sphere& sphere, EyeSide side, const Sphere& other,
                        const glm::dvec3& direction) const {
    const Offset o = offset(place, camera_.eye, other, direction);
    if (o.along > o.doubt || o.across - other.radius > o.doubt) return false;
    if (o.along < -o.doubt && other.radius - o.across > o.doubt) return true;
    return ExactLitPoint(camera_, size_, pixel, sphere, side).blocking(other, direction).blocks();
}

}  // namespace sphereview
