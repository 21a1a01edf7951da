#include "light/hit_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/square_root.hpp"
#include "exact/exact_decision.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

// The roundings of the few operations below, together, relative to the sizes of their operands: 64 units.
constexpr double few_roundings = 64.0 * double_unit;

// Where roundings are less than this part of a ball, smaller balls tell more than more bits do.
constexpr double few_parts_of_a_ball = 1.0 / 16.0;

// Scales beyond would leave a power of two without bits.
constexpr int largest_scale = 1000;

bool in_double_range(double size) { return size > smallest_double_size && size < largest_double_size; }

double size_of(const HitPlace& place, const glm::dvec3& center, double radius) {
    return taxicab_length(place.point) + taxicab_length(center) + radius;
}

Shadow shadow_of(const HitPlace& place, const glm::dvec3& center, double radius, const glm::dvec3& direction) {
    const PlaceOffset o = offset_from(place, center, radius, direction);
    if (o.along > o.doubt || o.across - radius > o.doubt) return Shadow::none;
    if (o.along < -o.doubt && radius - o.across > o.doubt) return Shadow::all;
    return Shadow::unsure;
}

}  // namespace

PlaceOffset offset_from(const HitPlace& place, const glm::dvec3& center, double radius, const glm::dvec3& direction) {
    const glm::dvec3 l = unit(direction);
    const glm::dvec3 m = place.point - center;
    const double along = dot(m, l);
    const glm::dvec3 across = m - along * l;
    return {along, square_root(dot(across, across)), 1.01 * (place.error + few_roundings * size_of(place, center, radius))};
}

HitPlaces::HitPlaces(const Camera& camera, PictureSize size, int scale)
    : camera_(camera),
      size_(size),
      scale_(scale),
      factor_(std::ldexp(1.0, scale)),
      scaled_eye_(camera.eye * factor_),
      rays_(ray_basis<double>(camera, size, scale)),
      parallel_(unit_ray(rays_, size, {0, 0})),
      exact_basis_(camera),
      error_scale_(error_scale(filter_condition(camera), double_unit)) {
    if (!rays_.in_range || !(error_scale_ < 1.0)) error_scale_ = unknown;
}

int HitPlaces::scale_for(const Sphere& sphere, const glm::dvec3& eye) {
    const int exponent = exponent_of(std::max({largest_of(sphere.center), largest_of(eye), sphere.radius}));
    return std::clamp(-exponent, -largest_scale, largest_scale);
}

bool HitPlaces::in_range(const Sphere& sphere) const {
    return in_double_range(taxicab_length(from_eye(sphere.center)) + scaled(sphere.radius));
}

PixelRay HitPlaces::ray(Pixel pixel) const {
    return {ray_origin(rays_, size_, pixel), rays_.orthographic ? parallel_ : unit_ray(rays_, size_, pixel)};
}

HitDistance HitPlaces::distance(const PixelRay& ray, const Sphere& sphere, EyeSide side) const {
    const glm::dvec3 center = from_eye(sphere.center);
    const double radius = scaled(sphere.radius);
    const double size = taxicab_length(center) + radius + rays_.reach;
    if (!in_double_range(size) || error_scale_ == unknown) return {0.0, unknown};
    const glm::dvec3 c = center - ray.origin;
    const glm::dvec3& d = ray.direction;
    const auto [low, high] = hit_bounds(side, c.x, c.y, c.z, radius, error_scale_ * size, d.x, d.y, d.z);
    if (!std::isfinite(low) || !std::isfinite(high)) return {0.0, unknown};
    return {0.5 * low + 0.5 * high, 0.5 * high - 0.5 * low};
}

HitDistance HitPlaces::sharper_distance(Pixel pixel, const Sphere& sphere, EyeSide side) const {
    NearestHit hit(camera_, exact_basis_, size_, pixel);
    const SphereScale scale(camera_.eye, size_from(camera_.eye, sphere));
    hit.take(scale(sphere, 0, side));
    const Approximate distance = hit.distance();
    const int shift = scale_ - scale.exponent();
    const double middle = std::ldexp(distance.high, shift);
    const double half = std::ldexp(distance.error, shift) + 2.0 * double_unit * middle;
    if (error_scale_ == unknown || !in_double_range(middle) || !std::isfinite(half)) return {0.0, unknown};
    return {middle, half};
}

HitPlace HitPlaces::at(const PixelRay& ray, const HitDistance& distance) const {
    const auto& [middle, half] = distance;
    if (half == unknown) return {glm::dvec3(0.0), unknown};
    // error_scale() is more than what the ray is off; twice that covers the roundings here as well.
    const double error = 1.01 * (half + 2.0 * error_scale_ * (std::fabs(middle) + half + rays_.reach));
    return {ray.origin + middle * ray.direction, error};
}

bool HitPlaces::begins_outside(Pixel pixel, const Sphere& sphere, EyeSide side) const {
    return origin_side(sphere, side, camera_, size_, pixel) == EyeSide::outside;
}

std::optional<bool> HitPlaces::faces(const HitPlace& place, const Sphere& sphere, const glm::dvec3& direction, bool outside) const {
    const glm::dvec3 center = from_eye(sphere.center);
    const double radius = scaled(sphere.radius);
    if (!in_double_range(size_of(place, center, radius))) return std::nullopt;
    const PlaceOffset o = offset_from(place, center, radius, direction);
    if (!(std::fabs(o.along) > o.doubt)) return std::nullopt;
    return (o.along > 0.0) == outside;
}

Shadow HitPlaces::shadow(const HitPlace& ball, const Sphere& other, const glm::dvec3& direction) const {
    if (ball.error == unknown) return Shadow::unsure;
    const glm::dvec3 center = from_eye(other.center);
    const double radius = scaled(other.radius);
    if (in_double_range(size_of(ball, center, radius))) return shadow_of(ball, center, radius, direction);
    // In a unit of the sphere's own. What is too small for that unit is nothing beside the bound.
    const int scale = scale_for(other, camera_.eye);
    const double factor = std::ldexp(1.0, scale);
    const HitPlace scaled_ball{times_two_to(ball.point, scale - scale_), std::ldexp(ball.error, scale - scale_)};
    const glm::dvec3 scaled_center = other.center * factor - camera_.eye * factor;
    if (!in_double_range(size_of(scaled_ball, scaled_center, other.radius * factor))) return Shadow::unsure;
    return shadow_of(scaled_ball, scaled_center, other.radius * factor, direction);
}

Shadow HitPlaces::sharper_shadow(const HitPlace& ball, const Sphere& other, const glm::dvec3& direction) const {
    const Shadow found = shadow(ball, other, direction);
    if (found != Shadow::unsure || ball.error == unknown) return found;
    const double rounded = few_roundings * size_of(ball, from_eye(other.center), scaled(other.radius));
    if (rounded < few_parts_of_a_ball * ball.error) return found;
    return approximate_shadow({ball.point, ball.error, scale_}, camera_.eye, other, direction);
}

}  // namespace sphereview
