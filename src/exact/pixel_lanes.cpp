#include "exact/pixel_lanes.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/simd.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double never = NearestHits<double>::never;
constexpr double largest = std::numeric_limits<double>::max();
constexpr double underflow = 0x1p-1000;
constexpr double too_small = 0x1p-580;        // what errors of 2^-1000 come to beside numbers of 2^404, and more
constexpr double smallest_doubt = 0x1p-1060;  // what underflow may take from a sum of products
constexpr double u = double_unit;

std::size_t full_lanes(std::size_t count) { return (count + 3) / 4 * 4; }

// Bit i is set where flags[i] is 1 and not 0.
LaneSet set_of(const Lane<std::int64_t>& flags, std::size_t count) {
    LaneSet set = 0;
    for (std::size_t i = 0; i < count; ++i) set |= static_cast<LaneSet>(flags[i]) << i;
    return set;
}

// How far off the high part may be.
double off(const Approximate& number) { return std::fabs(number.low) + number.error; }
double largest_off(const ApproximateVector& v) { return std::max({off(v[0]), off(v[1]), off(v[2])}); }

glm::dvec3 high_parts(const ApproximateVector& v) { return {v[0].high, v[1].high, v[2].high}; }

}  // namespace

BoundedSphere::BoundedSphere(const Sphere& sphere, const glm::dvec3& eye, double error_scale, double reach)
    : center(sphere.center - eye), radius(sphere.radius) {
    const auto size = [&] { return taxicab_length(center) + radius + reach * scale; };
    const auto in_range = [](double s) { return s > smallest_double_size && s < largest_double_size; };
    if (!in_range(size())) {
        const bool overflows = !std::isfinite(largest_of(center));
        const int of_center = exponent_of(overflows ? std::max(largest_of(sphere.center), largest_of(eye)) : largest_of(center));
        const int exponent = std::clamp(std::max(of_center, exponent_of(std::max(radius, reach))), -950, 1024);
        const auto scaled = [=](double value) { return std::ldexp(value, -exponent); };
        unit = std::ldexp(1.0 / distance_unit, exponent);
        for (int axis = 0; axis < 3; ++axis) {
            center[axis] = overflows ? scaled(sphere.center[axis]) - scaled(eye[axis]) : scaled(center[axis]);
        }
        radius = scaled(radius);
        scale = scaled(1.0);
    }
    w = in_range(size()) ? error_scale * size() : never;
}

BoundLanes::BoundLanes(std::span<const glm::dvec3> rays, std::span<const glm::dvec3> origins)
    : count_(full_lanes(rays.size())), in_eye_(origins.empty()) {
    assert(!rays.empty() && rays.size() <= most_lanes && (in_eye_ || origins.size() == rays.size()));
    for (std::size_t i = 0; i < count_; ++i) {
        const std::size_t filled = std::min(i, rays.size() - 1);
        ray_.set(i, rays[filled]);
        origin_.set(i, in_eye_ ? glm::dvec3(0.0) : origins[filled]);
        smallest_high_[i] = low_[i] = second_low_[i] = never;
        sure_[i] = guess_[i] = -1;
    }
}

