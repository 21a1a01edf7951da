// Values of spheres: what they are as numbers and as text, and when two columns are the same.
#include "scene/property.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sphereview {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Property, IsReadAsNumberAndText) {
    const Property charge{"charge", std::vector<double>{0.1, nan}};
    EXPECT_EQ(size_of(charge), 2U);
    EXPECT_EQ(number_at(charge, 0), 0.1);
    EXPECT_EQ(text_at(charge, 0), "0.1");
    EXPECT_TRUE(std::isnan(number_at(charge, 1)));
    EXPECT_EQ(text_at(charge, 1), "");
    EXPECT_FALSE(is_category(charge));

    EXPECT_EQ(text_at({"size", std::vector<float>{0.1F}}, 0), "0.1");
    EXPECT_EQ(text_at({"id", std::vector<std::int32_t>{-7}}, 0), "-7");

    const Property chain{"chain", Labels{{"A", ""}, {0, 1, 0}}};
    EXPECT_TRUE(is_category(chain));
    EXPECT_EQ(size_of(chain), 3U);
    EXPECT_EQ(text_at(chain, 2), "A");
    EXPECT_EQ(text_at(chain, 1), "");
    EXPECT_TRUE(std::isnan(number_at(chain, 0)));
}

TEST(Property, EqualsItselfWithoutValues) {
    const Property charge{"charge", std::vector<double>{nan, 1.0}};
    EXPECT_EQ(charge, charge);
    EXPECT_NE(charge, (Property{"charge", std::vector<double>{nan, 2.0}}));
    EXPECT_NE(charge, (Property{"Charge", std::vector<double>{nan, 1.0}}));
    EXPECT_NE((Property{"a", std::vector<double>{0.0}}), (Property{"a", std::vector<double>{-0.0}}));
    EXPECT_NE((Property{"a", std::vector<float>{1.0F}}), (Property{"a", std::vector<double>{1.0}}));
}

TEST(Property, WholeNumbersHaveAMarkForNone) {
    const Property id{"id", std::vector<std::int32_t>{no_whole_number}};
    EXPECT_TRUE(std::isnan(number_at(id, 0)));
    EXPECT_EQ(text_at(id, 0), "");
    EXPECT_FALSE(has_values(id));
}

TEST(Property, KeepsOfChosenSpheresOnlyTheirWords) {
    const Property chain{"chain", Labels{{"A", "B", "C"}, {0, 1, 2, 1}}};
    EXPECT_EQ(values_of(chain, std::vector<std::uint32_t>{3, 0}), (Property{"chain", Labels{{"B", "A"}, {0, 1}}}));
}

}  // namespace
}  // namespace sphereview
