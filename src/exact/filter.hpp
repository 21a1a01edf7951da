// One sphere against one ray in floating point, with proven bounds. Derivation: docs/exactness.md. Twin: shaders/filter.glsl.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "base/square_root.hpp"

namespace sphereview {

// The eye's place relative to a sphere: the sign of |C|^2 - r^2, decided exactly, once for the sphere. An orthographic eye is the
// plane in which its rays begin: outside if the plane misses the sphere, else in_plane, where each ray decides which root counts.
enum class EyeSide : std::uint8_t { outside, inside, on_surface, in_plane };

// The units of arithmetics: bounds on the relative error of + - x and of inputs. Square roots, inverse square roots and division
// may err by twice as much.
inline constexpr double gpu_unit = 0x1p-21;     // 8 times IEEE 754's: the assumption about GPUs
inline constexpr double float_unit = 0x1p-24;   // IEEE 754 single precision, rounded to nearest
inline constexpr double double_unit = 0x1p-53;  // IEEE 754 double precision, rounded to nearest

// The bound for floats is proven up to this condition of the rays (exact/rays.hpp).
inline constexpr double largest_float_condition = 256.0;

// An orthographic direction is only rounded; the rest pays for the rounding of origins. docs/exactness.md, "Orthographic rays".
inline constexpr double orthographic_condition = 2.0;

// Sizes, |x| + |y| + |z| + r, for which the squares and the bound of the double filter neither overflow nor underflow.
inline constexpr double smallest_double_size = 0x1p-300;
inline constexpr double largest_double_size = 0x1p300;

// c(kappa, u) of docs/exactness.md: a sphere at C with radius r has w = c (|x| + |y| + |z| + r). Orthographic: plus the reach of
// the rays' origins, and kappa is orthographic_condition.
constexpr double error_scale(double kappa, double unit) { return (5.0 * kappa + 22.0) * unit * (1.0 + 1.0 / 64.0); }

// Bounds of the hit's distance along the ray. A miss: low is infinite. Not surely a hit: high is infinite.
template <typename Real>
struct HitBounds {
    Real low;
    Real high;
};

// std::max takes references, which keep loops from becoming SIMD.
template <typename Real>
constexpr Real at_least_zero(Real x) {
    return x < Real(0) ? Real(0) : x;
}

// The centre (cx, cy, cz) relative to the ray's origin, the radius r > 0, the bound w and the ray's unit direction (nx, ny, nz).
// Without branches, so that a loop over rays becomes SIMD. Haines, Guenther and Akenine-Moeller, "Precision improvements
// for ray/sphere intersection", 2019: the closest approach h first, because b^2 - c cancels.
template <EyeSide side, typename Real>
inline HitBounds<Real> hit_bounds(Real cx, Real cy, Real cz, Real r, Real w, Real nx, Real ny, Real nz) {
    constexpr Real never = std::numeric_limits<Real>::infinity();
    const Real along = cx * nx + cy * ny + cz * nz;
    if constexpr (side == EyeSide::on_surface) {
        // The roots are 0, which does not count, and 2 b.
        const Real low = Real(2) * (along - w);
        const Real high = Real(2) * (along + w);
        return {along < -w ? never : low, along > w ? high : never};
    } else {
        const Real px = cx - along * nx;
        const Real py = cy - along * ny;
        const Real pz = cz - along * nz;
        const Real h = square_root(px * px + py * py + pz * pz);
        const Real longest = square_root(at_least_zero(r - h + w) * (r + h + w));
        const Real shortest = square_root(at_least_zero(r - h - w) * at_least_zero(r + h - w));
        if constexpr (side == EyeSide::inside) {
            return {along + shortest - w, along + longest + w};
        } else if constexpr (side == EyeSide::in_plane) {
            // The smaller root where that is positive, else the larger.
            const Real near_low = along - longest - w;
            const Real near_high = along - shortest + w;
            const Real far_low = along + shortest - w;
            const Real far_high = along + longest + w;
            const bool apart = h - r > w;
            const bool behind = far_high < Real(0);
            const bool missed = apart | behind;
            const bool both = r - h > w;
            const Real low = near_high <= Real(0) ? far_low : near_low;
            const Real high = near_low > Real(0) ? near_high : far_low > Real(0) ? far_high : never;
            return {missed ? never : low, both ? high : never};
        } else {
            const bool beside = h - r > w;
            const bool behind = along < -w;
            const bool within = r - h > w;
            const bool ahead = along > w;
            const bool missed = beside | behind;  // without branches
            const bool sure = within & ahead;
            return {missed ? never : along - longest - w, sure ? along - shortest + w : never};
        }
    }
}

// The same for a side that is known only now.
template <typename Real>
inline HitBounds<Real> hit_bounds(EyeSide side, Real cx, Real cy, Real cz, Real r, Real w, Real nx, Real ny, Real nz) {
    switch (side) {
        case EyeSide::outside: return hit_bounds<EyeSide::outside>(cx, cy, cz, r, w, nx, ny, nz);
        case EyeSide::inside: return hit_bounds<EyeSide::inside>(cx, cy, cz, r, w, nx, ny, nz);
        case EyeSide::on_surface: return hit_bounds<EyeSide::on_surface>(cx, cy, cz, r, w, nx, ny, nz);
        case EyeSide::in_plane: return hit_bounds<EyeSide::in_plane>(cx, cy, cz, r, w, nx, ny, nz);
    }
    return {};
}

// Bounds on a pixel's nearest hits after some spheres, by which decided() tells whether one is surely visible.
template <typename Real>
struct NearestHits {
    static constexpr Real never = std::numeric_limits<Real>::infinity();

    Real smallest_high = never;  // over the sure hits
    int sure = -1;               // whose that is
    Real low = never;            // the smallest lower bound over all candidates
    int guess = -1;              // whose that is
    Real second_low = never;     // the smallest over all candidates but `guess`

    void add(int sphere, const HitBounds<Real>& hit) {
        const bool nearer = hit.low < low;
        second_low = nearer ? low : std::min(second_low, hit.low);
        low = nearer ? hit.low : low;
        guess = nearer ? sphere : guess;
        const bool surer = hit.high < smallest_high;
        smallest_high = surer ? hit.high : smallest_high;
        sure = surer ? sphere : sure;
    }

    // The visible sphere, or -1 for none, is `guess`: nothing else can be as near.
    bool decided() const { return guess == sure && (guess < 0 || second_low > smallest_high); }
};

}  // namespace sphereview
