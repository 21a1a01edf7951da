#include "oracle/long_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "oracle/oracle.hpp"

namespace sphereview::oracle {

namespace {

using Real = long double;

// A value computed by + - x alone, and the same with every sign positive: the rounding errors of n operations in a row are
// at most n epsilon times that (Higham, "Accuracy and Stability of Numerical Algorithms", 3.1). Underflow of products is
// covered as long as the size is far above the smallest normal number, which a decision demands.
struct Tracked {
    Real value = 0;
    Real size = 0;

    Tracked() = default;
    Tracked(double exact) : value(exact), size(std::fabs(value)) {}
    Tracked(Real new_value, Real new_size) : value(new_value), size(new_size) {}

    friend Tracked operator+(const Tracked& x, const Tracked& y) { return {x.value + y.value, x.size + y.size}; }
    friend Tracked operator-(const Tracked& x, const Tracked& y) { return {x.value - y.value, x.size + y.size}; }
    friend Tracked operator*(const Tracked& x, const Tracked& y) { return {x.value * y.value, x.size * y.size}; }

    // More than the operations of any chain below, doubled.
    Real error() const { return 128 * std::numeric_limits<Real>::epsilon() * size; }
    bool is_in_range() const { return size < Real(1) / tiny && (size > tiny || size == 0); }
    // -1 or 1, or 0 when the rounding hides it.
    int sign() const { return !is_in_range() || std::fabs(value) <= error() ? 0 : value < 0 ? -1 : 1; }

    static constexpr Real tiny = std::numeric_limits<Real>::min_exponent < -16000 ? 1e-2000L : 1e-100L;
};

struct TrackedVector {
    Tracked x;
    Tracked y;
    Tracked z;

    TrackedVector(const Tracked& new_x, const Tracked& new_y, const Tracked& new_z) : x(new_x), y(new_y), z(new_z) {}
    explicit TrackedVector(const glm::dvec3& v) : x(v.x), y(v.y), z(v.z) {}

    // Of exact numbers: one rounding, relative to the result however much cancels.
    TrackedVector(const glm::dvec3& to, const glm::dvec3& from)
        : x(rounded_once(to.x, from.x)), y(rounded_once(to.y, from.y)), z(rounded_once(to.z, from.z)) {}

    static Tracked rounded_once(double to, double from) {
        const Real value = static_cast<Real>(to) - static_cast<Real>(from);
        return {value, std::fabs(value)};
    }
    friend Tracked dot(const TrackedVector& a, const TrackedVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
};

// b is linear in the pixel, as in the oracle; c belongs to the sphere.
struct Terms {
    std::int32_t number;
    Tracked forward;
    Tracked right;
    Tracked up;
    Tracked c;
    int side;  // the sign of c
};

// A t of the hit; surely missed spheres have none.
struct Interval {
    Real low;
    Real high;
};

enum class Answer { missed, hit, unknown };

Answer hit_of(const Terms& terms, const Tracked& a, const Tracked& b, Interval& interval) {
    const Tracked discriminant = b * b - a * terms.c;
    const int sign = discriminant.sign();
    if (sign < 0) return Answer::missed;
    const int toward = b.sign();
    if (terms.side > 0 && toward < 0) return Answer::missed;
    if (sign == 0 || (terms.side >= 0 && toward == 0) || !b.is_in_range()) return Answer::unknown;
    if (terms.side == 0) {
        if (toward < 0) return Answer::missed;
        interval = {2 * (b.value - b.error()), 2 * (b.value + b.error())};
        return Answer::hit;
    }
    const Real root = std::sqrt(discriminant.value);
    // |sqrt(d + e) - sqrt(d)| <= |e| / sqrt(d); the last part is for the rounding here.
    const Real error = b.error() + discriminant.error() / root + 8 * std::numeric_limits<Real>::epsilon() * (root + b.size);
    const Real value = terms.side > 0 ? b.value - root : b.value + root;
    interval = {value - error, value + error};
    return Answer::hit;
}

class Filter {
public:
    Filter(const Scene& scene, PictureSize size)
        : size_(size), forward_(scene.camera.center, scene.camera.eye), right_(scene.camera.right), up_(scene.camera.up) {
        const Tracked m(static_cast<double>(std::min(size.width, size.height)));
        forward_ = {forward_.x * m, forward_.y * m, forward_.z * m};
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            const Sphere& sphere = scene.spheres[i];
            if (sphere.hidden) continue;
            const TrackedVector center(sphere.center, scene.camera.eye);
            const Tracked radius(sphere.radius);
            terms_.push_back({static_cast<std::int32_t>(i), dot(center, forward_), dot(center, right_), dot(center, up_),
                              dot(center, center) - radius * radius, eye_side(sphere, scene.camera.eye)});
        }
    }

    // False: long double does not decide.
    bool decide(Pixel pixel, std::int32_t& number) const {
        const Tracked across(2.0 * pixel.x + 1 - size_.width);
        const Tracked upward(size_.height - 1 - 2.0 * pixel.y);
        const TrackedVector d{forward_.x + across * right_.x + upward * up_.x, forward_.y + across * right_.y + upward * up_.y,
                              forward_.z + across * right_.z + upward * up_.z};
        const Tracked a = dot(d, d);
        if (a.sign() <= 0) return false;
        Interval nearest{0, std::numeric_limits<Real>::infinity()};
        Real next = std::numeric_limits<Real>::infinity();  // the lower end of what is second nearest
        number = -1;
        for (const Terms& terms : terms_) {
            Interval interval{};
            const Answer answer = hit_of(terms, a, terms.forward + across * terms.right + upward * terms.up, interval);
            if (answer == Answer::unknown) return false;
            if (answer == Answer::missed) continue;
            if (number < 0 || interval.low < nearest.low) {
                if (number >= 0) next = std::min(next, nearest.low);
                nearest = interval;
                number = terms.number;
            } else {
                next = std::min(next, interval.low);
            }
        }
        return number < 0 || nearest.high < next;
    }

private:
    PictureSize size_;
    TrackedVector forward_;
    TrackedVector right_;
    TrackedVector up_;
    std::vector<Terms> terms_;
};

}  // namespace

FilteredPicture filtered_picture(const Scene& scene, PictureSize size) {
    const Filter filter(scene, size);
    FilteredPicture picture;
    picture.numbers.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    std::vector<char> decided(picture.numbers.size());
    const auto width = static_cast<std::size_t>(size.width);
    const auto pixel_at = [&](std::size_t i) { return Pixel{static_cast<int>(i % width), static_cast<int>(i / width)}; };
    parallel_pieces(decided.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) decided[i] = filter.decide(pixel_at(i), picture.numbers[i]) ? 1 : 0;
    });

    std::vector<Pixel> undecided;
    for (std::size_t i = 0; i < decided.size(); ++i) {
        if (decided[i] == 0) undecided.push_back(pixel_at(i));
    }
    const std::vector<std::int32_t> numbers = pixels(scene, size, undecided);
    auto next = numbers.begin();
    for (std::size_t i = 0; i < decided.size(); ++i) {
        if (decided[i] == 0) picture.numbers[i] = *next++;
    }
    picture.by_the_oracle = undecided.size();
    return picture;
}

}  // namespace sphereview::oracle
