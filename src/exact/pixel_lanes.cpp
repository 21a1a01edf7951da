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

}  // namespace

BoundedSphere::BoundedSphere(const Sphere& sphere, const glm::dvec3& eye, double error_scale, double reach)
    : center(sphere.center - eye), radius(sphere.radius) {
    const auto size = [&] { return std::fabs(center.x) + std::fabs(center.y) + std::fabs(center.z) + radius + reach * scale; };
    const auto in_range = [](double s) { return s > smallest_double_size && s < largest_double_size; };
    if (!in_range(size())) {
        const bool overflows = !std::isfinite(largest_of(center));
        int exponent = 0;
        std::frexp(overflows ? std::max(largest_of(sphere.center), largest_of(eye)) : largest_of(center), &exponent);
        int of_radius = 0;
        std::frexp(std::max(radius, reach), &of_radius);
        exponent = std::clamp(std::max(exponent, of_radius), -950, 1024);
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
        const glm::dvec3& ray = rays[std::min(i, rays.size() - 1)];
        x_[i] = ray.x;
        y_[i] = ray.y;
        z_[i] = ray.z;
        const glm::dvec3 origin = in_eye_ ? glm::dvec3(0.0) : origins[std::min(i, rays.size() - 1)];
        origin_x_[i] = origin.x;
        origin_y_[i] = origin.y;
        origin_z_[i] = origin.z;
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
            const double cx = in_eye ? c.x : c.x - scale * origin_x_[i];
            const double cy = in_eye ? c.y : c.y - scale * origin_y_[i];
            const double cz = in_eye ? c.z : c.z - scale * origin_z_[i];
            const double along = cx * x_[i] + cy * y_[i] + cz * z_[i];
            const double px = cx - along * x_[i];
            const double py = cy - along * y_[i];
            const double pz = cz - along * z_[i];
            near |= static_cast<std::int64_t>(px * px + py * py + pz * pz <= reach_square);
        }
        if (near == 0) return 0;
    }
    Lane<std::int64_t> contends;
    std::int64_t any = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        const double cx = in_eye ? c.x : c.x - scale * origin_x_[i];
        const double cy = in_eye ? c.y : c.y - scale * origin_y_[i];
        const double cz = in_eye ? c.z : c.z - scale * origin_z_[i];
        const HitBounds<double> hit = hit_bounds<side>(cx, cy, cz, r, w, x_[i], y_[i], z_[i]);
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

DifferenceLanes::DifferenceLanes(std::size_t count) : count_(full_lanes(count)) {
    for (
        Lane<double>* lane :
        {&center_x_, &center_y_,     &center_z_,      &c_high_,       &c_low_,   &c_error_,    &x_,          &y_,        &z_,
         &square_,   &error_,        &length_,        &ahead_x_,      &ahead_y_, &ahead_z_,    &inaccuracy_, &scene_x_,  &scene_y_,
         &scene_z_,  &scene_radius_, &sum_x_,         &sum_y_,        &sum_z_,   &sum_length_, &radius_,     &origin_x_, &origin_y_,
         &origin_z_, &origin_error_, &origin_length_, &origin_square_}) {
        lane->fill(std::numeric_limits<double>::quiet_NaN());
    }
}

void DifferenceLanes::use(const SphereScale& scale) {
    // Differences of spheres are less than 4 where the largest is below 1, and below 2^930 wherever what comes first cannot tell.
    difference_unit_ = scale.exponent() >= size_exponent ? 0x1p90 : 0x1p-310;
}

