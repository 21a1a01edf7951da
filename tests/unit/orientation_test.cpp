// The axes and the scale bar that a view has.
#include "camera/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "camera/fit.hpp"
#include "camera/navigation.hpp"

namespace sphereview {

namespace {

AxisEnd end_of(const Camera& camera, int axis, bool positive) {
    for (const AxisEnd& end : axis_ends(camera)) {
        if (end.axis == axis && end.positive == positive) return end;
    }
    ADD_FAILURE();
    return {};
}

Camera mirrored_camera() { return {{0, 0, 300}, {0, 0, 200}, {50, 0, 0}, {0, 50, 0}}; }

}  // namespace

TEST(AxisEnds, AreWhereTheViewSeesThem) {
    const Camera front;
    EXPECT_EQ(end_of(front, 0, true).place, glm::dvec2(1, 0));
    EXPECT_EQ(end_of(front, 1, true).place, glm::dvec2(0, -1)) << "y is up";
    EXPECT_EQ(end_of(front, 2, true).toward, -1.0) << "z goes into the picture";
    const auto ends = axis_ends(front);
    EXPECT_TRUE(std::ranges::is_sorted(ends, {}, &AxisEnd::toward));
    EXPECT_EQ(end_of(mirrored_camera(), 2, true).toward, 1.0) << "the z of data comes out of it";
    EXPECT_EQ(end_of(mirrored_camera(), 0, true).place, glm::dvec2(1, 0));
}

TEST(AxesSeenFrom, LookAgainstTheAxisAndKeepTheHand) {
    for (const Camera& camera : {Camera{}, mirrored_camera()}) {
        for (const AxisEnd& end : axis_ends(camera)) {
            const CameraAxes axes = axes_seen_from(camera, end);
            glm::dvec3 direction(0.0);
            direction[end.axis] = end.positive ? 1.0 : -1.0;
            EXPECT_EQ(axes.ahead, -direction) << end.axis << end.positive;
            EXPECT_EQ(axes.mirrored, camera_axes(camera).mirrored);
            const Camera turned = turned_to(camera, {0, 0, 0}, axes);
            EXPECT_EQ(camera_axes(turned).mirrored, axes.mirrored);
            EXPECT_LT(glm::distance(camera_axes(turned).ahead, axes.ahead), 1e-12);
            if (end.axis != 1) {
                EXPECT_EQ(axes.up, glm::dvec3(0, 1, 0));
            }
        }
    }
}

TEST(ScaleBar, IsTheLongestOfOneTwoAndFive) {
    Camera camera;
    camera.projection = Projection::orthographic;
    // The picture is 100 wide: a pixel is 0.1.
    for (const auto& [most, length] :
         {std::pair{250.0, 20.0}, {200.0, 20.0}, {199.0, 10.0}, {500.0, 50.0}, {99.0, 5.0}, {10.0, 1.0}}) {
        const auto bar = scale_bar(camera, {1000, 1000}, {1e9, 0, -5}, most);
        ASSERT_TRUE(bar);
        EXPECT_EQ(bar->length, length) << most;
        EXPECT_NEAR(bar->pixels, 10.0 * length, 1e-9);
        EXPECT_FALSE(bar->depth) << "it holds everywhere";
    }
    EXPECT_EQ(in_words(*scale_bar(camera, {1000, 1000}, {}, 250.0)), "20");
    // Any size, the other side being longer too.
    for (const double size : {1e-200, 3.7e-5, 1.0, 9.99, 1e20, 1e200}) {
        camera.right = {size, 0, 0};
        camera.up = {0, size, 0};
        const auto bar = scale_bar(camera, {4000, 500}, {}, 125.0);
        ASSERT_TRUE(bar) << size;
        EXPECT_LE(bar->pixels, 125.0 * (1.0 + 1e-12));
        EXPECT_GT(bar->pixels, 49.9);
    }
}

TEST(ScaleBar, HoldsAsDeepAsThePointInPerspective) {
    const Camera camera;  // the screen is 100 wide at 100
    const auto bar = scale_bar(camera, {1000, 1000}, {70, -30, 300}, 250.0);
    ASSERT_TRUE(bar);
    EXPECT_EQ(bar->length, 50.0);
    EXPECT_EQ(bar->depth, 300.0);
    EXPECT_EQ(in_words(*bar), "50 at depth 300");
    EXPECT_EQ(in_words(ScaleBar{.length = 50.0, .pixels = 10.0, .depth = 1128.4}), "50 at depth 1130");
    // A stick so long, there, is so long in the picture.
    const auto left = place_of(camera, {1000, 1000}, {-25, 0, 300});
    const auto right = place_of(camera, {1000, 1000}, {25, 0, 300});
    EXPECT_NEAR(right->x - left->x, bar->pixels, 1e-9);
    EXPECT_FALSE(scale_bar(camera, {1000, 1000}, {0, 0, -10}, 250.0)) << "behind the eye";
    EXPECT_FALSE(scale_bar(camera, {1000, 1000}, {0, 0, 0}, 250.0));
    EXPECT_FALSE(scale_bar(camera, {1000, 1000}, {0, 0, 1e308}, 1e4).has_value() &&
                 !std::isfinite(scale_bar(camera, {1000, 1000}, {0, 0, 1e308}, 1e4)->length));
}

}  // namespace sphereview
