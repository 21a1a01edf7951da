// A sphere against some pixels of a picture at once, in double: loops that the compiler turns into SIMD.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "exact/filter.hpp"
#include "exact/nearest_hit.hpp"

namespace sphereview {

inline constexpr std::size_t most_lanes = 64;

// One bit for each of the pixels.
using LaneSet = std::uint64_t;

template <typename T>
using Lane = std::array<T, most_lanes>;

// A vector of each pixel.
struct VectorLanes {
    Lane<double> x;
    Lane<double> y;
    Lane<double> z;

    void set(std::size_t lane, const glm::dvec3& vector) {
        x[lane] = vector.x;
        y[lane] = vector.y;
        z[lane] = vector.z;
    }
};

// Distances of different spheres are compared in times of this, so that none overflows.
inline constexpr double distance_unit = 0x1p8;

// A sphere as the double filter takes it. Sizes for which squares would leave the range of doubles are brought near 1.
struct BoundedSphere {
    glm::dvec3 center{0.0};             // relative to the eye, times a power of two
    double radius = 0.0;                // likewise
    double scale = 1.0;                 // that power
    double w = 0.0;                     // the bound (exact/filter.hpp); infinite when nothing is known of the sphere
    double unit = 1.0 / distance_unit;  // what turns lengths of these into distances in distance_unit

    // `reach`: of the rays' origins (RayBasis).
    BoundedSphere(const Sphere& sphere, const glm::dvec3& eye, double error_scale, double reach);
};

// NearestHits (exact/filter.hpp) of some pixels.
class BoundLanes {
public:
    // Their unit directions, of one to most_lanes of them. `origins`: where they begin, relative to the eye; empty: in the eye.
    explicit BoundLanes(std::span<const glm::dvec3> rays, std::span<const glm::dvec3> origins);

    // The pixels that may show the sphere, of those seen so far.
    LaneSet add(std::int64_t index, const BoundedSphere& sphere, EyeSide side);

    // What is known of one of the pixels.
    NearestHits<double> nearest(std::size_t lane) const;
    // The largest smallest_high of the pixels. No hit is at 0 or behind the eye.
    double farthest_sure_hit() const;

private:
    template <EyeSide side, bool in_eye>
    LaneSet add_on_side(std::int64_t index, const BoundedSphere& sphere);

    std::size_t count_;   // of lanes; the last pixel is repeated to fill them up
    VectorLanes ray_;     // unit directions
    bool in_eye_;         // all begin there
    VectorLanes origin_;  // else: where they begin
    Lane<double> smallest_high_;
    Lane<double> low_;
    Lane<double> second_low_;
    Lane<std::int64_t> sure_;
    Lane<std::int64_t> guess_;
};

// The nearest hits of some pixels (exact/nearest_hit.hpp), rounded to double: what is surely no nearer is told at once.
class DifferenceLanes {
public:
    explicit DifferenceLanes(std::size_t count);

    // All spheres that come from now on, until the next call, are on this scale. What is set stays, and is to be set anew.
    void use(const SphereScale& scale);

    // From now on the pixel takes part.
    void set(std::size_t lane, const NearestHit& nearest);

    // The pixels, of those that take part, whose nearest hit the sphere may challenge.
    LaneSet challenged_by(const ScaledSphere& sphere) const;

private:
    // The same if all rays begin outside of the sphere, or none does.
    LaneSet challenged_by(const ScaledSphere& sphere, bool outside) const;
    // The pixels whose rays surely begin outside of a sphere, and inside.
    struct Sides {
        LaneSet outside;
        LaneSet inside;
    };
    Sides sides(const ScaledSphere& sphere) const;

    static constexpr Lane<double> unknown = [] {
        Lane<double> lane{};
        lane.fill(std::numeric_limits<double>::quiet_NaN());
        return lane;
    }();
    static constexpr VectorLanes unknown_vectors{unknown, unknown, unknown};

    std::size_t count_;
    Lane<std::int64_t> takes_part_{};       // 1 or 0
    VectorLanes center_ = unknown_vectors;  // of the sphere that is hit, in the scene
    Lane<double> c_high_ = unknown;
    Lane<double> c_low_ = unknown;
    Lane<double> c_error_ = unknown;
    VectorLanes hit_ = unknown_vectors;    // x, relative to the eye; not a number where nothing is known
    VectorLanes ahead_ = unknown_vectors;  // the ray's direction; in perspective the hit, which is one
    Lane<double> square_ = unknown;        // x . ahead
    Lane<double> error_ = unknown;         // of each of the hit's components
    Lane<double> length_ = unknown;        // |x| + |y| + |z|
    Lane<double> inaccuracy_ = unknown;    // what bounds the error of V, by the sizes of C and x: docs/exactness.md

    VectorLanes origin_ = unknown_vectors;  // where the ray begins, relative to the eye; not a number before anything is hit
    Lane<double> origin_error_ = unknown;   // of each component
    Lane<double> origin_length_ = unknown;
    Lane<double> origin_square_ = unknown;

    // For the power as a sum of products with differences.
    double difference_unit_ = 0.0;
    VectorLanes scene_ = unknown_vectors;  // of the sphere that is hit: its numbers in the scene,
    Lane<double> scene_radius_ = unknown;
    VectorLanes sum_ = unknown_vectors;  // its centre relative to the eye, less twice the hit,
    Lane<double> sum_length_ = unknown;  // the sizes of what was summed,
    Lane<double> radius_ = unknown;      // and its radius
};

}  // namespace sphereview
