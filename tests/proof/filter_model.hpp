// What shaders/trace.frag and the CPU renderer compute for one ray and one sphere, in any arithmetic.
#pragma once

#include <cmath>

#include "exact/filter.hpp"

namespace sphereview {

template <typename Real>
struct Vector {
    Real x;
    Real y;
    Real z;
};

template <typename Real>
Vector<Real> operator+(const Vector<Real>& a, const Vector<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <typename Real>
Vector<Real> operator*(Real factor, const Vector<Real>& v) {
    return {factor * v.x, factor * v.y, factor * v.z};
}

inline float inverse_sqrt(float x) { return 1.0F / std::sqrt(x); }
inline double inverse_sqrt(double x) { return 1.0 / std::sqrt(x); }

// What is uploaded, or handed to the renderer.
template <typename Real>
struct FilterInputs {
    Vector<Real> forward;
    Vector<Real> right;
    Vector<Real> up;
    Real across;
    Real upward;
    Vector<Real> center;
    Real radius;
    Real error_scale;
};

template <typename Real>
HitBounds<Real> run_filter(const FilterInputs<Real>& in, EyeSide side) {
    using std::abs;
    const Vector<Real> d = (in.forward + in.upward * in.up) + in.across * in.right;
    const Vector<Real> n = inverse_sqrt(d.x * d.x + d.y * d.y + d.z * d.z) * d;
    const Vector<Real>& c = in.center;
    if (side == EyeSide::on_surface) {  // without the radius, as it is uploaded as 0
        const Real w = in.error_scale * (abs(c.x) + abs(c.y) + abs(c.z));
        return hit_bounds<EyeSide::on_surface>(c.x, c.y, c.z, Real(0), w, n.x, n.y, n.z);
    }
    const Real w = in.error_scale * (abs(c.x) + abs(c.y) + abs(c.z) + in.radius);
    if (side == EyeSide::inside) return hit_bounds<EyeSide::inside>(c.x, c.y, c.z, in.radius, w, n.x, n.y, n.z);
    return hit_bounds<EyeSide::outside>(c.x, c.y, c.z, in.radius, w, n.x, n.y, n.z);
}

// The same of parallel rays, which begin in a plane. `reach`: RayBasis::reach. `side`: the plane's, outside or in_plane.
template <typename Real>
HitBounds<Real> run_parallel_filter(const FilterInputs<Real>& in, Real reach, EyeSide side) {
    using std::abs;
    const Vector<Real>& d = in.forward;
    const Vector<Real> n = inverse_sqrt(d.x * d.x + d.y * d.y + d.z * d.z) * d;
    const Vector<Real> origin = in.upward * in.up + in.across * in.right;
    const Vector<Real>& p = in.center;
    const Real w = in.error_scale * (abs(p.x) + abs(p.y) + abs(p.z) + in.radius + reach);
    return hit_bounds(side, p.x - origin.x, p.y - origin.y, p.z - origin.z, in.radius, w, n.x, n.y, n.z);
}

}  // namespace sphereview
