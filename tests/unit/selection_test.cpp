#include "edit/selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

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

TEST(Selection, TakesNumbersInAnyOrderOnceEach) {
    Selection selection;
    EXPECT_FALSE(selection.primary() || selection.contains(0));
    selection.set({7, 3, 7, 9, 3, 5});
    EXPECT_EQ(selection.numbers(), (Numbers{3, 5, 7, 9}));
    EXPECT_EQ(selection.primary(), 5U);
    EXPECT_TRUE(selection.contains(7));
    EXPECT_FALSE(selection.contains(4));
    selection.set({});
    EXPECT_EQ(selection, Selection{});
}

TEST(Selection, TogglesAndRemembersTheLastChosen) {
    Selection selection;
    selection.toggle(5);
    selection.toggle(2);
    selection.toggle(8);
    EXPECT_EQ(selection.numbers(), (Numbers{2, 5, 8}));
    EXPECT_EQ(selection.primary(), 8U);
    selection.toggle(5);
    EXPECT_EQ(selection.primary(), 8U);
    selection.toggle(8);
    EXPECT_EQ(selection.primary(), 2U);
    selection.toggle(2);
    EXPECT_EQ(selection, Selection{});
}

TEST(Selection, DropsWhatASceneHasNot) {
    Selection selection;
    selection.set({1, 9, 4});
    selection.keep_below(9);
    EXPECT_EQ(selection.numbers(), (Numbers{1, 4}));
    EXPECT_EQ(selection.primary(), 4U);
    selection.toggle(1);
    selection.toggle(1);
    selection.keep_below(4);
    EXPECT_EQ(selection.numbers(), (Numbers{1}));
    EXPECT_EQ(selection.primary(), 1U);
    selection.keep_below(0);
    EXPECT_EQ(selection, Selection{});
}

TEST(Selection, AllNoneAndInverse) {
    Selection selection;
    selection.set({1, 3});
    selection.invert(5);
    EXPECT_EQ(selection.numbers(), (Numbers{0, 2, 4}));
    selection.invert(5);
    EXPECT_EQ(selection.numbers(), (Numbers{1, 3}));
    selection.set_all(4);
    EXPECT_EQ(selection.numbers(), (Numbers{0, 1, 2, 3}));
    EXPECT_TRUE(selection.primary());
    selection.invert(4);
    EXPECT_EQ(selection, Selection{});
    selection.invert(2);
    EXPECT_EQ(selection.numbers(), (Numbers{0, 1}));
    selection.set_all(0);
    EXPECT_EQ(selection, Selection{});
}

TEST(Selection, AGroupComesInAndWhenItIsInGoesOut) {
    Selection selection;
    selection.set({1, 5});
    selection.toggle_all({0, 1});
    EXPECT_EQ(selection.numbers(), (Numbers{0, 1, 5}));
    selection.toggle_all({0, 1});
    EXPECT_EQ(selection.numbers(), Numbers{5});
    selection.toggle_all({5});
    EXPECT_EQ(selection, Selection{});
    selection.toggle_all({});
    EXPECT_TRUE(selection.empty());
}

TEST(Selection, AnotherSetIsAnotherVersion) {
    Selection selection;
    EXPECT_EQ(selection.version(), 0U);
    std::set<std::uint64_t> seen{0};
    const auto is_new = [&] { return seen.insert(selection.version()).second; };
    selection.set({1, 3, 5, 9});
    EXPECT_TRUE(is_new());
    const Selection copy = selection;
    EXPECT_EQ(copy.version(), selection.version());
    selection.toggle(4);
    EXPECT_TRUE(is_new());
    selection.keep_below(9);
    EXPECT_TRUE(is_new());
    selection.keep_below(9);
    EXPECT_FALSE(is_new()) << "nothing changed";
    selection.invert(12);
    EXPECT_TRUE(is_new());
    selection.set_all(12);
    EXPECT_TRUE(is_new());
    selection.clear();
    EXPECT_EQ(selection.version(), 0U);
}

TEST(Selection, IsASetWithAMemberThatIsPrimary) {
    std::mt19937_64 random(5);
    Selection selection;
    std::set<std::uint32_t> expected;
    for (int trial = 0; trial < 20000; ++trial) {
        const auto number = static_cast<std::uint32_t>(random() % 20);
        switch (random() % 20) {
            case 0: selection.clear(), expected.clear(); break;
            case 1: selection.set_only(number), expected = {number}; break;
            case 2: selection.keep_below(number), expected.erase(expected.lower_bound(number), expected.end()); break;
            case 3: selection.set({number, 3, 11}), expected = {number, 3, 11}; break;
            default:
                selection.toggle(number);
                if (expected.erase(number) == 0) expected.insert(number);
        }
        ASSERT_TRUE(std::ranges::equal(selection.numbers(), expected)) << "trial " << trial;
        ASSERT_EQ(selection.primary().has_value(), !expected.empty()) << "trial " << trial;
        ASSERT_TRUE(expected.empty() || selection.contains(*selection.primary())) << "trial " << trial;
    }
}

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
