#include "exact/nearest_hit.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "exact/visible.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double least_scaled = 0x1p-1000;  // what is smaller may have lost bits

// A number on a scale. What would be smaller than least_scaled becomes 0, and least_scaled goes to `error`: so nothing that may
// have lost bits is computed with, and what it was is within the error.
double unless_too_small(double value, double scaled, double& error) {
    if (value == 0.0 || std::fabs(scaled) >= least_scaled) return scaled;
    error = least_scaled;
    return 0.0;
}

// The sum times 2^exponent, within `error` and what is lost of it.
Approximate times_power(const TwoDoubles& sum, double error, int exponent) {
    double lost = 0.0;
    const double high = unless_too_small(sum.high, std::ldexp(sum.high, exponent), lost);
    const double low = unless_too_small(sum.low, std::ldexp(sum.low, exponent), lost);
    return {{high, low}, error + 2.0 * lost};
}

// The sum of the terms, which it overwrites: exact if two doubles can hold it. Each pass leaves the sum of the doubles as it is,
// the rounded sum in the last, and the errors in the others (Ogita, Rump and Oishi, "Accurate sum and dot product", 2005).
Approximate distilled(std::span<double> terms) {
    constexpr int most_passes = 6;
    const std::size_t last = terms.size() - 1;
    double rest = 0.0;
    for (int pass = 0; pass < most_passes; ++pass) {
        for (std::size_t i = 0; i < last; ++i) {
            const TwoDoubles sum = two_sum(terms[i], terms[i + 1]);
            terms[i] = sum.low;
            terms[i + 1] = sum.high;
        }
        rest = 0.0;
        for (std::size_t i = 0; i + 1 < last; ++i) rest += std::fabs(terms[i]);
        if (rest == 0.0) break;
    }
    return {two_sum(terms[last], terms[last - 1]), rest * Approximate::margin};
}

// Terms of a sum; `lost` bounds what underflow took from them.
struct Terms {
    std::array<double, 20> values{};
    std::size_t count = 0;
    double lost = 0.0;

    void add_product(double a, double b) {
        if (a == 0.0 || b == 0.0) return;
        const TwoDoubles product = two_product(a, b);
        if (std::fabs(product.high) < Approximate::least_exact) lost += Approximate::underflow;
        values[count++] = product.low;
        values[count++] = product.high;
    }
};

// C.C - r^2. The square of a number x that is off by e is off by 2 |x| e + e^2, which is at most 2 (|x| + e) e.
Approximate power_of_eye(const ApproximateVector& center, const Approximate& radius) {
    Terms terms;
    for (const Approximate& x : center) {
        terms.add_product(x.low, x.low);
        terms.add_product(2.0 * x.high, x.low);
        terms.add_product(x.high, x.high);
    }
    terms.add_product(-radius.high, radius.high);
    for (const Approximate& x : {center[0], center[1], center[2], radius}) {
        if (x.error > 0.0) terms.lost += 2.0 * x.most() * x.error + Approximate::underflow;  // the product may underflow
    }
    Approximate c = terms.count == 0 ? Approximate() : distilled(std::span(terms.values).first(terms.count));
    c.error += terms.lost * Approximate::margin;
    return c;
}

}  // namespace

Approximate moved(const Approximate& value, int exponent) {
    const double error = value.error > 0.0 ? std::max(std::ldexp(value.error, exponent), least_scaled) : 0.0;
    return times_power({value.high, value.low}, error, exponent);
}

double size_from(const glm::dvec3& eye, const Sphere& sphere) { return std::max(largest_of(sphere.center - eye), sphere.radius); }

SphereScale::SphereScale(const glm::dvec3& eye, double largest) : eye_(eye) {
    constexpr int beyond_doubles = 1025;        // the exponent of what overflows
    if (!std::isfinite(largest)) part_ = 0.25;  // the bits that the smallest doubles lose so are too small for this scale anyway
    exponent_ = size_exponent - (std::isfinite(largest) ? exponent_of(largest) : beyond_doubles);
    // In two steps, each a power that a double holds; no product in between is out of range if the last is not.
    first_ = std::ldexp(1.0, exponent_ / 2);
    second_ = std::ldexp(1.0 / part_, exponent_ - exponent_ / 2);
}