template <EyeSide side, bool in_eye>
LaneSet BoundLanes::add_on_side(std::int64_t index, const BoundedSphere& sphere) {
    const auto [c, r, scale, w, unit] = sphere;
    if constexpr (side == EyeSide::outside) {
        // Whether all rays surely miss: without square roots, by twice the bound.
        const double reach = r + 2.0 * w;
        const double reach_square = reach * reach;
        std::int64_t near = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const double cx = in_eye ? c.x : c.x - scale * origin_.x[i];
            const double cy = in_eye ? c.y : c.y - scale * origin_.y[i];
            const double cz = in_eye ? c.z : c.z - scale * origin_.z[i];
            const double along = cx * ray_.x[i] + cy * ray_.y[i] + cz * ray_.z[i];
            const double px = cx - along * ray_.x[i];
            const double py = cy - along * ray_.y[i];
            const double pz = cz - along * ray_.z[i];
            near |= static_cast<std::int64_t>(px * px + py * py + pz * pz <= reach_square);
        }
        if (near == 0) return 0;
    }
    Lane<std::int64_t> contends;
    std::int64_t any = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        const double cx = in_eye ? c.x : c.x - scale * origin_.x[i];
        const double cy = in_eye ? c.y : c.y - scale * origin_.y[i];
        const double cz = in_eye ? c.z : c.z - scale * origin_.z[i];
        const HitBounds<double> hit = hit_bounds<side>(cx, cy, cz, r, w, ray_.x[i], ray_.y[i], ray_.z[i]);
        const double low = hit.low * unit - underflow;
        const double high = hit.high * unit + underflow;
        // All loads before all stores: a conditional one would keep this from becoming SIMD.
        const double low_so_far = low_[i];
        const double second_low = second_low_[i];
        const double high_so_far = smallest_high_[i];
        const std::int64_t guess = guess_[i];
        const std::int64_t sure = sure_[i];
        const bool nearer = low < low_so_far;
        const double displaced = nearer ? low_so_far : low;
        second_low_[i] = displaced < second_low ? displaced : second_low;
        low_[i] = nearer ? low : low_so_far;
        guess_[i] = nearer ? index : guess;
        const bool surer = high < high_so_far;
        const double smallest_high = surer ? high : high_so_far;
        smallest_high_[i] = smallest_high;
        sure_[i] = surer ? index : sure;
        const double limit = smallest_high < largest ? smallest_high : largest;
        contends[i] = low <= limit ? 1 : 0;
        any |= contends[i];
    }
    return any == 0 ? 0 : set_of(contends, count_);
}

SPHEREVIEW_FOR_EACH_SIMD
LaneSet BoundLanes::add(std::int64_t index, const BoundedSphere& sphere, EyeSide side) {
    if (!(sphere.w < never)) {
        // Perhaps hit, anywhere.
        for (std::size_t i = 0; i < count_; ++i) {
            second_low_[i] = low_[i];
            low_[i] = -never;
            guess_[i] = index;
        }
        return ~LaneSet{0};
    }
    switch (side) {
        case EyeSide::outside:
            return in_eye_ ? add_on_side<EyeSide::outside, true>(index, sphere)
                           : add_on_side<EyeSide::outside, false>(index, sphere);
        case EyeSide::inside: return add_on_side<EyeSide::inside, true>(index, sphere);
        case EyeSide::on_surface: return add_on_side<EyeSide::on_surface, true>(index, sphere);
        case EyeSide::in_plane: return add_on_side<EyeSide::in_plane, false>(index, sphere);
    }
    return 0;
}

NearestHits<double> BoundLanes::nearest(std::size_t lane) const {
    return {smallest_high_[lane], static_cast<int>(sure_[lane]), low_[lane], static_cast<int>(guess_[lane]), second_low_[lane]};
}

SPHEREVIEW_FOR_EACH_SIMD
double BoundLanes::farthest_sure_hit() const {
    // Positive doubles compare like integers, of which the compiler knows that their order of comparison does not matter.
    std::int64_t most = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        const auto bits = std::bit_cast<std::int64_t>(smallest_high_[i]);
        most = most < bits ? bits : most;
    }
    return std::bit_cast<double>(most) * distance_unit;
}

DifferenceLanes::DifferenceLanes(std::size_t count) : count_(full_lanes(count)) {}

void DifferenceLanes::use(const SphereScale& scale) {
    // Differences of spheres are less than 4 where the largest is below 1, and below 2^930 wherever what comes first cannot tell.
    difference_unit_ = scale.exponent() >= size_exponent ? 0x1p90 : 0x1p-310;
}

