#include "tiles/pixel_range.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "exact/filter.hpp"
#include "exact/rays.hpp"

namespace sphereview {

namespace {

constexpr double tolerance = 0x1p-22;  // of |x| + |y| + |z| + r: covers the rounding to float and of the planes

}  // namespace

PixelPlanes::Axis PixelPlanes::make_axis(const glm::dvec3& forward, const glm::dvec3& along, const glm::dvec3& across, int count) {
    Axis axis;
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

PixelPlanes::PixelPlanes(const Camera& camera, PictureSize size) {
    const RayFrame<double> frame = ray_frame<double>(camera, size);
    columns_ = make_axis(frame.forward, frame.right, frame.up, size.width);
    rows_ = make_axis(frame.forward, -frame.up, frame.right, size.height);
    const glm::dvec3 normal = glm::cross(frame.right, frame.up);
    const double length = glm::length(normal);
    view_ = normal * ((glm::dot(normal, frame.forward) < 0.0 ? -1.0 : 1.0) / length);

    // Far from where products of four could over- or underflow. The float filter proves nothing beyond either.
    constexpr double most = 0x1p300;
    const auto comfortable = [](double square) { return square > 1.0 / most && square < most; };
    usable_ = frame.in_range && comfortable(length) && comfortable(columns_.base_base) && comfortable(columns_.step_step) &&
              comfortable(rows_.base_base) && comfortable(rows_.step_step) && ray_condition(camera) <= largest_float_condition;
}

PixelRange PixelPlanes::range(const glm::vec4& sphere) const {
    const PixelRange everything = {0, 0, columns_.count - 1, rows_.count - 1};
    const glm::dvec3 center(sphere);
    const double distance_sum = std::fabs(center.x) + std::fabs(center.y) + std::fabs(center.z);
    // The eye on the surface is uploaded as radius 0. The origin with radius 0 marks a sphere about which nothing is known.
    const double radius = sphere.w == 0.0F ? glm::length(center) : std::fabs(static_cast<double>(sphere.w));
    if (!usable_ || distance_sum + radius == 0.0) return everything;

    const Ball ball = {center, radius + tolerance * (distance_sum + radius)};
    const double depth = glm::dot(center, view_);
    if (depth < -ball.reach) return {};
    const bool wholly_in_front = depth > 1.0625 * ball.reach;
    const Interval columns = wholly_in_front ? in_front(columns_, ball) : anywhere(columns_, ball);
    if (columns.last < columns.first) return {};
    const Interval rows = wholly_in_front ? in_front(rows_, ball) : anywhere(rows_, ball);
    return {columns.first, rows.first, columns.last, rows.last};
}

int PixelPlanes::side(const Axis& axis, double base, double step, double reach, int i) {
    const double a = 2.0 * i + 1.0 - axis.count;
    const double product = base + a * step;
    const double normal_square = axis.base_base + a * (2.0 * axis.base_step + a * axis.step_step);
    if (!(product * product > reach * reach * normal_square)) return 0;
    return product > 0.0 ? 1 : -1;
}

PixelPlanes::Interval PixelPlanes::in_front(const Axis& axis, const Ball& ball) {
    const double base = glm::dot(ball.center, axis.base);
    const double step = glm::dot(ball.center, axis.step);
    // Planes that touch: (base + x step)^2 = reach^2 (base_base + 2 x base_step + x^2 step_step). The solutions are only a
    // guess, so that their rounding does not matter.
    const double reach_square = ball.reach * ball.reach;
    const double a = step * step - reach_square * axis.step_step;
    const double half_b = base * step - reach_square * axis.base_step;
    const double c = base * base - reach_square * axis.base_base;
    const double root = std::sqrt(std::max(0.0, half_b * half_b - a * c));
    const double inverse = 1.0 / a;
    const double limit = axis.count;
    // Not std::clamp, which passes on what is not a number.
    const auto number_at = [=](double x) {
        const double i = (x - 1.0 + limit) / 2.0;
        return i > -1.0 ? (i < limit ? i : limit) : -1.0;
    };
    int first = static_cast<int>(std::ceil(number_at((-half_b - root) * inverse)));
    int last = static_cast<int>(std::floor(number_at((-half_b + root) * inverse)));

    // Proven: the ball is wholly on the far side of the plane before `first`, and so of all planes before that one.
    first = std::max(0, first);
    while (first > 0 && side(axis, base, step, ball.reach, first - 1) <= 0) --first;
    last = std::min(axis.count - 1, last);
    while (last < axis.count - 1 && side(axis, base, step, ball.reach, last + 1) >= 0) ++last;
    return {first, last};
}

// The planes end at no horizon: a ball beside the eye, or around it, is tried against each.
PixelPlanes::Interval PixelPlanes::anywhere(const Axis& axis, const Ball& ball) {
    constexpr int worth_trying = 1 << 15;  // of more pixels than this in a row, all: trying them would take too long
    if (axis.count > worth_trying) return {0, axis.count - 1};
    const double base = glm::dot(ball.center, axis.base);
    const double step = glm::dot(ball.center, axis.step);
    int first = 0;
    while (first < axis.count && side(axis, base, step, ball.reach, first) != 0) ++first;
    int last = axis.count - 1;
    while (last > first && side(axis, base, step, ball.reach, last) != 0) --last;
    return {first, last};
}

}  // namespace sphereview
