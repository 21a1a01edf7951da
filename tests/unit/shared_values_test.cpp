#include "edit/shared_values.hpp"

#include <gtest/gtest.h>

namespace sphereview {

namespace {

using Numbers = std::vector<std::uint32_t>;

std::vector<Sphere> some() {
    return {{{1, 2, 3}, 4, {9, 9, 9}, false},
            {{-1, 2, 5}, 4, {9, 9, 9}, true},
            {{7, 2, 4}, 6, {255, 255, 255}, false},
            {{0, 0, 0}, 1, {0, 0, 0}, true}};
}

}  // namespace

TEST(SharedValues, AreWhatAllHave) {
    const SharedValues two = shared_values(some(), {0, 1});
    EXPECT_EQ(two.count, 2U);
    EXPECT_EQ(two.range(SphereValue::x).low, -1.0);
    EXPECT_EQ(two.range(SphereValue::x).high, 1.0);
    EXPECT_EQ(two.range(SphereValue::y).low, two.range(SphereValue::y).high);
    EXPECT_EQ(two.range(SphereValue::z).high, 5.0);
    EXPECT_EQ(two.range(SphereValue::radius).high, 4.0);
    EXPECT_EQ(two.color, (Color{9, 9, 9}));
    EXPECT_EQ(two.hidden, 1U);
    const SharedValues three = shared_values(some(), {0, 1, 2});
    EXPECT_EQ(three.color, std::nullopt);
    EXPECT_EQ(three.range(SphereValue::radius).low, 4.0);
    EXPECT_EQ(three.range(SphereValue::radius).high, 6.0);
    EXPECT_EQ(shared_values(some(), {}).count, 0U);
}

TEST(SharedValues, FindSpheresThatAreAlike) {
    EXPECT_EQ(colored_like(some(), {1}), (Numbers{0, 1}));
    EXPECT_EQ(colored_like(some(), {2, 3}), (Numbers{2, 3}));
    EXPECT_EQ(colored_like(some(), {}), Numbers{});
    EXPECT_EQ(hidden_ones(some()), (Numbers{1, 3}));
}

}  // namespace sphereview
