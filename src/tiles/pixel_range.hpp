// Which pixels a sphere can cover, conservatively. Derivation: docs/exactness.md, "Tiles".
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "exact/candidates.hpp"
#include "scene/camera.hpp"

namespace sphereview {

// The planes through the eye and the pixels' centres, column by column and row by row.
class PixelPlanes {
public:
    PixelPlanes(const Camera& camera, PictureSize size);

    // A range outside which no ray through a pixel's centre hits the sphere, a member of DrawnSpheres::center_radius.
    PixelRange range(const glm::vec4& sphere) const;

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
    // A sphere as seen from the eye: `reach` is its radius and all errors.
    struct Ball {
        glm::dvec3 center;
        double reach;
    };
    struct Interval {
        int first;
        int last;
    };

    static Axis make_axis(const glm::dvec3& forward, const glm::dvec3& along, const glm::dvec3& across, int count);
    // Whether the ball lies wholly on the side of greater (1) or smaller (-1) numbers of plane i; 0 if neither is sure.
    static int side(const Axis& axis, double base, double step, double reach, int i);
    static Interval in_front(const Axis& axis, const Ball& ball);
    static Interval anywhere(const Axis& axis, const Ball& ball);

    Axis columns_;
    Axis rows_;
    glm::dvec3 view_{0.0};  // of length 1; every ray has a positive product with it
    bool usable_ = true;    // false: nothing is known, every range is the whole picture
};

}  // namespace sphereview