ScaledSphere SphereScale::operator()(const Sphere& sphere, std::int32_t number, EyeSide side) const {
    ScaledSphere out;
    out.sphere = &sphere;
    out.number = number;
    out.side = side;
    out.exponent = exponent_;
    const auto kept = [&](double value, double& error) { return unless_too_small(value, scaled(value), error); };
    for (int axis = 0; axis < 3; ++axis) {
        const double x = part_ * sphere.center[axis];
        out.position[axis] = kept(x, out.position_error);
        const TwoDoubles apart = two_sum(x, -part_ * eye_[axis]);
        double error = 0.0;
        const TwoDoubles parts{kept(apart.high, error), kept(apart.low, error)};
        out.center[static_cast<std::size_t>(axis)] = Approximate(parts, 2.0 * error);
    }
    double radius_error = 0.0;
    out.radius = Approximate({kept(part_ * sphere.radius, radius_error), 0.0}, radius_error);
    if (side != EyeSide::on_surface) out.c = power_of_eye(out.center, out.radius);
    return out;
}

ExactBasis::ExactBasis(const Camera& camera) {
    // A difference of numbers near the largest would overflow: of quarters it does not, and the bits that the smallest numbers then
    // lose lie far below what counts beside it.
    const bool quarters = !std::isfinite(largest_of(camera.center - camera.eye));
    const double part = quarters ? 0.25 : 1.0;
    std::array<TwoDoubles, 3> axis{};
    const double largest_edge = part * std::max(largest_of(camera.right), largest_of(camera.up));
    double largest = camera.orthographic() ? 0.0 : largest_edge;
    for (int i = 0; i < 3; ++i) {
        TwoDoubles& component = axis[static_cast<std::size_t>(i)];
        component = two_sum(part * camera.center[i], -part * camera.eye[i]);
        largest = std::max(largest, std::fabs(component.high));
    }
    const int exponent = exponent_of(largest);
    // Directions and origins of rays have powers of two of their own.
    orthographic = camera.orthographic();
    const int of_edges = orthographic ? exponent_of(largest_edge) : exponent;
    edge_exponent = quarters ? of_edges + 2 : of_edges;
    // Coefficients stay below 2^32, rays below 2^62.
    const auto scaled = [&](double value, int by) { return unless_too_small(value, std::ldexp(value, -by), error); };
    for (int i = 0; i < 3; ++i) {
        const TwoDoubles& component = axis[static_cast<std::size_t>(i)];
        forward[static_cast<std::size_t>(i)] =
            Approximate({scaled(component.high, exponent), scaled(component.low, exponent)}, 0.0);
        right[i] = scaled(part * camera.right[i], of_edges);
        up[i] = scaled(part * camera.up[i], of_edges);
    }
    // Both parts of a component may have been too small.
    for (Approximate& component : forward) component.error = 2.0 * error;
}

ApproximateVector ExactBasis::in_plane(PictureSize size, Pixel pixel) const {
    const RayCoefficients coefficients = ray_coefficients(size, pixel);
    const Approximate across(static_cast<double>(coefficients.across));
    const Approximate upward(static_cast<double>(coefficients.upward));
    const auto within = [&](double value) { return Approximate({value, 0.0}, error); };
    ApproximateVector out;
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = static_cast<int>(i);
        out[i] = across * within(right[axis]) + upward * within(up[axis]);
    }
    return out;
}

ApproximateVector ExactBasis::origin(PictureSize size, Pixel pixel, int exponent) const {
    if (!orthographic) return {};
    const Approximate m(size.shorter_side());
    ApproximateVector out = in_plane(size, pixel);
    for (Approximate& component : out) component = moved(component / m, edge_exponent + exponent);
    return out;
}

ApproximateVector ExactBasis::ray(PictureSize size, Pixel pixel) const {
    if (orthographic) return forward;
    const Approximate m(size.shorter_side());
    ApproximateVector out = in_plane(size, pixel);
    for (std::size_t i = 0; i < 3; ++i) out[i] = m * forward[i] + out[i];
    return out;
}

