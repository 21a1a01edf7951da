#include "exact/exact_decision.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/visible.hpp"

namespace sphereview {

namespace {

using Integer = boost::multiprecision::cpp_int;
using IntegerVector = std::array<Integer, 3>;

// A finite double is mantissa * 2^exponent with a whole 53-bit mantissa.
struct Dyadic {
    std::int64_t mantissa = 0;
    int exponent = 0;
};

Dyadic dyadic(double value) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return {static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

// The largest power of two that all the doubles shown to it are whole multiples of.
class CommonScale {
public:
    void include(double value) {
        if (value != 0.0) exponent_ = std::min(exponent_, dyadic(value).exponent);
    }
    void include(const glm::dvec3& v) {
        include(v.x);
        include(v.y);
        include(v.z);
    }
    void include(const Sphere& sphere) {
        include(sphere.center);
        include(sphere.radius);
    }
    Integer whole(double value) const {
        const Dyadic parts = dyadic(value);
        if (parts.mantissa == 0) return 0;
        return Integer(parts.mantissa) << static_cast<unsigned>(parts.exponent - exponent_);
    }
    IntegerVector whole(const glm::dvec3& v) const { return {whole(v.x), whole(v.y), whole(v.z)}; }

private:
    int exponent_ = std::numeric_limits<int>::max();
};

Integer dot(const IntegerVector& a, const IntegerVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

IntegerVector difference(const IntegerVector& a, const IntegerVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// m D of the pixel's ray (scene/camera.hpp): D itself is m times shorter, which no comparison notices.
IntegerVector direction(const Camera& camera, PictureSize size, Pixel pixel, const CommonScale& scale) {
    const RayCoefficients coefficients = ray_coefficients(size, pixel);
    const IntegerVector axis = difference(scale.whole(camera.center), scale.whole(camera.eye));
    const IntegerVector right = scale.whole(camera.right);
    const IntegerVector up = scale.whole(camera.up);
    IntegerVector d;
    for (std::size_t i = 0; i < 3; ++i) {
        d[i] = axis[i] * size.shorter_side() + right[i] * coefficients.across + up[i] * coefficients.upward;
    }
    return d;
}

CommonScale scale_of(const Camera& camera) {
    CommonScale scale;
    scale.include(camera.eye);
    scale.include(camera.center);
    scale.include(camera.right);
    scale.include(camera.up);
    return scale;
}

// The terms of A t^2 - 2 b t + c = 0, with the sphere's centre relative to the eye; d = b^2 - A c.
struct Quadratic {
    Integer b;
    Integer c;
    Integer d;

    Quadratic(const Sphere& sphere, const IntegerVector& eye, const IntegerVector& ray, const CommonScale& scale) {
        const IntegerVector center = difference(scale.whole(sphere.center), eye);
        const Integer radius = scale.whole(sphere.radius);
        b = dot(center, ray);
        c = dot(center, center) - radius * radius;
        d = b * b - dot(ray, ray) * c;
    }
};

// The root t = (b + sign sqrt(d)) / A. A belongs to the ray, so roots of one pixel are compared without it.
struct Root {
    Integer b;
    Integer d;
    int sign;
};

std::optional<Root> smallest_positive_root(const Quadratic& q) {
    if (q.d < 0) return std::nullopt;
    if (q.c < 0) return Root{q.b, q.d, +1};      // the eye is inside: one root each side of it
    if (q.b <= 0) return std::nullopt;           // both roots behind the eye, or at it
    return Root{q.b, q.d, q.c == 0 ? +1 : -1};  // on the surface the nearer root is 0, which does not count
}

// The sign of x + y sqrt(p), p >= 0.
int sign_with_root(const Integer& x, const Integer& y, const Integer& p) {
    const int sign_x = x.sign();
    const int sign_y = p == 0 ? 0 : y.sign();
    if (sign_x == 0 || sign_y == 0 || sign_x == sign_y) return sign_x == 0 ? sign_y : sign_x;
    const Integer larger = x * x - y * y * p;
    return larger.sign() * sign_x;
}

// The sign of a - b, by squaring twice at most.
int compare(const Root& a, const Root& b) {
    const Integer x = a.b - b.b;
    const int first = sign_with_root(x, a.sign, a.d);  // of x + a.sign sqrt(a.d)
    const int second = b.d == 0 ? 0 : -b.sign;         // of -b.sign sqrt(b.d)
    if (first == 0 || second == 0 || first == second) return first == 0 ? second : first;
    // (x + a.sign sqrt(a.d))^2 against b.d
    return first * sign_with_root(x * x + a.d - b.d, 2 * a.sign * x, a.d);
}

}  // namespace

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
    CommonScale scale = scale_of(camera);
    for (const Contender& contender : contenders) scale.include(*contender.sphere);
    const IntegerVector ray = direction(camera, size, pixel, scale);
    const IntegerVector eye = scale.whole(camera.eye);

    std::int32_t visible = visible_background;
    std::optional<Root> nearest;
    for (const Contender& contender : contenders) {
        const auto root = smallest_positive_root(Quadratic(*contender.sphere, eye, ray, scale));
        if (!root) continue;
        const int order = nearest ? compare(*root, *nearest) : -1;
        if (order < 0 || (order == 0 && contender.number < visible)) {
            nearest = root;
            visible = contender.number;
        }
    }
    return visible;
}

int discriminant_sign(const Camera& camera, PictureSize size, Pixel pixel, const Sphere& sphere) {
    CommonScale scale = scale_of(camera);
    scale.include(sphere);
    return Quadratic(sphere, scale.whole(camera.eye), direction(camera, size, pixel, scale), scale).d.sign();
}

}  // namespace sphereview
