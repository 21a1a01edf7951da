// Lines of the scene in a picture.
#include "camera/projected_line.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "camera/navigation.hpp"

namespace sphereview {

namespace {

constexpr PictureSize picture{600, 400};

// Asserts that it is the picture of a part of the line, at both ends.
void expect_on_line(const Camera& camera, const ProjectedLine& line, const glm::dvec3& from, const glm::dvec3& to) {
    for (const bool end : {false, true}) {
        // Depths are linear along the line.
        const double depth = end ? line.to_depth : line.from_depth;
        const double part = (depth - depth_of(camera, from)) / (depth_of(camera, to) - depth_of(camera, from));
        EXPECT_TRUE(part >= 0.0 && part <= 1.0) << part;
        const glm::dvec3 point = from + part * (to - from);
        const auto place = place_of(camera, picture, point);
        ASSERT_TRUE(place);
        EXPECT_NEAR(glm::distance(*place, end ? line.to : line.from), 0.0, 1e-6);
    }
}

}  // namespace

TEST(ProjectedLine, BeforeTheEyeIsWhereItsEndsAre) {
    const Camera camera;
    const glm::dvec3 from{-20, 10, 150};
    const glm::dvec3 to{60, -30, 400};
    const auto line = projected_line(camera, picture, from, to);
    ASSERT_TRUE(line);
    expect_on_line(camera, *line, from, to);
    EXPECT_EQ(line->from_depth, 1.5);
    EXPECT_EQ(line->to_depth, 4.0);
}

TEST(ProjectedLine, ThroughTheEyesPlaneIsCutAndNotTurnedRound) {
    const Camera camera;
    const glm::dvec3 before{10, 5, 200};
    const glm::dvec3 behind{40, 5, -300};
    for (const bool backward : {false, true}) {
        const auto line = projected_line(camera, picture, backward ? behind : before, backward ? before : behind);
        ASSERT_TRUE(line);
        const glm::dvec2 kept = backward ? line->to : line->from;
        const glm::dvec2 cut = backward ? line->from : line->to;
        EXPECT_EQ(kept, *place_of(camera, picture, before));
        // It leaves at the right, where it goes; what is behind the eye would be projected to the left.
        EXPECT_GT(cut.x, picture.width);
        EXPECT_LT(cut.x, 1.2 * picture.width);
        expect_on_line(camera, *line, backward ? behind : before, backward ? before : behind);
    }
}

TEST(ProjectedLine, BehindTheEyeOrBesideThePictureIsNone) {
    const Camera camera;
    EXPECT_FALSE(projected_line(camera, picture, {0, 0, -10}, {30, 0, -500}));
    EXPECT_FALSE(projected_line(camera, picture, {500, -400, 200}, {500, 400, 200}));
    EXPECT_FALSE(projected_line(camera, picture, {0, 0, 0}, {0, 0, -1}));
    EXPECT_TRUE(projected_line(camera, picture, {0, 0, 0}, {0, 0, 1})) << "a ray from the eye is a point of the picture";
}

TEST(ProjectedLine, HasTheDepthsOfItsPointsBetweenToo) {
    Camera camera;
    const glm::dvec3 from{-20, 10, 150};
    const glm::dvec3 to{60, -30, 900};
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        camera.projection = projection;
        const auto line = projected_line(camera, picture, from, to);
        ASSERT_TRUE(line);
        for (const double part : {0.0, 0.3, 0.9, 1.0}) {
            const glm::dvec3 point = point_at(camera, picture, line->place_at(part), line->depth_at(part));
            // On the line.
            const glm::dvec3 way = glm::normalize(to - from);
            EXPECT_NEAR(glm::length(glm::cross(point - from, way)), 0.0, 1e-6);
        }
    }
}

TEST(ProjectedLine, OfParallelRaysEndsAtThePlaneOfTheEye) {
    Camera camera;
    camera.projection = Projection::orthographic;
    const auto line = projected_line(camera, picture, {10, 0, -100}, {10, 0, 100});
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->from_depth, 0.0, 1e-9);
    EXPECT_EQ(line->to_depth, 1.0);
    EXPECT_NEAR(line->pixels(), 0.0, 1e-9);
}

}  // namespace sphereview
