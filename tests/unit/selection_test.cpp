#include "edit/selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace sphereview {

namespace {

using Numbers = std::vector<std::uint32_t>;

}  // namespace

TEST(Selection, IsEmptyAtFirst) {
    const Selection selection;
    EXPECT_TRUE(selection.empty());
    EXPECT_EQ(selection.size(), 0U);
    EXPECT_FALSE(selection.primary());
    EXPECT_FALSE(selection.contains(0));
}

TEST(Selection, TakesNumbersInAnyOrderOnceEach) {
    Selection selection;
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

}  // namespace sphereview
