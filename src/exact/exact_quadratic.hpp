// The quadratic of a ray and a sphere in exact integers, and comparing roots.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// Integers of any length; up to 1,024 bits, enough for most scenes, without allocating memory.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<1024>>;
using IntegerVector = std::array<Integer, 3>;

// A power of two of which all included doubles are whole multiples.
class CommonScale {
public:
    void include(double value);
    void include(const glm::dvec3& v);
    void include(const Sphere& sphere);
    void include(const Camera& camera);
    // Where the camera's rays begin.
    void include_origins(const Camera& camera);

    // value = whole(value) * 2^exponent(); only for included doubles.
    Integer whole(double value) const;
    IntegerVector whole(const glm::dvec3& v) const;
    int exponent() const { return exponent_; }

private:
    static constexpr int nothing_yet = 5000;  // beyond every double's exponent
    int exponent_ = nothing_yet;
};

Integer dot(const IntegerVector& a, const IntegerVector& b);
IntegerVector difference(const IntegerVector& a, const IntegerVector& b);

// m D of the pixel's ray (scene/camera.hpp) on the scale; the factor m changes no comparison. Orthographic: D.
IntegerVector exact_direction(const Camera& camera, PictureSize size, Pixel pixel, const CommonScale& scale);

// The origin of a ray, times a factor that makes it whole: 1 in perspective, m in an orthographic picture.
struct ExactOrigin {
    IntegerVector place;
    int factor = 1;

    // From the origin to a point, both times the factor.
    IntegerVector to(const IntegerVector& point) const;
};
ExactOrigin exact_origin(const Camera& camera, PictureSize size, Pixel pixel, const CommonScale& scale);

// A t^2 - 2 b t + c = 0 with A = ray . ray, the sphere's centre relative to the origin, and d = b^2 - A c. The sphere and the
// origin are times the origin's factor.
struct ExactQuadratic {
    Integer b;
    Integer c;
    Integer d;

    // square: of the ray, A. The scale is the sphere's and the origin's; the ray may have another.
    ExactQuadratic(const Sphere& sphere, const ExactOrigin& origin, const IntegerVector& ray, const Integer& square,
                   const CommonScale& scale);
};

// The root t = (b + sign sqrt(d)) / A, where b is a multiple of 2^exponent, and d of its square. A belongs to the ray, so roots of
// one pixel are compared without it.
struct ExactRoot {
    Integer b;
    Integer d;
    int sign;
    int exponent = 0;
};

// The sign of x + y sqrt(p), p >= 0.
int sign_with_root(const Integer& x, const Integer& y, const Integer& p);

// The hit: nothing when there is no root or none is positive.
std::optional<ExactRoot> smallest_positive_root(const ExactQuadratic& q);

// The sign of a - b, by squaring twice at most. The exponents may differ.
int compare(const ExactRoot& a, const ExactRoot& b);

}  // namespace sphereview
