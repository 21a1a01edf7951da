// A camera seen from beside.
#include "camera/beside.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "camera/navigation.hpp"

namespace sphereview {

namespace {

constexpr PictureSize wide{900, 600};

Camera data_camera() { return {{0, 0, 300}, {0, 0, 200}, {50, 0, 0}, {0, 50, 0}}; }

}  // namespace

TEST(ScreenDepth, IsTheCamerasOwnWhereThatIsInFrontOfTheScene) {
    EXPECT_EQ(screen_depth_before(std::nullopt), 1.0);
    EXPECT_EQ(screen_depth_before(2.7), 1.0);
    EXPECT_LT(screen_depth_before(0.5), 0.5) << "a fitted view's screen may lie behind the scene";
    EXPECT_GT(screen_depth_before(1e6), 1e5) << "it would be a speck before a far scene";
}

TEST(ScreenCorners, AreThoseOfThePicture) {
    const auto corners = screen_corners(Camera{}, wide, 2.0);
    EXPECT_EQ(corners[0], glm::dvec3(-150, 100, 200));
    EXPECT_EQ(corners[2], glm::dvec3(150, -100, 200));
}

TEST(CameraBeside, SeesEveryPointWithTheSceneToTheRight) {
    for (Camera camera : {Camera{}, data_camera()}) {
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            camera.projection = projection;
            const glm::dvec3 ahead = camera_axes(camera).ahead;
            std::vector<glm::dvec3> points = {camera.eye, camera.eye + 600.0 * ahead, camera.eye + 400.0 * ahead + camera.right};
            for (const glm::dvec3& corner : screen_corners(camera, wide, 1.0)) points.push_back(corner);
            const auto beside = camera_beside(camera, wide, points);
            ASSERT_TRUE(beside);
            EXPECT_FALSE(camera_fault(*beside));
            EXPECT_FALSE(beside->orthographic());
            EXPECT_EQ(camera_axes(*beside).mirrored, camera_axes(camera).mirrored) << "no mirror image";
            double left = 1e9;
            double right = -1e9;
            for (const glm::dvec3& point : points) {
                const auto place = place_of(*beside, wide, point);
                ASSERT_TRUE(place);
                EXPECT_TRUE(place->x > 40 && place->x < 860 && place->y > 20 && place->y < 580) << place->x << " " << place->y;
                left = std::fmin(left, place->x);
                right = std::fmax(right, place->x);
            }
            EXPECT_GT(right - left, 500.0) << "as large as the picture lets it be";
            EXPECT_GT(place_of(*beside, wide, points[1])->x, place_of(*beside, wide, points[0])->x + 300.0);
            // From above: the eye's ray goes up in the picture as it goes away.
            EXPECT_LT(place_of(*beside, wide, points[1])->y, place_of(*beside, wide, points[0])->y);
        }
    }
}

TEST(CameraBeside, KeepsWhatItSeesClearOfACoveredCorner) {
    const Camera camera;
    std::vector<glm::dvec3> points = {camera.eye, {0, 0, 600}, {0, 150, 600}};
    for (const glm::dvec3& corner : screen_corners(camera, wide, 1.0)) points.push_back(corner);
    const auto spoiled = [&](const glm::dvec2& covered) {
        const Camera beside = *camera_beside(camera, wide, points, covered);
        return std::ranges::any_of(points, [&](const glm::dvec3& point) {
            const glm::dvec2 place = *place_of(beside, wide, point);
            EXPECT_TRUE(place.x > 0 && place.x < wide.width && place.y > 0 && place.y < wide.height);
            return place.x < covered.x && place.y < covered.y;
        });
    };
    for (const glm::dvec2 covered : {glm::dvec2(300, 300), glm::dvec2(500, 200), glm::dvec2(200, 550)}) {
        EXPECT_FALSE(spoiled(covered)) << covered.x << " " << covered.y;
    }
    EXPECT_TRUE(spoiled({800, 580})) << "where there is no room, all of the picture is taken";
}

TEST(CameraBeside, IsNoneBeyondWhatDoublesHold) {
    const std::vector<glm::dvec3> points = {{0, 0, 0}, {1e308, 1e308, 1e308}, {-1e308, 0, 0}};
    EXPECT_FALSE(camera_beside(Camera{}, wide, points));
    EXPECT_FALSE(camera_beside(Camera{}, wide, {}));
}

TEST(PlaceOnScreen, IsThePixelThatTheViewSeesThere) {
    const Camera camera;
    const std::vector<glm::dvec3> points = {camera.eye, {0, 0, 500}, {-75, 50, 100}, {75, -50, 100}};
    const Camera beside = *camera_beside(camera, wide, points);
    for (const double depth : {1.0, 2.5}) {
        for (const glm::dvec2 pixel : {glm::dvec2(450.5, 300.5), glm::dvec2(10.5, 20.5), glm::dvec2(880.5, 590.5)}) {
            const glm::dvec3 point = point_at(camera, wide, pixel, depth);
            const auto place = place_of(beside, wide, point);
            ASSERT_TRUE(place);
            const auto found = place_on_screen(camera, wide, depth, beside, wide, *place);
            ASSERT_TRUE(found);
            EXPECT_NEAR(glm::distance(found->place, pixel), 0.0, 1e-6);
            EXPECT_NEAR(found->depth, depth_of(beside, point), 1e-9);
        }
    }
    const auto outside = place_of(beside, wide, point_at(camera, wide, {-20.0, 300.0}, 1.0));
    EXPECT_FALSE(place_on_screen(camera, wide, 1.0, beside, wide, *outside));
    // Seen by the camera itself, the screen is the picture; one behind the view is not seen.
    EXPECT_NEAR(place_on_screen(camera, wide, 1.0, camera, wide, {123.0, 45.0})->place.x, 123.0, 1e-9);
    EXPECT_FALSE(place_on_screen(camera, wide, 1.0, data_camera(), wide, {-3000.0, 45.0}));
}

}  // namespace sphereview
