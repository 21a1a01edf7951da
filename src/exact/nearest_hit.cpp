#include "exact/nearest_hit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "exact/visible.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr int size_exponent = 400;
constexpr double least_scaled = 0x1p-1000;  // what is smaller may have lost bits
constexpr double unknown = std::numeric_limits<double>::infinity();

Approximate dot(const ApproximateVector& a, const ApproximateVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

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

// C.C - r^2
Approximate power_of_eye(const ApproximateVector& center, double radius) {
    Terms terms;
    for (const Approximate& x : center) {
        terms.add_product(x.low, x.low);
        terms.add_product(2.0 * x.high, x.low);
        terms.add_product(x.high, x.high);
    }
    terms.add_product(-radius, radius);
    Approximate c = distilled(std::span(terms.values).first(terms.count));
    c.error += terms.lost;
    return c;
}

}  // namespace

SphereScale::SphereScale(const glm::dvec3& eye, double largest) {
    int exponent = 0;
    std::frexp(largest, &exponent);
    // In two steps, each a power that a double holds; no product in between is out of range if the last is not.
    const int scale = size_exponent - exponent;
    first_ = std::ldexp(1.0, scale / 2);
    second_ = std::ldexp(1.0, scale - scale / 2);
    eye_ = {scaled(eye.x, in_range_), scaled(eye.y, in_range_), scaled(eye.z, in_range_)};
}

double SphereScale::scaled(double value, bool& in_range) const {
    const double result = value * first_ * second_;
    in_range = in_range && (value == 0.0 || std::fabs(result) >= least_scaled);
    return result;
}

ScaledSphere SphereScale::operator()(const Sphere& sphere, std::int32_t number, EyeSide side) const {
    ScaledSphere out;
    out.sphere = &sphere;
    out.number = number;
    out.side = side;
    out.in_range = in_range_;
    for (int axis = 0; axis < 3; ++axis) {
        out.position[axis] = scaled(sphere.center[axis], out.in_range);
        out.center[static_cast<std::size_t>(axis)] = Approximate(two_sum(out.position[axis], -eye_[axis]), 0.0);
    }
    const double radius = scaled(sphere.radius, out.in_range);
    if (out.in_range && side != EyeSide::on_surface) out.c = power_of_eye(out.center, radius);
    return out;
}

ExactBasis::ExactBasis(const Camera& camera) {
    ApproximateVector axis;
    double largest = 0.0;
    for (int i = 0; i < 3; ++i) {
        axis[static_cast<std::size_t>(i)] = Approximate(two_sum(camera.center[i], -camera.eye[i]), 0.0);
        largest = std::max(largest, std::fabs(camera.center[i] - camera.eye[i]));
    }
    int exponent = 0;
    std::frexp(largest, &exponent);
    in_range = std::isfinite(largest) && largest > 0.0;
    const auto scaled = [&](double value) {
        const double result = std::ldexp(value, -exponent);
        in_range = in_range && (value == 0.0 || std::fabs(result) >= least_scaled);
        return result;
    };
    for (int i = 0; i < 3; ++i) {
        const Approximate& component = axis[static_cast<std::size_t>(i)];
        forward[static_cast<std::size_t>(i)] = Approximate({scaled(component.high), scaled(component.low)}, 0.0);
        right[i] = scaled(camera.right[i]);
        up[i] = scaled(camera.up[i]);
    }
    // Coefficients stay below 2^32, rays below 2^62.
    in_range = in_range && largest_of(right) < 0x1p28 && largest_of(up) < 0x1p28;
}

NearestHit::NearestHit(const Camera& camera, const ExactBasis& basis, PictureSize size, Pixel pixel)
    : camera_(camera), size_(size), pixel_(pixel), in_range_(basis.in_range) {
    if (!in_range_) return;
    const RayCoefficients coefficients = ray_coefficients(size, pixel);
    const Approximate m(size.shorter_side());
    const Approximate across(static_cast<double>(coefficients.across));
    const Approximate upward(static_cast<double>(coefficients.upward));
    for (int i = 0; i < 3; ++i) {
        ray_[static_cast<std::size_t>(i)] = m * basis.forward[static_cast<std::size_t>(i)] + across * Approximate(basis.right[i]) +
                                            upward * Approximate(basis.up[i]);
    }
    square_ = dot(ray_, ray_);
}

