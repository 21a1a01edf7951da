#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "formats/point_radius.hpp"
#include "unit/csv_tables.hpp"

namespace sphereview {

TEST(PointRadius, IsAQuarterOfTheMedianDistance) {
    const auto radius = [](const Centers& points) {
        std::vector<Sphere> spheres;
        for (const glm::dvec3& point : points) spheres.push_back({point, 1.0, {}, false});
        return radius_of_points(spheres);
    };
    EXPECT_EQ(radius({}), std::nullopt);
    EXPECT_EQ(radius({{1, 2, 3}}), std::nullopt);
    EXPECT_EQ(radius({{1, 2, 3}, {1, 2, 3}}), std::nullopt);
    EXPECT_EQ(radius({{-1e308, 0, 0}, {1e308, 0, 0}}), std::nullopt);
    EXPECT_EQ(radius({{0, 0, 0}, {0, 0, 8}}), 2.0);
    EXPECT_EQ(radius({{0, 0, 0}, {0, 0, 0}, {0, 0, 8}}), 2.0);                          // places that differ count
    EXPECT_EQ(radius({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {1e9, 0, 0}}), 1.0);  // and one that is far does not
    Centers lattice;
    for (int i = 0; i < 30; ++i) {
        for (int j = 0; j < 30; ++j) {
            for (int k = 0; k < 30; ++k) lattice.emplace_back(8 * i, 8 * j, 8 * k);
        }
    }
    EXPECT_EQ(radius(lattice), 2.0);
    lattice.emplace_back(1e12, -1e12, 5);
    EXPECT_EQ(radius(lattice), 2.0);
}

// The grid finds what comparing all with all finds, also where points are crowded, flat or in a row.
TEST(PointRadius, IsThatOfAllPairs) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int shape = 0; shape < 12; ++shape) {
        std::vector<Sphere> points(400);
        for (Sphere& sphere : points) {
            glm::dvec3 p(uniform(random), uniform(random), uniform(random));
            if (shape % 4 == 1) p.z = 3.0;
            if (shape % 4 == 2) p = {p.x, 0.0, 0.0};
            if (shape % 4 == 3 && uniform(random) < 0.9) p *= 1e-3;
            sphere.center = p;
        }
        std::vector<double> nearest;
        for (const Sphere& a : points) {
            double least = INFINITY;
            for (const Sphere& b : points) {
                const glm::dvec3 d = a.center - b.center;
                if (&a != &b) least = std::min(least, d.x * d.x + d.y * d.y + d.z * d.z);
            }
            nearest.push_back(std::sqrt(least));
        }
        std::ranges::sort(nearest);
        const auto radius = radius_of_points(points);
        ASSERT_TRUE(radius) << shape;
        EXPECT_NEAR(*radius, 0.25 * nearest[199], 1e-12) << shape;
    }
}

TEST(PointRadius, IsSaidAndGivesWayToAnotherOne) {
    const std::string text = "x,y,z\n0,0,0\n0,0,8\n";
    EXPECT_EQ(table(text).warnings, Lines{"a.csv: no radius in the file: all get 2, a quarter of the median distance to the "
                                          "nearest neighbour; --radius gives another"});
    EXPECT_EQ(spheres(text)[1].radius, 2.0);
    EXPECT_EQ(spheres(text, {0, 4.5})[1].radius, 4.5);
    EXPECT_EQ(read_xyz("0 0 0\n0 0 8\n", "a.xyz", {}).scene.spheres[1].radius, 2.0);  // points alone, too
    EXPECT_EQ(table(text, {0, 4.5}).warnings, Lines{});
}

}  // namespace sphereview