void DifferenceLanes::set(std::size_t lane, const NearestHit& nearest) {
    takes_part_[lane] = 1;
    if (nearest.sphere() == nullptr) return;
    const ScaledSphere& sphere = *nearest.sphere();
    center_.set(lane, sphere.position);
    c_high_[lane] = sphere.c.high;
    c_low_[lane] = sphere.c.low;
    c_error_[lane] = sphere.c.error + 4.0 * u * std::fabs(sphere.c.low);
    const ApproximateVector& begin = nearest.origin(sphere.exponent);
    const glm::dvec3 origin = high_parts(begin);
    origin_.set(lane, origin);
    origin_error_[lane] = largest_off(begin);
    origin_length_[lane] = taxicab_length(origin);
    origin_square_[lane] = dot(origin, origin);
    const auto& [x, y, z] = nearest.point();
    const double error = largest_off(nearest.point());
    const glm::dvec3 point = high_parts(nearest.point());
    const double length = taxicab_length(point);
    const bool known = 2.0 * error < length && std::isfinite(off(x) + off(y) + off(z));
    glm::dvec3 hit = point;
    if (!known) hit.x = std::numeric_limits<double>::quiet_NaN();
    hit_.set(lane, hit);
    const glm::dvec3 ahead = high_parts(nearest.ahead());
    const double ahead_length = taxicab_length(ahead);
    ahead_.set(lane, ahead);
    square_[lane] = dot(point, ahead);
    error_[lane] = error;
    length_[lane] = length;
    inaccuracy_[lane] = 8.0 * u * ahead_length + 4.0 * error * (ahead_length / length);
    scene_.set(lane, sphere.sphere->center);
    scene_radius_[lane] = sphere.sphere->radius;
    const glm::dvec3 center = high_parts(sphere.center);
    sum_.set(lane, center - 2.0 * hit);
    sum_length_[lane] = largest_of(center) + 2.0 * length;
    radius_[lane] = sphere.radius.high;
}

// The sign of c seen from where the rays begin: c - 2 C.Q + Q.Q.
SPHEREVIEW_FOR_EACH_SIMD
DifferenceLanes::Sides DifferenceLanes::sides(const ScaledSphere& sphere) const {
    const double cx = sphere.center[0].high;
    const double cy = sphere.center[1].high;
    const double cz = sphere.center[2].high;
    const double size = std::fabs(cx) + std::fabs(cy) + std::fabs(cz);
    const double center_off = largest_off(sphere.center);
    const double c = sphere.c.high;
    const double c_off = off(sphere.c);
    Lane<std::int64_t> outside;
    Lane<std::int64_t> inside;
    for (std::size_t i = 0; i < count_; ++i) {
        const double along_x = cx * origin_.x[i];
        const double along_y = cy * origin_.y[i];
        const double along_z = cz * origin_.z[i];
        const double of_origin = c - 2.0 * (along_x + along_y + along_z) + origin_square_[i];
        const double terms =
            std::fabs(c) + 2.0 * (std::fabs(along_x) + std::fabs(along_y) + std::fabs(along_z)) + origin_square_[i];
        const double off_terms = origin_length_[i] * center_off + (size + origin_length_[i]) * origin_error_[i];
        const double doubt = 1.0625 * (6.0 * u * terms + 2.0 * off_terms + c_off) + too_small;
        outside[i] = of_origin > doubt ? takes_part_[i] : 0;
        inside[i] = of_origin < -doubt ? takes_part_[i] : 0;
    }
    return {set_of(outside, count_), set_of(inside, count_)};
}

LaneSet DifferenceLanes::challenged_by(const ScaledSphere& sphere) const {
    if (sphere.side != EyeSide::in_plane) return challenged_by(sphere, sphere.side == EyeSide::outside);
    const auto [outside, inside] = sides(sphere);
    LaneSet challenged = set_of(takes_part_, count_);
    if (outside != 0) challenged &= ~outside | challenged_by(sphere, true);
    if (inside != 0) challenged &= ~inside | challenged_by(sphere, false);
    return challenged;
}