std::int32_t NearestHit::visible() const { return best_ ? best_->sphere.number : visible_background; }

Approximate NearestHit::along(const ScaledSphere& sphere) const { return dot(sphere.center, ray_); }

Approximate NearestHit::discriminant(const ScaledSphere& sphere, const Approximate& b) const { return b * b - square_ * sphere.c; }

NearestHit::Best NearestHit::best_of(const ScaledSphere& sphere) const {
    Best best;
    best.sphere = sphere;
    if (!in_range_ || !sphere.in_range) {
        best.point[0].error = unknown;
        return best;
    }
    const Approximate b = along(sphere);
    const Approximate root = sqrt(discriminant(sphere, b));
    // Without differences of what may be nearly equal.
    const Approximate t = sphere.side == EyeSide::outside      ? sphere.c / (b + root)
                          : sphere.side == EyeSide::on_surface ? b.twice() / square_
                          : b.high >= 0.0                      ? (b + root) / square_
                                                               : sphere.c / (b - root);
    best.square_t = square_ * t;
    for (std::size_t i = 0; i < 3; ++i) best.point[i] = t * ray_[i];
    return best;
}

std::optional<int> NearestHit::order_of_the_first(const ScaledSphere& sphere) const {
    if (sphere.side == EyeSide::inside) return -1;
    const Approximate b = along(sphere);
    const auto before = b.sign();
    if (!before) return std::nullopt;
    if (*before <= 0) return 1;
    if (sphere.side == EyeSide::on_surface) return -1;
    const auto roots = discriminant(sphere, b).sign();
    if (!roots) return std::nullopt;
    return *roots >= 0 ? -1 : 1;
}

std::optional<int> NearestHit::order(const ScaledSphere& sphere) const {
    // The power of the best hit's point with respect to the sphere, in which all that both spheres share cancels exactly.
    Approximate power = sphere.c - best_->sphere.c;
    for (int axis = 0; axis < 3; ++axis) {
        const Approximate apart(two_sum(sphere.position[axis], -best_->sphere.position[axis]), 0.0);
        power = power - (best_->point[static_cast<std::size_t>(axis)] * apart).twice();
    }
    const auto beyond = power.sign();
    if (!beyond) return std::nullopt;
    if (sphere.side == EyeSide::inside) return -*beyond;
    if (sphere.side == EyeSide::outside && *beyond < 0) return -1;
    const Approximate b = along(sphere);
    const auto before = b.sign();
    if (sphere.side == EyeSide::on_surface) {
        if (!before) return std::nullopt;
        return *before <= 0 ? 1 : -*beyond;
    }
    // Is the point before the middle between the roots, where b = A t?
    const auto before_middle = (b - best_->square_t).sign();
    if (!before_middle) return std::nullopt;
    if (*before_middle >= 0) return *beyond;
    if (*beyond == 0) return -1;
    if (!before) return std::nullopt;
    if (*before <= 0) return 1;
    const auto roots = discriminant(sphere, b).sign();
    if (!roots) return std::nullopt;
    return *roots >= 0 ? -1 : 1;
}

const ExactRay& NearestHit::exact_ray() {
    if (!exact_ray_) exact_ray_ = std::make_unique<ExactRay>(camera_, size_, pixel_);
    return *exact_ray_;
}

bool NearestHit::challenge(const ScaledSphere& sphere) {
    if (best_ && best_->sphere.number == sphere.number) return false;
    std::optional<int> order_of_hits;
    std::optional<ExactRoot> exact;
    const bool in_range = in_range_ && sphere.in_range && (!best_ || best_->sphere.in_range);
    if (in_range) order_of_hits = best_ ? order(sphere) : order_of_the_first(sphere);
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
