// Cameras that go round.
#include "camera/turntable.hpp"

#include <gtest/gtest.h>

#include "oracle/random.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

Scene cloud(std::uint64_t seed, const glm::dvec3& place) {
    oracle::Random random(seed);
    Scene scene;
    for (int i = 0; i < 40; ++i) scene.spheres.push_back({place + random.in_cube(10.0), random.between(0.1, 2.0), {}, i % 9 == 4});
    return scene;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 1e-9);
}

}  // namespace

TEST(Turntable, GoesToTheRightFirst) {
    const ViewAxes front;
    for (const ViewAxes& axes : {front, data_axes}) {
        const Turn turn(axes, TurnAxis::up);
        // A quarter: the eye looks to the left of where it looked.
        EXPECT_EQ(turn.direction(axes.ahead, 90.0), -axes.right);
        EXPECT_EQ(turn.direction(axes.up, 90.0), axes.up);
        EXPECT_EQ(Turn(axes, TurnAxis::y).direction(axes.ahead, 90.0), -axes.right);
    }
    const Camera turned = Turn(front, TurnAxis::up).camera(Camera{}, {0, 0, 200}, 90.0);
    EXPECT_EQ(turned.eye, glm::dvec3(200, 0, 200));
    EXPECT_EQ(turned.center, glm::dvec3(100, 0, 200));
    EXPECT_EQ(turned.right, glm::dvec3(0, 0, 50));
    EXPECT_EQ(turned.up, glm::dvec3(0, 50, 0));
    // As azimuth does.
    const ViewAxes same = axes_from(30.0, 0.0);
    const ViewAxes axes = Turn(front, TurnAxis::up).axes(front, 30.0);
    expect_near(axes.right, same.right);
    expect_near(axes.ahead, same.ahead);
}

TEST(Turntable, TurnsAboutTheSceneAxes) {
    const Turn x(ViewAxes{}, TurnAxis::x);
    const Turn z(ViewAxes{}, TurnAxis::z);
    EXPECT_EQ(x.direction({1, 0, 0}, 77.0), glm::dvec3(1, 0, 0));
    EXPECT_EQ(x.direction({0, 0, 1}, 90.0), glm::dvec3(0, 1, 0));
    EXPECT_EQ(z.direction({0, 1, 0}, 180.0), glm::dvec3(0, -1, 0));
    EXPECT_EQ(x.place({5, 1, 2}, {9, 1, 1}, 90.0), glm::dvec3(5, 2, 1));
    EXPECT_EQ(degrees_of(3, 4), 270.0);
    EXPECT_EQ(degrees_of(4, 4), 0.0);
}

TEST(Turntable, AnyCameraStaysWithoutFault) {
    oracle::Random random(5);
    for (int i = 0; i < 200; ++i) {
        const ViewAxes axes = axes_from(random.between(-180.0, 180.0), random.between(-90.0, 90.0));
        const Camera camera = fitted(cloud(static_cast<std::uint64_t>(i), random.in_cube(50.0)), axes).value();
        const Turn turn(axes, static_cast<TurnAxis>(i % 4));
        EXPECT_FALSE(camera_fault(turn.camera(camera, random.in_cube(50.0), random.between(0.0, 360.0))));
        EXPECT_EQ(turn.camera(camera, {1, 2, 3}, 0.0), camera);
    }
}

TEST(Turntable, OutermostSpheresFitAsAllDo) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const ViewAxes axes = axes_from(30.0, 20.0);
        Scene all;
        Scene few;
        for (std::uint64_t i = 0; i < 8; ++i) {
            const Scene scene = cloud(i, {static_cast<double>(3 * i), 0.0, -static_cast<double>(i)});
            const std::vector<Sphere> some = outermost(scene, axes, projection);
            EXPECT_LE(some.size(), 11U);
            few.spheres.insert(few.spheres.end(), some.begin(), some.end());
            all.spheres.insert(all.spheres.end(), scene.spheres.begin(), scene.spheres.end());
            Scene alone;
            alone.spheres = some;
            EXPECT_EQ(fitted(alone, axes, projection), fitted(scene, axes, projection));
        }
        const Camera a = fitted(all, axes, projection).value();
        const Camera b = fitted(few, axes, projection).value();
        expect_near(a.eye, b.eye);
        expect_near(a.right, b.right);
    }
    Scene hidden = cloud(1, {0, 0, 0});
    for (Sphere& sphere : hidden.spheres) sphere.hidden = true;
    EXPECT_TRUE(outermost(hidden, {}).empty());
}

}  // namespace sphereview
