#include "exact/approximate_light.hpp"

#include <algorithm>
#include <cmath>

#include "exact/exact_decision.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// More than what a few operations on bounds round.
constexpr double roundings = 1.0 + 0x1p-40;
constexpr double few_parts = 0x1p-45;

// Other spheres may be larger by this without a scale of their own.
constexpr double room_for_others = 0x1p64;

// The direction times a power of two of its own, with a largest component below 1: its length changes no sign.
ApproximateVector scaled_direction(const glm::dvec3& direction) {
    const int exponent = exponent_of(largest_of(direction));
    return {moved(direction.x, -exponent), moved(direction.y, -exponent), moved(direction.z, -exponent)};
}

ApproximateVector apart(const ApproximateVector& a, const ApproximateVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// The smallest scale that a sphere needs.
double least_size(const glm::dvec3& eye, const Sphere& sphere) {
    const double size = size_from(eye, sphere);
    return std::max(size * room_for_others, size);
}

Shadow shadow_by_signs(const std::optional<int>& along, const std::optional<int>& disc) {
    if ((along && *along >= 0) || (disc && *disc < 0)) return Shadow::none;
    return along && disc ? Shadow::all : Shadow::unsure;
}

}  // namespace

ApproximateLitPoint::ApproximateLitPoint(const Camera& camera, const ExactBasis& basis, PictureSize size, Pixel pixel,
                                         const Sphere& sphere, EyeSide side)
    : camera_(camera),
      basis_(basis),
      size_(size),
      pixel_(pixel),
      sphere_(sphere),
      side_(side),
      outside_(origin_side(sphere, side, camera, size, pixel) == EyeSide::outside),
      largest_(least_size(camera.eye, sphere)),
      scale_(camera.eye, largest_),
      hit_(camera, basis, size, pixel) {
    hit_.take(scale_(sphere, 0, side));
}

std::optional<int> ApproximateLitPoint::facing(const glm::dvec3& direction) const {
    const ApproximateVector m = apart(hit_.point(), hit_.sphere()->center);
    const std::optional<int> sign = dot(m, scaled_direction(direction)).sign();
    if (!sign) return std::nullopt;
    return outside_ ? *sign : -*sign;
}

Shadow ApproximateLitPoint::shadow(const Sphere& other, const glm::dvec3& direction) const {
    const double size = size_from(camera_.eye, other);
    if (size <= largest_) return shadow_of(scale_(other, 0, EyeSide::outside), hit_, direction);
    const SphereScale larger(camera_.eye, size);
    NearestHit hit(camera_, basis_, size_, pixel_);
    hit.take(scale_(sphere_, 0, side_));
    hit.rescale(larger);
    return shadow_of(larger(other, 0, EyeSide::outside), hit, direction);
}

Shadow ApproximateLitPoint::shadow_of(const ScaledSphere& other, const NearestHit& hit, const glm::dvec3& direction) const {
    const ApproximateVector l = scaled_direction(direction);
    const Approximate along = dot(apart(hit.point(), other.center), l);
    const std::optional<int> sign = along.sign();
    if (sign && *sign >= 0) return Shadow::none;
    return shadow_by_signs(sign, (along * along - dot(l, l) * hit.power(other)).sign());
}

Shadow approximate_shadow(const PointBall& ball, const glm::dvec3& eye, const Sphere& other, const glm::dvec3& direction) {
    const double reach = std::ldexp(largest_of(ball.point) + ball.error, -ball.exponent);
    const SphereScale scale(eye, std::max(size_from(eye, other), reach));
    const ScaledSphere sphere = scale(other, 0, EyeSide::on_surface);  // what other sides need is not needed here
    const int shift = scale.exponent() - ball.exponent;
    const double error = std::ldexp(ball.error, shift) + Approximate::underflow;
    const ApproximateVector point = {moved(ball.point.x, shift), moved(ball.point.y, shift), moved(ball.point.z, shift)};
    const ApproximateVector m = apart(point, sphere.center);
    const ApproximateVector l = scaled_direction(direction);
    const Approximate square = dot(l, l);

    // Of the middle, then of all points.
    Approximate along = dot(m, l);
    Approximate disc = along * along - square * (dot(m, m) - sphere.radius * sphere.radius);
    along.error += roundings * error * square_root(square.high);
    if (along.sign().value_or(-1) > 0) return Shadow::none;
    // The square of the distance from the middle of the disc is r^2 - disc / square.
    const double r = sphere.radius.high;
    const double most_across = r * r - disc.high / square.high + few_parts * (r * r + std::fabs(disc.high) / square.high);
    const double across = square_root(std::max(most_across, 0.0) + roundings * disc.error / square.high);
    disc.error += roundings * (square.high * error * (2.0 * roundings * across + error) + Approximate::underflow);
    return shadow_by_signs(along.sign(), disc.sign());
}

}  // namespace sphereview
