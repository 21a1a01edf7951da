// Lengths and angles between points.
#include "panels/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sphereview {

TEST(Measures, AreLengthsAndAngles) {
    EXPECT_EQ(distance_of({1, 2, 3}, {1, 5, 7}), 5.0);
    EXPECT_NEAR(distance_of({0, 0, 0}, {3e200, 4e200, 0}) / 5e200, 1.0, 1e-15) << "no square leaves the range";
    EXPECT_NEAR(*angle_of({1, 0, 0}, {0, 0, 0}, {0, 7, 0}), 90.0, 1e-12);
    EXPECT_NEAR(*angle_of({1, 1, 1}, {0, 0, 0}, {-1, -1, 1}), 109.47122063449069, 1e-12);
    EXPECT_NEAR(*angle_of({1, 0, 0}, {0, 0, 0}, {1, 1e-9, 0}), 1e-9 * 180.0 / 3.14159265358979, 1e-20) << "near 0, too";
    EXPECT_FALSE(angle_of({1, 0, 0}, {1, 0, 0}, {2, 0, 0}));
}

TEST(Measures, DihedralsAreClockwiseAsTheyAreSeen) {
    // Seen from b to c, along +x; in right-handed coordinates with y up, z is to the right there.
    const glm::dvec3 a{0, 1, 0};
    const glm::dvec3 b{0, 0, 0};
    const glm::dvec3 c{1, 0, 0};
    const auto at = [](double degrees) {
        const double angle = degrees * 3.14159265358979323846 / 180.0;
        return glm::dvec3{1, std::cos(angle), std::sin(angle)};
    };
    for (const double angle : {0.0, 30.0, 90.0, 150.0, -30.0, -120.0}) {
        EXPECT_NEAR(*dihedral_of(a, b, c, at(angle), false), angle, 1e-10);
        EXPECT_NEAR(*dihedral_of(a, b, c, at(angle), true), -angle, 1e-10);
    }
    EXPECT_NEAR(*dihedral_of(a, b, c, {1, -1, 0}, false), 180.0, 1e-10);
    EXPECT_NEAR(*dihedral_of(a, b, c, {1, -1, 0}, true), 180.0, 1e-10);
    EXPECT_FALSE(dihedral_of({-1, 0, 0}, b, c, at(30.0), false)) << "on a line";
}

}  // namespace sphereview
