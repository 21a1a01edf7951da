#include "light/hit_places.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "base/square_root.hpp"
#include "exact/exact_light.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

// The roundings of the few operations below, together, relative to the sizes of their operands: 64 units.
constexpr double few_roundings = 64.0 * double_unit;

double size_of(const glm::dvec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

HitBounds<double> bounds(const glm::dvec3& c, double r, double w, const glm::dvec3& ray, EyeSide side) {
    switch (side) {
        case EyeSide::outside: return hit_bounds<EyeSide::outside>(c.x, c.y, c.z, r, w, ray.x, ray.y, ray.z);
        case EyeSide::inside: return hit_bounds<EyeSide::inside>(c.x, c.y, c.z, r, w, ray.x, ray.y, ray.z);
        case EyeSide::on_surface: return hit_bounds<EyeSide::on_surface>(c.x, c.y, c.z, r, w, ray.x, ray.y, ray.z);
    }
    return {};
}

// From a sphere's centre to a point, along the unit vector to the light and across; and how far these may be off.
struct Offset {
    double along = 0.0;
    double across = 0.0;
    double doubt = 0.0;
};

Offset offset(const HitPlace& place, const glm::dvec3& eye, const Sphere& sphere, const glm::dvec3& direction) {
    const glm::dvec3 center = sphere.center - eye;
    const double size = size_of(place.point) + size_of(center) + sphere.radius;
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
      error_scale_(error_scale(ray_condition(camera), double_unit)) {
    if (!rays_.in_range || !(error_scale_ < 1.0)) error_scale_ = unknown;
}

HitPlace HitPlaces::at(Pixel pixel, const Sphere& sphere, EyeSide side) const {
    const glm::dvec3 center = sphere.center - camera_.eye;
    const double size = size_of(center) + sphere.radius;
    if (!(size > smallest_double_size && size < largest_double_size) || error_scale_ == unknown) return {glm::dvec3(0.0), unknown};
    const glm::dvec3 ray = unit_ray(rays_, size_, pixel);
    const auto [low, high] = bounds(center, sphere.radius, error_scale_ * size, ray, side);
    if (!std::isfinite(low) || !std::isfinite(high)) return {glm::dvec3(0.0), unknown};
    const double middle = 0.5 * low + 0.5 * high;
    const double half = 0.5 * high - 0.5 * low;
    // error_scale() is more than what the ray is off; twice that covers the roundings here as well.
    return {middle * ray, 1.01 * (half + 2.0 * error_scale_ * (std::fabs(middle) + half))};
}

bool HitPlaces::faces(Pixel pixel, const Sphere& sphere, EyeSide side, const glm::dvec3& direction) const {
    const Offset o = offset(at(pixel, sphere, side), camera_.eye, sphere, direction);
    if (std::fabs(o.along) > o.doubt) return (o.along > 0.0) == (side == EyeSide::outside);
    return ExactLitPoint(camera_, size_, pixel, sphere, side).facing(direction) > 0;
}

bool HitPlaces::blocked(Pixel pixel, const Sphere& sphere, EyeSide side, const Sphere& other, const glm::dvec3& direction) const {
    const Offset o = offset(at(pixel, sphere, side), camera_.eye, other, direction);
    if (o.along > o.doubt || o.across - other.radius > o.doubt) return false;
    if (o.along < -o.doubt && other.radius - o.across > o.doubt) return true;
    return ExactLitPoint(camera_, size_, pixel, sphere, side).blocking(other, direction).blocks();
}

}  // namespace sphereview
