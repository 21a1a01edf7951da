#include "tiles/pixel_range.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/simd.hpp"
#include "base/square_root.hpp"
#include "exact/filter.hpp"
#include "exact/rays.hpp"

namespace sphereview {

namespace {

constexpr double tolerance = 0x1p-22;       // of |x| + |y| + |z| + r: covers the rounding to float and of the planes
constexpr double in_front_factor = 1.0625;  // of the reach, from the eye's plane: all of the ball is in front of it
constexpr std::size_t lanes = 64;           // spheres at a time

// A sphere and the planes of an axis: the product of its centre with the normal of plane i is base + a step; `reach` is
// the radius and all errors.
struct Product {
    double base;
    double step;
    double reach;
};
// Positive where the ball lies surely and wholly on the side of smaller (or greater) numbers of a plane.
struct Margins {
    double before;
    double beyond;
};
// Whole numbers, kept as doubles: without conversions the compiler can use SIMD.
struct Interval {
    double first;
    double last;
};

PixelAxis make_axis(const glm::dvec3& forward, const glm::dvec3& along, const glm::dvec3& across, int count) {
    PixelAxis axis;
    axis.base = glm::cross(forward, across);
    axis.step = glm::cross(along, across);
    // The direction of the next pixel's ray differs by a multiple of `along`, and must be on the positive side.
    if (glm::dot(along, axis.base) < 0.0) {
        axis.base = -axis.base;
        axis.step = -axis.step;
    }
    axis.base_base = glm::dot(axis.base, axis.base);
    axis.base_step = glm::dot(axis.base, axis.step);
    axis.step_step = glm::dot(axis.step, axis.step);
    axis.count = count;
    return axis;
}

// `edge`: from one origin to the next, a shift of 2.
PixelAxis make_orthographic_axis(const glm::dvec3& forward, const glm::dvec3& edge, const glm::dvec3& across, int count) {
    PixelAxis axis;
    axis.base = glm::cross(forward, across);
    if (glm::dot(edge, axis.base) < 0.0) axis.base = -axis.base;
    axis.shift = -glm::dot(edge, axis.base);
    axis.base_base = glm::dot(axis.base, axis.base);
    axis.count = count;
    return axis;
}

PixelRange range_of(const Interval& columns, const Interval& rows) {
    return {static_cast<int>(columns.first), static_cast<int>(rows.first), static_cast<int>(columns.last),
            static_cast<int>(rows.last)};
}

Product product(const PixelAxis& axis, double x, double y, double z, double reach) {
    return {x * axis.base.x + y * axis.base.y + z * axis.base.z, x * axis.step.x + y * axis.step.y + z * axis.step.z + axis.shift,
            reach};
}

Margins margins(const PixelAxis& axis, const Product& ball, double i) {
    const double a = 2.0 * i + 1.0 - axis.count;
    const double product = ball.base + a * ball.step;
    const double normal_square = axis.base_base + a * (2.0 * axis.base_step + a * axis.step_step);
    const double square = product * std::fabs(product);
    const double reach_square = ball.reach * ball.reach * normal_square;
    return {-square - reach_square, square - reach_square};
}

// For a ball wholly in front of the eye, or any in an orthographic picture.
Interval guess(const PixelAxis& axis, const Product& ball) {
    // Planes that touch: (base + x step)^2 = reach^2 (base_base + 2 x base_step + x^2 step_step). Rounding does not matter.
    const double reach_square = ball.reach * ball.reach;
    const double a = ball.step * ball.step - reach_square * axis.step_step;
    const double half_b = ball.base * ball.step - reach_square * axis.base_step;
    const double c = ball.base * ball.base - reach_square * axis.base_base;
    const double square = half_b * half_b - a * c;
    const double root = square_root(square > 0.0 ? square : 0.0);
    const double inverse = 1.0 / a;
    const double limit = axis.count;
    // Not std::clamp, which passes on what is not a number.
    const auto number_at = [=](double x) {
        const double i = (x - 1.0 + limit) / 2.0;
        const double at_least = i > -1.0 ? i : -1.0;
        return at_least < limit ? at_least : limit;
    };
    // Conversion rounds towards 0, with SIMD on any processor.
    const auto towards_zero = [](double x) { return static_cast<double>(static_cast<int>(x)); };
    const double x_first = number_at((-half_b - root) * inverse);
    const double x_last = number_at((-half_b + root) * inverse);
    const double first = towards_zero(x_first) + (towards_zero(x_first) < x_first ? 1.0 : 0.0);
    const double last = towards_zero(x_last) - (towards_zero(x_last) > x_last ? 1.0 : 0.0);
    return {first > 0.0 ? first : 0.0, last < limit - 1.0 ? last : limit - 1.0};
}

Interval in_front(const PixelAxis& axis, const Product& ball) {
    auto [first, last] = guess(axis, ball);
    // Proven: the ball is wholly on the far side of the plane before `first`, and so of all planes before that one.
    while (first > 0.0 && !(margins(axis, ball, first - 1.0).beyond > 0.0)) --first;
    while (last < axis.count - 1.0 && !(margins(axis, ball, last + 1.0).before > 0.0)) ++last;
    return {first, last};
}

// The planes end at no horizon: a ball beside the eye, or around it, is tried against each.
Interval anywhere(const PixelAxis& axis, const Product& ball) {
    constexpr int worth_trying = 1 << 15;  // of more pixels than this in a row, all: trying them would take too long
    const double end = axis.count;
    if (axis.count > worth_trying) return {0.0, end - 1.0};
    const auto surely_missed = [&](double i) {
        const Margins margin = margins(axis, ball, i);
        return margin.before > 0.0 || margin.beyond > 0.0;
    };
    double first = 0.0;
    while (first < end && surely_missed(first)) ++first;
    double last = end - 1.0;
    while (last > first && surely_missed(last)) --last;
    return {first, last};
}

// Several spheres.
struct Lanes {
    using Lane = std::array<double, lanes>;
    Lane x, y, z, reach;
    Lane left, top, right, bottom;
    Lane known;  // 1: the range above is proven; 0: range() is needed
};

// As in_front() for balls whose guess is right.
void guess_lanes(const PixelAxis& axis, Lanes& balls, std::array<double, lanes>& firsts, std::array<double, lanes>& lasts) {
    for (std::size_t i = 0; i < lanes; ++i) {
        const Product ball = product(axis, balls.x[i], balls.y[i], balls.z[i], balls.reach[i]);
        const auto [first, last] = guess(axis, ball);
        const double begins = margins(axis, ball, first - 1.0).beyond;
        const double ends = margins(axis, ball, last + 1.0).before;
        const double begins_or_edge = first > 0.0 ? begins : 1.0;
        const double ends_or_edge = last < axis.count - 1.0 ? ends : 1.0;
        const double known = balls.known[i];
        const double known_first = begins_or_edge > 0.0 ? known : 0.0;
        firsts[i] = first;
        lasts[i] = last;
        balls.known[i] = ends_or_edge > 0.0 ? known_first : 0.0;
    }
}

// Balls deeper than `front` times their reach can be guessed; all sizes are larger by `further`.
SPHEREVIEW_FOR_EACH_SIMD
void guess_ranges(const PixelAxis& columns, const PixelAxis& rows, const glm::dvec3& view, double front, double further,
                  const glm::vec4* spheres, Lanes& balls) {
    for (std::size_t i = 0; i < lanes; ++i) {
        const double x = spheres[i].x;
        const double y = spheres[i].y;
        const double z = spheres[i].z;
        const double radius = std::fabs(static_cast<double>(spheres[i].w));
        const double reach = radius + tolerance * (std::fabs(x) + std::fabs(y) + std::fabs(z) + radius + further);
        const double depth = x * view.x + y * view.y + z * view.z;
        balls.x[i] = x;
        balls.y[i] = y;
        balls.z[i] = z;
        balls.reach[i] = reach;
        const double in_front = depth > front * reach ? 1.0 : 0.0;
        balls.known[i] = radius > 0.0 ? in_front : 0.0;
    }
    guess_lanes(columns, balls, balls.left, balls.right);
    guess_lanes(rows, balls, balls.top, balls.bottom);
}

}  // namespace

PixelPlanes::PixelPlanes(const Camera& camera, PictureSize size, int scale) {
    const RayBasis<double> basis = ray_basis<double>(camera, size, scale);
    orthographic_ = basis.orthographic;
    reach_ = basis.reach;
    const auto axis_of = orthographic_ ? make_orthographic_axis : make_axis;
    columns_ = axis_of(basis.forward, basis.right, basis.up, size.width);
    rows_ = axis_of(basis.forward, -basis.up, basis.right, size.height);
    const glm::dvec3 normal = glm::cross(basis.right, basis.up);
    const double length = glm::length(normal);
    view_ = normal * ((glm::dot(normal, basis.forward) < 0.0 ? -1.0 : 1.0) / length);

    // Far from where products of four could over- or underflow. The float filter proves nothing beyond either.
    constexpr double most = 0x1p300;
    const auto comfortable = [](double square) { return square > 1.0 / most && square < most; };
    const auto of_axis = [&](const PixelAxis& axis) {
        return comfortable(axis.base_base) && comfortable(orthographic_ ? -axis.shift : axis.step_step);
    };
    usable_ = basis.in_range && comfortable(length) && of_axis(columns_) && of_axis(rows_) &&
              ray_condition(camera) <= largest_float_condition;
}

PixelRange PixelPlanes::range(const glm::vec4& sphere) const {
    const PixelRange everything = {0, 0, columns_.count - 1, rows_.count - 1};
    const glm::dvec3 center(sphere);
    const double distance_sum = taxicab_length(center);
    // The eye on the surface is uploaded as radius 0. The origin with radius 0 marks a sphere about which nothing is known.
    const double radius = sphere.w == 0.0F ? glm::length(center) : std::fabs(static_cast<double>(sphere.w));
    if (!usable_ || distance_sum + radius == 0.0) return everything;

    const double reach = radius + tolerance * (distance_sum + radius + reach_);
    const double depth = glm::dot(center, view_);
    if (depth < -reach) return {};
    const bool wholly_in_front = orthographic_ || depth > in_front_factor * reach;
    const auto interval = [&](const PixelAxis& axis) {
        const Product ball = product(axis, center.x, center.y, center.z, reach);
        return wholly_in_front ? in_front(axis, ball) : anywhere(axis, ball);
    };
    const Interval columns = interval(columns_);
    return columns.last < columns.first ? PixelRange() : range_of(columns, interval(rows_));
}

// A ray that begins in a plane is at least as long as what it hits is deep.
double PixelPlanes::nearest_depth(const glm::vec4& sphere) const {
    return usable_ ? glm::dot(glm::dvec3(sphere), view_) - std::fabs(static_cast<double>(sphere.w)) : 0.0;
}

void PixelPlanes::ranges(std::span<const glm::vec4> spheres, std::span<PixelRange> ranges) const {
    std::size_t i = 0;
    while (usable_ && i + lanes <= spheres.size()) {
        Lanes balls;
        guess_ranges(columns_, rows_, view_, orthographic_ ? -1.0 : in_front_factor, reach_, &spheres[i], balls);
        for (std::size_t lane = 0; lane < lanes; ++lane, ++i) {
            ranges[i] = balls.known[lane] != 0.0
                            ? range_of({balls.left[lane], balls.right[lane]}, {balls.top[lane], balls.bottom[lane]})
                            : range(spheres[i]);
        }
    }
    for (; i < spheres.size(); ++i) ranges[i] = range(spheres[i]);
}

}  // namespace sphereview
