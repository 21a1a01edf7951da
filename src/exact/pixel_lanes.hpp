// Tests a sphere against several pixels at once, in double, with loops that become SIMD.
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

// A bit for each pixel.
using LaneSet = std::uint64_t;

template <typename T>
using Lane = std::array<T, most_lanes>;

// A vector for each pixel.
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

// The unit in which distances of different spheres are compared, so that none overflows.
inline constexpr double distance_unit = 0x1p8;

// A sphere for the double filter. Sizes whose squares would leave the range of doubles are brought near 1.
struct BoundedSphere {
    glm::dvec3 center{0.0};             // relative to the eye, times a power of two
    double radius = 0.0;                // likewise
    double scale = 1.0;                 // that power
    double w = 0.0;                     // the bound (exact/filter.hpp); infinite if nothing is known
    double unit = 1.0 / distance_unit;  // converts these lengths to distance_unit

    // `reach`: of the rays' origins (RayBasis).
    BoundedSphere(const Sphere& sphere, const glm::dvec3& eye, double error_scale, double reach);
};

// NearestHits (exact/filter.hpp) of several pixels.
class BoundLanes {
public:
    // `rays`: unit directions, 1 to most_lanes. `origins`: relative to the eye; empty: all in the eye.
    explicit BoundLanes(std::span<const glm::dvec3> rays, std::span<const glm::dvec3> origins);

    // Returns the pixels that may show the sphere, given the spheres so far.
    LaneSet add(std::int64_t index, const BoundedSphere& sphere, EyeSide side);

    // The bounds of one pixel.
    NearestHits<double> nearest(std::size_t lane) const;
    // The largest smallest_high of the pixels, which is above 0.
    double farthest_sure_hit() const;

private:
    template <EyeSide side, bool in_eye>
    LaneSet add_on_side(std::int64_t index, const BoundedSphere& sphere);

    std::size_t count_;   // of lanes; the last pixel is repeated to fill them up
    VectorLanes ray_;     // unit directions
    bool in_eye_;         // all rays begin in the eye
    VectorLanes origin_;  // else the rays' origins
    Lane<double> smallest_high_;
    Lane<double> low_;
    Lane<double> second_low_;
    Lane<std::int64_t> sure_;
    Lane<std::int64_t> guess_;
};

// The nearest hits of several pixels (exact/nearest_hit.hpp), rounded to double, to reject spheres that are surely not nearer.
class DifferenceLanes {
public:
    explicit DifferenceLanes(std::size_t count);

    // Sets the scale of the next spheres. Hits stay as they are, and must be set anew.
    void use(const SphereScale& scale);

    // Sets a pixel's nearest hit; from now on the pixel takes part.
    void set(std::size_t lane, const NearestHit& nearest);

    // The pixels taking part whose nearest hit the sphere may challenge.
    LaneSet challenged_by(const ScaledSphere& sphere) const;

private:
    // The same if all rays begin outside the sphere, or all inside.
    LaneSet challenged_by(const ScaledSphere& sphere, bool outside) const;
    // The pixels whose rays surely begin outside, and inside, a sphere.
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
    VectorLanes center_ = unknown_vectors;  // of the hit sphere, in the scene
    Lane<double> c_high_ = unknown;
    Lane<double> c_low_ = unknown;
    Lane<double> c_error_ = unknown;
    VectorLanes hit_ = unknown_vectors;    // x, relative to the eye; NaN if unknown
    VectorLanes ahead_ = unknown_vectors;  // the ray's direction; in perspective the hit
    Lane<double> square_ = unknown;        // x . ahead
    Lane<double> error_ = unknown;         // of each of the hit's components
    Lane<double> length_ = unknown;        // |x| + |y| + |z|
    Lane<double> inaccuracy_ = unknown;    // bounds the error of V by the sizes of C and x: docs/exactness.md

    VectorLanes origin_ = unknown_vectors;  // the ray's, relative to the eye; NaN before a hit
    Lane<double> origin_error_ = unknown;   // of each component
    Lane<double> origin_length_ = unknown;
    Lane<double> origin_square_ = unknown;

    // For the power as a sum of products with differences.
    double difference_unit_ = 0.0;
    VectorLanes scene_ = unknown_vectors;  // the hit sphere's centre in the scene
    Lane<double> scene_radius_ = unknown;
    VectorLanes sum_ = unknown_vectors;  // its centre relative to the eye, less twice the hit
    Lane<double> sum_length_ = unknown;  // the sizes of the terms of sum_
    Lane<double> radius_ = unknown;      // the hit sphere's radius
};

}  // namespace sphereview
