#include "panels/sphere_filter.hpp"

#include <gtest/gtest.h>

namespace sphereview {

namespace {

using Numbers = std::vector<std::uint32_t>;

Scene some() {
    Scene scene;
    scene.spheres.resize(125);
    scene.names = {{0, "Sun"}, {12, "sunflower 3"}, {99, "Ümlaut"}};
    return scene;
}

Numbers filtered(const Scene& scene, const std::string& filter) {
    FilterSearch search;
    search.begin(scene, filter);
    search.finish(scene);
    // However small the steps are, the same is found.
    FilterSearch slow;
    slow.begin(scene, filter);
    for (int i = 0; !slow.done(); ++i) {
        slow.go_on(scene, 1);
        EXPECT_LE(i, 3000);
    }
    EXPECT_EQ(slow.found(), search.found()) << filter;
    return search.found();
}

TEST(SphereFilter, FindsNamesWhateverTheCase) {
    EXPECT_EQ(filtered(some(), "SUN"), (Numbers{0, 12}));
    EXPECT_EQ(filtered(some(), " sunf "), Numbers{12});
    EXPECT_EQ(filtered(some(), "Üml"), Numbers{99});
    EXPECT_TRUE(filtered(some(), "moon").empty());
}

TEST(SphereFilter, FindsNumbersByTheirFirstDigits) {
    EXPECT_EQ(filtered(some(), "12"), (Numbers{12, 120, 121, 122, 123, 124}));
    EXPECT_EQ(filtered(some(), "sphere 124"), Numbers{124});
    EXPECT_EQ(filtered(some(), "#7"), (Numbers{7, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79}));
    EXPECT_EQ(filtered(some(), "0"), Numbers{0});
    EXPECT_EQ(filtered(some(), "125"), Numbers{});
    EXPECT_EQ(filtered(some(), "99999999999999999999999"), Numbers{});
    EXPECT_EQ(filtered(some(), "3").front(), 3U);
    EXPECT_EQ(filtered(some(), "3")[1], 12U) << "by its name";
}

TEST(SphereFilter, NumbersAreThoseWhoseTextBeginsSo) {
    Scene scene;
    scene.spheres.resize(2345);
    for (const std::string digits : {"0", "1", "2", "9", "10", "23", "234", "2344", "2345", "01", "00"}) {
        Numbers expected;
        for (std::uint32_t number = 0; number < 2345; ++number) {
            if (std::to_string(number).starts_with(digits)) expected.push_back(number);
        }
        EXPECT_EQ(filtered(scene, digits), expected) << digits;
    }
}

TEST(SphereFilter, TitleOfSpheresWithoutANameIsFound) {
    EXPECT_EQ(filtered(some(), "sphere").size(), 122U);
    EXPECT_EQ(filtered(some(), "sph").size(), 122U);
}

TEST(ListedSpheres, RowsAndNumbersBelongTogether) {
    const Scene scene = some();
    const Numbers listed{3, 7, 50};
    const ListedSpheres some_listed(scene, false, listed);
    EXPECT_EQ(some_listed.size(), 3U);
    EXPECT_EQ(some_listed.row_of(7), 1U);
    EXPECT_EQ(some_listed.row_of(8), std::nullopt);
    EXPECT_EQ(some_listed.between(2, 1), (Numbers{7, 50}));
    const ListedSpheres all(scene, true, listed);
    EXPECT_EQ(all.size(), 125U);
    EXPECT_EQ(all[124], 124U);
    EXPECT_EQ(all.row_of(125), std::nullopt);
}

}  // namespace

}  // namespace sphereview
