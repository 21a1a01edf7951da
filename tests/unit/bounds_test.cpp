#include "scene/bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/random.hpp"

namespace sphereview {

TEST(Bounds, AreWhatTheDefaultScreenShowsWhereNothingIs) {
    Scene scene;
    for (int i = 0; i < 2; ++i) {
        const SceneBounds bounds = bounds_of(scene);
        EXPECT_EQ(bounds.low, glm::dvec3(-100, -100, 100));
        EXPECT_EQ(bounds.high, glm::dvec3(100, 100, 300));
        EXPECT_EQ(bounds.middle(), glm::dvec3(0, 0, 200));
        EXPECT_EQ(bounds.extent(), 200.0);
        scene.spheres.push_back({{5, 5, 5}, 1.0, {}, true});  // hidden
    }
}

TEST(Bounds, HoldAllSpheresThatAreNotHidden) {
    oracle::Random random(1);
    for (const std::size_t count : {1, 2, 100, 50000}) {
        Scene scene;
        glm::dvec3 low(1e300);
        glm::dvec3 high(-1e300);
        double largest = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            const Sphere sphere{random.in_cube(1000.0), random.of_size(1e-3, 1e3), {}, i > 0 && random.chance(0.3)};
            scene.spheres.push_back(sphere);
            if (sphere.hidden) continue;
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], sphere.center[axis] - sphere.radius);
                high[axis] = std::max(high[axis], sphere.center[axis] + sphere.radius);
            }
            largest = std::max(largest, sphere.radius);
        }
        const SceneBounds bounds = bounds_of(scene);
        EXPECT_EQ(bounds.low, low);
        EXPECT_EQ(bounds.high, high);
        EXPECT_EQ(bounds.largest_radius, largest);
    }
}

TEST(Bounds, StayFiniteAndMoreThanNothing) {
    const double most = std::numeric_limits<double>::max();
    Scene scene;
    scene.spheres = {{{most, 0, 0}, most, {}, false}, {{-most, 0, 0}, most, {}, false}};
    SceneBounds bounds = bounds_of(scene);
    EXPECT_EQ(bounds.low.x, -most);
    EXPECT_EQ(bounds.high.x, most);
    EXPECT_EQ(bounds.middle().x, 0.0);
    EXPECT_EQ(bounds.extent(), most);
    scene.spheres = {{{1e9, 1e9, 1e9}, 1e-300, {}, false}};
    bounds = bounds_of(scene);
    EXPECT_EQ(bounds.low, bounds.high);
    EXPECT_EQ(bounds.extent(), 2e-300);
}

}  // namespace sphereview