SPHEREVIEW_FOR_EACH_SIMD
LaneSet DifferenceLanes::challenged_by(const ScaledSphere& sphere, bool outside) const {
    const glm::dvec3 position = sphere.position;
    const double cx = sphere.center[0].high;
    const double cy = sphere.center[1].high;
    const double cz = sphere.center[2].high;
    const double size = std::fabs(cx) + std::fabs(cy) + std::fabs(cz);
    const double c_high = sphere.c.high;
    const double c_low = sphere.c.low;
    const double c_error = sphere.c.error + 4.0 * u * std::fabs(c_low);
    Lane<std::int64_t> challenged;
    std::int64_t any = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        const double apart_x = position.x - center_.x[i];
        const double apart_y = position.y - center_.y[i];
        const double apart_z = position.z - center_.z[i];
        const double along_x = hit_.x[i] * apart_x;
        const double along_y = hit_.y[i] * apart_y;
        const double along_z = hit_.z[i] * apart_z;
        const double c_apart = (c_high - c_high_[i]) + (c_low - c_low_[i]);
        const double power = c_apart - 2.0 * (along_x + along_y + along_z);
        const double terms = std::fabs(c_apart) + 2.0 * (std::fabs(along_x) + std::fabs(along_y) + std::fabs(along_z));
        const double off = error_[i] * (std::fabs(apart_x) + std::fabs(apart_y) + std::fabs(apart_z));
        const double doubt = 1.0625 * (6.0 * u * terms + 2.0 * off + (c_error + c_error_[i])) + too_small;
        // V: is the hit before the middle between the sphere's roots?
        const double before_middle = ahead_.x[i] * cx + ahead_.y[i] * cy + ahead_.z[i] * cz - square_[i];
        const double middle_doubt = inaccuracy_[i] * (size + length_[i]) + too_small;
        const bool not_nearer_outside = (power > doubt) & (before_middle > middle_doubt);
        const bool not_nearer_else = power < -doubt;
        const bool not_nearer = outside ? not_nearer_outside : not_nearer_else;
        challenged[i] = not_nearer ? 0 : takes_part_[i];
        any |= challenged[i];
    }
    if (any == 0) return 0;
    // Of the others: the power once more, of sums that have the spheres' differences for factors. These are taken of the scene's
    // numbers, where they are as exact as they can be; `unit` keeps products of differences and sizes within the range of doubles.
    const Sphere& scene = *sphere.sphere;
    const double radius = sphere.radius.high;
    const double unit = difference_unit_;
    any = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        const double apart_x = scene.center.x - scene_.x[i];
        const double apart_y = scene.center.y - scene_.y[i];
        const double apart_z = scene.center.z - scene_.z[i];
        const double radii_apart = scene.radius - scene_radius_[i];
        const double part_x = apart_x * ((cx + sum_.x[i]) * unit);
        const double part_y = apart_y * ((cy + sum_.y[i]) * unit);
        const double part_z = apart_z * ((cz + sum_.z[i]) * unit);
        const double part_r = radii_apart * ((radius + radius_[i]) * unit);
        const double power = (part_x + part_y + part_z) - part_r;
        const double terms = std::fabs(part_x) + std::fabs(part_y) + std::fabs(part_z) + std::fabs(part_r);
        const double inexact = (4.0 * u * (size + sum_length_[i]) + 2.0 * error_[i] + too_small) * unit;
        const double off = inexact * (std::fabs(apart_x) + std::fabs(apart_y) + std::fabs(apart_z));
        const double off_radius = too_small * unit * std::fabs(radii_apart);
        const double doubt = 1.0625 * (7.0 * u * terms + off + off_radius) + smallest_doubt;
        const double before_middle = ahead_.x[i] * cx + ahead_.y[i] * cy + ahead_.z[i] * cz - square_[i];
        const double middle_doubt = inaccuracy_[i] * (size + length_[i]) + too_small;
        const bool not_nearer_outside = (power > doubt) & (before_middle > middle_doubt);
        const bool not_nearer_else = power < -doubt;
        const bool not_nearer = outside ? not_nearer_outside : not_nearer_else;
        challenged[i] = not_nearer ? 0 : challenged[i];
        any |= challenged[i];
    }
    return any == 0 ? 0 : set_of(challenged, count_);
}

}  // namespace sphereview