NearestHit::NearestHit(const Camera& camera, const ExactBasis& basis, PictureSize size, Pixel pixel)
    : camera_(camera), basis_(basis), size_(size), pixel_(pixel), ray_(basis.ray(size, pixel)), square_(dot(ray_, ray_)) {}

std::int32_t NearestHit::visible() const { return best_ ? best_->sphere.number : visible_background; }

const ApproximateVector& NearestHit::origin(int exponent) const {
    if (basis_.orthographic && origin_exponent_ != exponent) {
        origin_ = basis_.origin(size_, pixel_, exponent);
        origin_exponent_ = exponent;
    }
    return origin_;
}

ApproximateVector NearestHit::center(const ScaledSphere& sphere) const {
    if (!basis_.orthographic) return sphere.center;
    const auto& [x, y, z] = origin(sphere.exponent);
    return {sphere.center[0] - x, sphere.center[1] - y, sphere.center[2] - z};
}

Approximate NearestHit::c(const ScaledSphere& sphere) const {
    if (!basis_.orthographic) return sphere.c;
    const ApproximateVector from_origin = center(sphere);
    return dot(from_origin, from_origin) - sphere.radius * sphere.radius;
}

// The side of the ray's origin, if 106 bits are enough.
std::optional<EyeSide> NearestHit::side(const ScaledSphere& sphere) const {
    if (sphere.side != EyeSide::in_plane) return sphere.side;
    const auto sign = c(sphere).sign();
    if (!sign) return std::nullopt;
    return *sign > 0 ? EyeSide::outside : *sign < 0 ? EyeSide::inside : EyeSide::on_surface;
}

Approximate NearestHit::along(const ScaledSphere& sphere) const { return dot(center(sphere), ray_); }

Approximate NearestHit::discriminant(const ScaledSphere& sphere, const Approximate& b) const { return b * b - square_ * c(sphere); }

NearestHit::Best NearestHit::best_of(const ScaledSphere& sphere) const {
    Best best;
    best.sphere = sphere;
    const Approximate b = along(sphere);
    const Approximate root = sqrt(discriminant(sphere, b));
    // Without differences of what may be nearly equal.
    // A side that 106 bits cannot tell was told by integers.
    const auto known_side = side(sphere);
    const EyeSide of_origin = known_side ? *known_side : origin_side(*sphere.sphere, sphere.side, camera_, size_, pixel_);
    const Approximate t = of_origin == EyeSide::outside      ? c(sphere) / (b + root)
                          : of_origin == EyeSide::on_surface ? b.twice() / square_
                          : b.high >= 0.0                    ? (b + root) / square_
                                                             : c(sphere) / (b - root);
    best.square_t = square_ * t;
    const ApproximateVector& begin = origin(sphere.exponent);
    for (std::size_t i = 0; i < 3; ++i) best.point[i] = basis_.orthographic ? begin[i] + t * ray_[i] : t * ray_[i];
    return best;
}

std::optional<int> NearestHit::order_of_the_first(const ScaledSphere& sphere) const {
    const auto of_origin = side(sphere);
    if (!of_origin) return std::nullopt;
    if (*of_origin == EyeSide::inside) return -1;
    const Approximate b = along(sphere);
    if (*of_origin == EyeSide::outside) return order_before_all(sphere, b);
    const auto before = b.sign();
    if (!before) return std::nullopt;
    return *before <= 0 ? 1 : -1;
}

// Seen from outside, a sphere is missed without roots, wherever it lies, and behind the eye, whether it has roots or not.
std::optional<int> NearestHit::order_before_all(const ScaledSphere& sphere, const Approximate& b) const {
    const auto before = b.sign();
    if (before && *before <= 0) return 1;
    const auto roots = discriminant(sphere, b).sign();
    if (roots && *roots < 0) return 1;
    if (!before || !roots) return std::nullopt;
    return -1;
}

Approximate NearestHit::power(const ScaledSphere& sphere) const {
    Approximate power = sphere.c - best_->sphere.c;
    const double error = sphere.position_error + best_->sphere.position_error;
    for (int axis = 0; axis < 3; ++axis) {
        const Approximate apart(two_sum(sphere.position[axis], -best_->sphere.position[axis]), error);
        power = power - (best_->point[static_cast<std::size_t>(axis)] * apart).twice();
    }
    return power;
}

