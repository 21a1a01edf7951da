#include "panels/number_text.hpp"

#include <gtest/gtest.h>

namespace sphereview {

namespace {

TEST(NumberText, RoundsInDecimal) {
    EXPECT_EQ(rounded_to(12.3456, -2), 12.35);
    EXPECT_EQ(rounded_to(-0.30000000000000004, -1), -0.3);
    EXPECT_EQ(rounded_to(12345.0, 2), 12300.0);
    EXPECT_EQ(rounded_to(51.0, 2), 100.0);
    EXPECT_EQ(rounded_to(49.0, 2), 0.0);
    EXPECT_EQ(rounded_to(-700.0, 3), -1000.0);
    EXPECT_EQ(rounded_to(7.0, 3), 0.0);
    EXPECT_EQ(rounded_to(9.99, 0), 10.0);
    EXPECT_EQ(rounded_to(1e300 / 3.0, 298), 33e298);
    EXPECT_EQ(rounded_to(1.0 / 3.0, -40), 1.0 / 3.0) << "no double has more digits";
    EXPECT_EQ(rounded_to(0.0, -2), 0.0);
    EXPECT_EQ(rounded_to(1.7976931348623157e308, 307), 1.7976931348623157e308) << "not to infinity";
}

TEST(NumberText, SaysHowManyDigitsAreMeant) {
    EXPECT_EQ(last_digit(400.0, 4), -1);
    EXPECT_EQ(last_digit(0.05, 2), -3);
    EXPECT_EQ(last_digit(0.0, 4), -3);
}

TEST(NumberText, IsShort) {
    EXPECT_EQ(rounded_text(12.5, -2), "12.50");
    EXPECT_EQ(rounded_text(-12.3456, 0), "-12");
    EXPECT_EQ(rounded_text(1e20 / 3.0, 17), "3.33e+19");
    EXPECT_EQ(short_text(1.0 / 3.0), "0.3333");
    EXPECT_EQ(short_text(-0.0), "0");
    EXPECT_EQ(short_text(1e20), "1e+20");
}

}  // namespace

}  // namespace sphereview
