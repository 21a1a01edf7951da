#include "base/number.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <locale>
#include <string>
#include <vector>

namespace sphereview {

namespace {

using Limits = std::numeric_limits<double>;

}  // namespace

TEST(ParseDouble, ReadsTheNearestDouble) {
    const std::vector<std::pair<const char*, double>> cases = {
        {"0", 0.0},
        {"-0", -0.0},
        {"+1", 1.0},
        {"1.", 1.0},
        {".5", 0.5},
        {"-1.5E+2", -150.0},
        {"007", 7.0},
        {"0.1", 0x1.999999999999ap-4},
        // Halfway between 1 and the next double: to even. A digit far behind decides.
        {"1.00000000000000011102230246251565404236316680908203125", 1.0},
        {"1.000000000000000111022302462515654042363166809082031250000000001", 0x1.0000000000001p0},
        {"1.7976931348623157e308", Limits::max()},
        {"1.7976931348623158e308", Limits::max()},
        {"2.2250738585072011e-308", 0x0.fffffffffffffp-1022},  // the largest subnormal
        // Too small.
        {"5e-324", Limits::denorm_min()},
        {"2.4703282292062329e-324", Limits::denorm_min()},  // just above half of it
        {"2.4703282292062327e-324", 0.0},
        {"1e-400", 0.0},
        {"-1e-400", -0.0},
        {"1.5e-99999999999999999999", 0.0},
    };
    for (const auto& [text, expected] : cases) {
        SCOPED_TRACE(text);
        double value = 12.0;
        EXPECT_EQ(parse_double(text, value), NumberFault::none);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected));
    }
}

TEST(ParseDouble, SaysWhatIsWrongAndLeavesTheValueAlone) {
    const std::vector<std::pair<NumberFault, std::vector<std::string>>> cases = {
        {NumberFault::not_a_number,
         {"", "+", "-", ".", "+-1", "-+1", "++1", "--1", "1e", "1e+", "1,5", "1.5x", "0x10", "1_000", " 1", "1 ", "one",
          std::string("1\0", 2)}},
        {NumberFault::not_finite, {"nan", "NaN", "inf", "-inf", "+inf", "Infinity"}},
        {NumberFault::too_large, {"1e400", "-1e400", "1.8e308", "1e99999999999999999999", "1.7976931348623159e308"}},
    };
    for (const auto& [expected, texts] : cases) {
        for (const std::string& text : texts) {
            SCOPED_TRACE(text);
            double value = 12.0;
            EXPECT_EQ(parse_double(text, value), expected);
            EXPECT_EQ(value, 12.0);
        }
    }
}

// As in much of Europe.
struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
};

TEST(ParseDouble, DoesNotHeedTheLocale) {
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
    double value = 12.0;
    EXPECT_EQ(parse_double("1.5", value), NumberFault::none);
    EXPECT_EQ(value, 1.5);
    EXPECT_EQ(parse_double("1.5e-400", value), NumberFault::none);
    EXPECT_EQ(value, 0.0);
    EXPECT_EQ(parse_double("1.5e400", value), NumberFault::too_large);
    std::locale::global(before);
}

}  // namespace sphereview