// The same power as a sum in which each term has a difference of the two spheres for a factor: however small these are beside the
// spheres, even too small for the spheres' scale, they are exact, and may be multiplied by a power of two of their own.
std::optional<int> NearestHit::power_sign_by_differences(const ScaledSphere& sphere) const {
    const ScaledSphere& best = best_->sphere;
    std::array<TwoDoubles, 4> apart{};
    for (int axis = 0; axis < 3; ++axis) {
        apart[static_cast<std::size_t>(axis)] = two_sum(sphere.sphere->center[axis], -best.sphere->center[axis]);
    }
    apart[3] = two_sum(sphere.sphere->radius, -best.sphere->radius);
    double largest = 0.0;
    for (const TwoDoubles& difference : apart) {
        if (!std::isfinite(difference.high)) return std::nullopt;
        largest = std::max(largest, std::fabs(difference.high));
    }
    const int exponent = exponent_of(largest);
    const auto scaled = [&](const TwoDoubles& difference) { return times_power(difference, 0.0, -exponent); };
    Approximate power = -(scaled(apart[3]) * (sphere.radius + best.radius));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        power = power + scaled(apart[axis]) * (sphere.center[axis] + best.center[axis] - best_->point[axis].twice());
    }
    return power.sign();
}

std::optional<int> NearestHit::order(const ScaledSphere& sphere) const {
    // In the power of the best hit's point with respect to the sphere all that both spheres share cancels exactly.
    auto beyond = power(sphere).sign();
    if (!beyond) beyond = power_sign_by_differences(sphere);
    const auto of_origin = side(sphere);
    if (!beyond || !of_origin) return std::nullopt;
    if (*of_origin == EyeSide::inside) return -*beyond;
    if (*of_origin == EyeSide::outside && *beyond < 0) return -1;
    const Approximate b = along(sphere);
    const auto before = b.sign();
    if (*of_origin == EyeSide::on_surface) {
        if (!before) return std::nullopt;
        return *before <= 0 ? 1 : -*beyond;
    }
    // Is the point before the middle between the roots, where b = A t?
    const auto before_middle = (b - best_->square_t).sign();
    if (!before_middle) return std::nullopt;
    if (*before_middle >= 0) return *beyond;
    if (*beyond == 0) return -1;
    return order_before_all(sphere, b);
}

void NearestHit::rescale(const SphereScale& scale) {
    if (!best_) return;
    const int shift = scale.exponent() - best_->sphere.exponent;
    if (shift == 0) return;
    // The hit itself is moved, and not found anew: of a sphere that is far too small for the scale nothing could be said.
    for (Approximate* value : {&best_->square_t, &best_->point[0], &best_->point[1], &best_->point[2]}) {
        *value = moved(*value, shift);
    }
    best_->sphere = scale(*best_->sphere.sphere, best_->sphere.number, best_->sphere.side);
}

const ExactRay& NearestHit::exact_ray() {
    if (!exact_ray_) exact_ray_ = std::make_unique<ExactRay>(camera_, size_, pixel_);
    return *exact_ray_;
}

bool NearestHit::challenge(const ScaledSphere& sphere) {
    if (best_ && best_->sphere.number == sphere.number) return false;
    std::optional<ExactRoot> exact;
    std::optional<int> order_of_hits = best_ ? order(sphere) : order_of_the_first(sphere);
    if (!order_of_hits) {
        ++in_integers_;
        exact = exact_ray().hit(*sphere.sphere);
        if (!exact) return false;
        if (best_ && !best_->exact) best_->exact = exact_ray().hit(*best_->sphere.sphere);
        order_of_hits = best_ ? compare(*exact, *best_->exact) : -1;
    }
    if (*order_of_hits > 0 || (*order_of_hits == 0 && sphere.number > best_->sphere.number)) return false;
    best_ = best_of(sphere);
    best_->exact = std::move(exact);
    return true;
}

}  // namespace sphereview