void DifferenceLanes::set(std::size_t lane, const NearestHit& nearest) {
    takes_part_[lane] = 1;
    if (nearest.sphere() == nullptr) return;
    const ScaledSphere& sphere = *nearest.sphere();
    const auto& [x, y, z] = nearest.point();
    center_x_[lane] = sphere.position.x;
    center_y_[lane] = sphere.position.y;
    center_z_[lane] = sphere.position.z;
    c_high_[lane] = sphere.c.high;
    c_low_[lane] = sphere.c.low;
    c_error_[lane] = sphere.c.error + 4.0 * u * std::fabs(sphere.c.low);
    const auto off = [](const Approximate& a) { return std::fabs(a.low) + a.error; };
    const auto& [origin_x, origin_y, origin_z] = nearest.origin(sphere.exponent);
    origin_x_[lane] = origin_x.high;
    origin_y_[lane] = origin_y.high;
    origin_z_[lane] = origin_z.high;
    origin_error_[lane] = std::max({off(origin_x), off(origin_y), off(origin_z)});
    origin_length_[lane] = std::fabs(origin_x.high) + std::fabs(origin_y.high) + std::fabs(origin_z.high);
    origin_square_[lane] = origin_x.high * origin_x.high + origin_y.high * origin_y.high + origin_z.high * origin_z.high;
    const double error = std::max({off(x), off(y), off(z)});
    const double length = std::fabs(x.high) + std::fabs(y.high) + std::fabs(z.high);
    const bool known = 2.0 * error < length && std::isfinite(off(x) + off(y) + off(z));
    x_[lane] = known ? x.high : std::numeric_limits<double>::quiet_NaN();
    y_[lane] = y.high;
    z_[lane] = z.high;
    const auto& [ahead_x, ahead_y, ahead_z] = nearest.ahead();
    ahead_x_[lane] = ahead_x.high;
    ahead_y_[lane] = ahead_y.high;
    ahead_z_[lane] = ahead_z.high;
    const double ahead_length = std::fabs(ahead_x.high) + std::fabs(ahead_y.high) + std::fabs(ahead_z.high);
    square_[lane] = x.high * ahead_x.high + y.high * ahead_y.high + z.high * ahead_z.high;
    error_[lane] = error;
    length_[lane] = length;
    inaccuracy_[lane] = 8.0 * u * ahead_length + 4.0 * error * (ahead_length / length);
    scene_x_[lane] = sphere.sphere->center.x;
    scene_y_[lane] = sphere.sphere->center.y;
    scene_z_[lane] = sphere.sphere->center.z;
    scene_radius_[lane] = sphere.sphere->radius;
    const auto& [cx, cy, cz] = sphere.center;
    sum_x_[lane] = cx.high - 2.0 * x_[lane];
    sum_y_[lane] = cy.high - 2.0 * y.high;
    sum_z_[lane] = cz.high - 2.0 * z.high;
    sum_length_[lane] = std::max({std::fabs(cx.high), std::fabs(cy.high), std::fabs(cz.high)}) + 2.0 * length;
    radius_[lane] = sphere.radius.high;
}

// The sign of c seen from where the rays begin: c - 2 C.Q + Q.Q.
SPHEREVIEW_FOR_EACH_SIMD
DifferenceLanes::Sides DifferenceLanes::sides(const ScaledSphere& sphere) const {
    const double cx = sphere.center[0].high;
    const double cy = sphere.center[1].high;
    const double cz = sphere.center[2].high;
    const double size = std::fabs(cx) + std::fabs(cy) + std::fabs(cz);
    const auto off = [](const Approximate& a) { return std::fabs(a.low) + a.error; };
    const double center_off = std::max({off(sphere.center[0]), off(sphere.center[1]), off(sphere.center[2])});
    const double c = sphere.c.high;
    const double c_off = off(sphere.c);
    Lane<std::int64_t> outside;
    Lane<std::int64_t> inside;
    for (std::size_t i = 0; i < count_; ++i) {
        const double along_x = cx * origin_x_[i];
        const double along_y = cy * origin_y_[i];
        const double along_z = cz * origin_z_[i];
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
        const double apart_x = position.x - center_x_[i];
        const double apart_y = position.y - center_y_[i];
        const double apart_z = position.z - center_z_[i];
        const double along_x = x_[i] * apart_x;
        const double along_y = y_[i] * apart_y;
        const double along_z = z_[i] * apart_z;
        const double c_apart = (c_high - c_high_[i]) + (c_low - c_low_[i]);
        const double power = c_apart - 2.0 * (along_x + along_y + along_z);
        const double terms = std::fabs(c_apart) + 2.0 * (std::fabs(along_x) + std::fabs(along_y) + std::fabs(along_z));
        const double off = error_[i] * (std::fabs(apart_x) + std::fabs(apart_y) + std::fabs(apart_z));
        const double doubt = 1.0625 * (6.0 * u * terms + 2.0 * off + (c_error + c_error_[i])) + too_small;
        // V: is the hit before the middle between the sphere's roots?
        const double before_middle = ahead_x_[i] * cx + ahead_y_[i] * cy + ahead_z_[i] * cz - square_[i];
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
        const double apart_x = scene.center.x - scene_x_[i];
        const double apart_y = scene.center.y - scene_y_[i];
        const double apart_z = scene.center.z - scene_z_[i];
        const double radii_apart = scene.radius - scene_radius_[i];
        const double part_x = apart_x * ((cx + sum_x_[i]) * unit);
        const double part_y = apart_y * ((cy + sum_y_[i]) * unit);
        const double part_z = apart_z * ((cz + sum_z_[i]) * unit);
        const double part_r = radii_apart * ((radius + radius_[i]) * unit);
        const double power = (part_x + part_y + part_z) - part_r;
        const double terms = std::fabs(part_x) + std::fabs(part_y) + std::fabs(part_z) + std::fabs(part_r);
        const double inexact = (4.0 * u * (size + sum_length_[i]) + 2.0 * error_[i] + too_small) * unit;
        const double off = inexact * (std::fabs(apart_x) + std::fabs(apart_y) + std::fabs(apart_z));
        const double off_radius = too_small * unit * std::fabs(radii_apart);
        const double doubt = 1.0625 * (7.0 * u * terms + off + off_radius) + smallest_doubt;
        const double before_middle = ahead_x_[i] * cx + ahead_y_[i] * cy + ahead_z_[i] * cz - square_[i];
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
