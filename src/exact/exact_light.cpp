#include "exact/exact_light.hpp"

#include "exact/exact_decision.hpp"

namespace sphereview {

namespace {

// The direction on a power of two of its own: its length changes no sign.
IntegerVector whole_direction(const glm::dvec3& direction) {
    CommonScale scale;
    scale.include(direction);
    return scale.whole(direction);
}

}  // namespace

ExactLitPoint::ExactLitPoint(const Camera& camera, PictureSize size, Pixel pixel, const Sphere& sphere, EyeSide side)
    : camera_(camera),
      size_(size),
      pixel_(pixel),
      sphere_(sphere),
      root_sign_(origin_side(sphere, side, camera, size, pixel) == EyeSide::outside ? -1 : 1) {
    CommonScale scale;
    scale.include(camera);
    ray_ = exact_direction(camera, size, pixel, scale);
    square_ = dot(ray_, ray_);
}

ExactLitPoint::FromCenter ExactLitPoint::from_center_of(const Sphere& other) const {
    CommonScale scale;
    scale.include_origins(camera_);
    scale.include(sphere_);
    scale.include(other);
    const ExactOrigin origin = exact_origin(camera_, size_, pixel_, scale);
    const ExactQuadratic quadratic(sphere_, origin, ray_, square_, scale);
    const IntegerVector to_center = origin.to(scale.whole(other.center));
    const Integer radius = square_ * scale.whole(other.radius) * origin.factor;
    FromCenter from{{}, quadratic.d, radius * radius};
    for (std::size_t i = 0; i < 3; ++i) from.v[i] = quadratic.b * ray_[i] - square_ * to_center[i];
    return from;
}

int ExactLitPoint::facing(const glm::dvec3& direction) const {
    const IntegerVector l = whole_direction(direction);
    const FromCenter from = from_center_of(sphere_);
    const int sign = sign_with_root(dot(from.v, l), root_sign_ * dot(ray_, l), from.d);
    return root_sign_ < 0 ? sign : -sign;
}

BlockingSigns ExactLitPoint::blocking(const Sphere& other, const glm::dvec3& direction) const {
    const IntegerVector l = whole_direction(direction);
    const FromCenter from = from_center_of(other);
    const Integer v_l = dot(from.v, l);
    const Integer d_l = dot(ray_, l);
    // A^2 (m.m - r^2) = p_c + q_c sqrt(d)
    const Integer p_c = dot(from.v, from.v) + from.d * square_ - from.square_radius;
    const Integer q_c = 2 * root_sign_ * dot(from.v, ray_);
    const Integer l_l = dot(l, l);
    const Integer p = v_l * v_l + from.d * d_l * d_l - l_l * p_c;
    const Integer q = 2 * root_sign_ * v_l * d_l - l_l * q_c;
    return {sign_with_root(v_l, root_sign_ * d_l, from.d), sign_with_root(p, q, from.d)};
}

}  // namespace sphereview
