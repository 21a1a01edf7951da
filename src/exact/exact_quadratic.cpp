#include "exact/exact_quadratic.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace sphereview {

namespace {

// A finite double other than 0 is mantissa * 2^exponent with an odd mantissa of at most 53 bits.
struct Dyadic {
    std::int64_t mantissa = 0;
    int exponent = 0;
};

Dyadic dyadic(double value) {
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(0x1p53 * std::frexp(value, &exponent));
    if (mantissa == 0) return {};
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    return {mantissa >> zeros, exponent - 53 + zeros};
}

}  // namespace

void CommonScale::include(double value) {
    if (value != 0.0) exponent_ = std::min(exponent_, dyadic(value).exponent);
}

void CommonScale::include(const glm::dvec3& v) {
    include(v.x);
    include(v.y);
    include(v.z);
}

void CommonScale::include(const Sphere& sphere) {
    include(sphere.center);
    include(sphere.radius);
}

void CommonScale::include(const Camera& camera) {
    include(camera.eye);
    include(camera.center);
    include(camera.right);
    include(camera.up);
}

void CommonScale::include_origins(const Camera& camera) {
    include(camera.eye);
    if (!camera.orthographic()) return;
    include(camera.right);
    include(camera.up);
}

Integer CommonScale::whole(double value) const {
    const Dyadic parts = dyadic(value);
    if (parts.mantissa == 0) return 0;
    return Integer(parts.mantissa) << static_cast<unsigned>(parts.exponent - exponent_);
}

IntegerVector CommonScale::whole(const glm::dvec3& v) const { return {whole(v.x), whole(v.y), whole(v.z)}; }

Integer dot(const IntegerVector& a, const IntegerVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

IntegerVector difference(const IntegerVector& a, const IntegerVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

IntegerVector exact_direction(const Camera& camera, PictureSize size, Pixel pixel, const CommonScale& scale) {
    const RayCoefficients coefficients = ray_coefficients(size, pixel);
    const IntegerVector axis = difference(scale.whole(camera.center), scale.whole(camera.eye));
    if (camera.orthographic()) return axis;
    const IntegerVector right = scale.whole(camera.right);
    const IntegerVector up = scale.whole(camera.up);
    IntegerVector d;
    for (std::size_t i = 0; i < 3; ++i) {
        d[i] = axis[i] * size.shorter_side() + right[i] * coefficients.across + up[i] * coefficients.upward;
    }
    return d;
}

ExactOrigin exact_origin(const Camera& camera, PictureSize size, Pixel pixel, const CommonScale& scale) {
    ExactOrigin origin{scale.whole(camera.eye), 1};
    if (!camera.orthographic()) return origin;
    const RayCoefficients coefficients = ray_coefficients(size, pixel);
    const IntegerVector right = scale.whole(camera.right);
    const IntegerVector up = scale.whole(camera.up);
    origin.factor = size.shorter_side();
    for (std::size_t i = 0; i < 3; ++i) {
        origin.place[i] = origin.place[i] * origin.factor + right[i] * coefficients.across + up[i] * coefficients.upward;
    }
    return origin;
}

IntegerVector ExactOrigin::to(const IntegerVector& point) const {
    if (factor == 1) return difference(point, place);
    return {point[0] * factor - place[0], point[1] * factor - place[1], point[2] * factor - place[2]};
}

ExactQuadratic::ExactQuadratic(const Sphere& sphere, const ExactOrigin& origin, const IntegerVector& ray, const Integer& square,
                               const CommonScale& scale) {
    const IntegerVector center = origin.to(scale.whole(sphere.center));
    const Integer radius = scale.whole(sphere.radius) * origin.factor;
    b = dot(center, ray);
    c = dot(center, center) - radius * radius;
    d = b * b - square * c;
}

int sign_with_root(const Integer& x, const Integer& y, const Integer& p) {
    const int sign_x = x.sign();
    const int sign_y = p == 0 ? 0 : y.sign();
    if (sign_x == 0 || sign_y == 0 || sign_x == sign_y) return sign_x == 0 ? sign_y : sign_x;
    const Integer larger = x * x - y * y * p;
    return larger.sign() * sign_x;
}

std::optional<ExactRoot> smallest_positive_root(const ExactQuadratic& q) {
    if (q.d < 0) return std::nullopt;
    if (q.c < 0) return ExactRoot{q.b, q.d, +1};     // the eye is inside: one root each side of it
    if (q.b <= 0) return std::nullopt;               // both roots behind the eye, or at it
    return ExactRoot{q.b, q.d, q.c == 0 ? +1 : -1};  // on the surface the nearer root is 0, which does not count
}

int compare(const ExactRoot& a, const ExactRoot& b) {
    if (a.exponent != b.exponent) {
        const bool a_is_coarser = a.exponent > b.exponent;
        ExactRoot finer = a_is_coarser ? a : b;
        const auto shift = static_cast<unsigned>(std::abs(a.exponent - b.exponent));
        finer.b <<= shift;
        finer.d <<= 2 * shift;
        finer.exponent = std::min(a.exponent, b.exponent);
        return a_is_coarser ? compare(finer, b) : compare(a, finer);
    }
    const Integer x = a.b - b.b;
    const int first = sign_with_root(x, a.sign, a.d);  // of x + a.sign sqrt(a.d)
    const int second = b.d == 0 ? 0 : -b.sign;         // of -b.sign sqrt(b.d)
    if (first == 0 || second == 0 || first == second) return first == 0 ? second : first;
    // (x + a.sign sqrt(a.d))^2 against b.d
    return first * sign_with_root(x * x + a.d - b.d, 2 * a.sign * x, a.d);
}

}  // namespace sphereview
