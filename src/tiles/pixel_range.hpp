// Which pixels a sphere can cover, conservatively. Only pixels' centres count, not their areas: a sphere smaller than a pixel is
// listed only where a ray can hit it. Derivation: docs/exactness.md, "Tiles".
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "exact/candidates.hpp"
#include "scene/camera.hpp"

namespace sphereview {

// The planes through the eye and the pixels' centres, column by column and row by row.
class PixelPlanes {
public:
    PixelPlanes(const Camera& camera, PictureSize size);

    // A range outside which no ray through a pixel's centre hits the sphere, a member of DrawnSpheres::center_radius.
    PixelRange range(const glm::vec4& sphere) const;

    // The same for each of the spheres, many at a time. There must be as many places in `ranges`.
    void ranges(std::span<const glm::vec4> spheres, std::span<PixelRange> ranges) const;

private:
    // The rays of all pixels with number i on this axis lie in the plane through the eye with the normal base + a step,
    // a = 2i + 1 - count, which points towards greater i.
    struct Axis {
        glm::dvec3 base{0.0};
        glm::dvec3 step{0.0};
        double base_base = 0.0;  // the scalar products, for the length of the normal
        double base_step = 0.0;
        double step_step = 0.0;
        int count = 0;
    };
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
    // Several spheres.
    static constexpr std::size_t lanes = 64;
    struct Lanes;

    static Axis make_axis(const glm::dvec3& forward, const glm::dvec3& along, const glm::dvec3& across, int count);
    static Product product(const Axis& axis, double x, double y, double z, double reach);
    static Margins margins(const Axis& axis, const Product& ball, double i);
    // For a ball wholly in front of the eye.
    static Interval guess(const Axis& axis, const Product& ball);
    static Interval in_front(const Axis& axis, const Product& ball);
    static Interval anywhere(const Axis& axis, const Product& ball);
    static PixelRange range_of(const Interval& columns, const Interval& rows);
    static void guess_lanes(const Axis& axis, Lanes& balls, std::array<double, lanes>& firsts, std::array<double, lanes>& lasts);
    void guess_ranges(const glm::vec4* spheres, Lanes& balls) const;

    Axis columns_;
    Axis rows_;
    glm::dvec3 view_{0.0};  // of length 1; every ray has a positive product with it
    bool usable_ = true;    // false: nothing is known, every range is the whole picture
};

}  // namespace sphereview
