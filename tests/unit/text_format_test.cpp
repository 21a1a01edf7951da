#include "formats/text_format.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>

#include "unit/message_of.hpp"

namespace sphereview {

namespace {

Sphere sphere(Color color, glm::dvec3 center, double radius) { return {center, radius, color, false}; }

const std::vector<Sphere> two_spheres = {sphere({255, 0, 7}, {1.5, -2.0, 300.0}, 4.0), sphere({1, 2, 3}, {0.0, 0.25, 6.0}, 0.5)};

void expect_text_messages(const std::vector<WrongText>& cases) {
    expect_messages(
        "s.txt",
        [](const std::string& text) {
            parse_text_spheres({"s.txt", text});
        },
        cases);
}

}  // namespace

TEST(TextFormat, TakesWhiteSpaceAndLineEndsOfAnyKind) {
    const std::vector<std::string> texts = {
        "2\n255 0 7\n1.5 -2 300\n4\n1 2 3\n0 .25 6\n.5\n",
        "2\n255 0 7\n1.5 -2 300\n4\n1 2 3\n0 .25 6\n.5",
        "2\r\n255 0 7\r\n1.5 -2 300\r\n4\r\n1 2 3\r\n0 .25 6\r\n.5\r\n",
        "2\r255 0 7\r1.5 -2 300\r4\r1 2 3\r0 .25 6\r.5\r",
        "\xEF\xBB\xBF"
        "2\n255 0 7\n1.5 -2 300\n4\n1 2 3\n0 .25 6\n.5\n",
        "2 255 0 7 1.5 -2 300 4 1 2 3 0 .25 6 .5",
        "\n\n  \t2\t255\t0\v7\f1.5\n\n\n-2 3e2 4\t\n1 2 3 0 2.5e-1 6 .5\n \n\t",
        "+2 +255 0 07 +1.5 -2.0 +3E+2 4. 1 2 3 -0 0.25 6 00.5",
    };
    for (const std::string& text : texts) {
        SCOPED_TRACE(text);
        EXPECT_EQ(parse_text_spheres({"s.txt", text}), two_spheres);
    }
}

TEST(TextFormat, TakesNoSpheresAtAll) {
    for (const char* text : {"0", "0\n", "\xEF\xBB\xBF\r\n0\r\n", "+0", "-0", "000"}) {
        SCOPED_TRACE(text);
        EXPECT_TRUE(parse_text_spheres({"s.txt", text}).empty());
    }
}

TEST(TextFormat, KeepsEveryDoubleExactlyAndTakesTheNearestForWhatIsTooSmall) {
    const auto spheres =
        parse_text_spheres({"s.txt", "2 0 0 0 0.1 -0 1.7976931348623157e308 5e-324 0 0 0 1e-400 -1e-400 3e-324 1"});
    ASSERT_EQ(spheres.size(), 2U);
    const double smallest = std::numeric_limits<double>::denorm_min();
    const double expected[] = {0x1.999999999999ap-4, -0.0, std::numeric_limits<double>::max(), 0.0, -0.0, smallest};
    for (int i = 0; i < 6; ++i) {
        const double found = spheres[static_cast<std::size_t>(i / 3)].center[i % 3];
        EXPECT_EQ(std::bit_cast<std::uint64_t>(found), std::bit_cast<std::uint64_t>(expected[i])) << i;
    }
    EXPECT_EQ(spheres[0].radius, smallest);
}

TEST(TextFormat, IsWrittenAsItIsDescribed) {
    EXPECT_EQ(write_text_spheres(two_spheres), "2\n255 0 7\n1.5 -2 300\n4\n1 2 3\n0 0.25 6\n0.5\n");
    EXPECT_EQ(write_text_spheres({}), "0\n");
    Scene scene;
    scene.spheres = two_spheres;
    scene.spheres[0].hidden = true;
    EXPECT_EQ(write_text(scene), "1\n1 2 3\n0 0.25 6\n0.5\n") << "without hidden spheres";
}

TEST(TextFormatErrors, SaysWhereTheTextEndsTooEarlyOrGoesOnTooLong) {
    expect_text_messages({
        {"", "1:1: the text is empty, expected the number of spheres"},
        {"\xEF\xBB\xBF", "1:1: the text is empty, expected the number of spheres"},
        {" \r\n\t\n", "3:1: the text is empty, expected the number of spheres"},
        {"1", "1:2: the text ends, expected the red of sphere 1 of 1"},
        {"1\n1 2", "2:4: the text ends, expected the blue of sphere 1 of 1"},
        {"1\n1 2 3\n4 5\n", "4:1: the text ends, expected the centre's z of sphere 1 of 1"},
        {"1\r\n1 2 3\r\n4 5 6\r\n", "4:1: the text ends, expected the radius of sphere 1 of 1"},
        {"2\n1 2 3 4 5 6 7\n", "3:1: the text ends, expected the red of sphere 2 of 2"},
        {"0\n1", "2:1: found '1', expected the end of the text after 0 spheres"},
        {"1\n1 2 3 4 5 6 7 8", "2:15: found '8', expected the end of the text after 1 sphere"},
        {"2 1 2 3 4 5 6 7 1 2 3 4 5 6 7\n\n  end", "3:3: found 'end', expected the end of the text after 2 spheres"},
    });
}

TEST(TextFormatErrors, SaysWhichCountColourRadiusOrNumberCannotBe) {
    expect_text_messages({
        {"-1", "1:1: found '-1', expected the number of spheres from 0 to 2000000000"},
        {" 2000000001 1", "1:2: found '2000000001', expected the number of spheres from 0 to 2000000000"},
        {"99999999999999999999", "1:1: found '99999999999999999999', expected the number of spheres from 0 to 2000000000"},
        {"1.0", "1:1: found '1.0', expected the number of spheres, a whole number"},
        {"1e3", "1:1: found '1e3', expected the number of spheres, a whole number"},
        {"nan", "1:1: found 'nan', expected the number of spheres, a whole number"},
        {"+-1", "1:1: found '+-1', expected the number of spheres, a whole number"},
        {"+", "1:1: found '+', expected the number of spheres, a whole number"},
        {"2000000000\n1 2 3 4 5 6 7\n", "3:1: the text ends, expected the red of sphere 2 of 2000000000"},
        {"1\n256 0 0", "2:1: found '256', expected the red of sphere 1 of 1 from 0 to 255"},
        {"1\n0 -1 0", "2:3: found '-1', expected the green of sphere 1 of 1 from 0 to 255"},
        {"1\n0 0 99999999999999999999", "2:5: found '99999999999999999999', expected the blue of sphere 1 of 1 from 0 to 255"},
        {"1\n0 0.5 0", "2:3: found '0.5', expected the green of sphere 1 of 1, a whole number"},
        {"1\n1e2 0 0", "2:1: found '1e2', expected the red of sphere 1 of 1, a whole number"},
        {"1\n#ff0000", "2:1: found '#ff0000', expected the red of sphere 1 of 1, a whole number"},
        {"2\n1 2 3 4 5 6 7\n0 0 256", "3:5: found '256', expected the blue of sphere 2 of 2 from 0 to 255"},
        {"1\n1 2 3\n4 5 6\n0", "4:1: found '0', expected the radius of sphere 1 of 1 above 0"},
        {"1\n1 2 3\n4 5 6\n-0.0 ", "4:1: found '-0.0', expected the radius of sphere 1 of 1 above 0"},
        {"1\n1 2 3\n4 5 6\n1e-400\n", "4:1: found '1e-400', expected the radius of sphere 1 of 1 above 0"},
        {"1\n1 2 3\nnan 5 6\n7", "3:1: found 'nan', expected the centre's x of sphere 1 of 1, a finite number"},
        {"1\n1 2 3\n1e400 5 6\n7",
         "3:1: found '1e400', expected the centre's x of sphere 1 of 1, a number that a double can hold (at most 1.8e308)"},
        {"1\n1 2 3\n4 1,5 6\n7", "3:3: found '1,5', expected the centre's y of sphere 1 of 1, a number"},
        {"1\r1 2 3\r\r4 five 6\r7", "4:3: found 'five', expected the centre's y of sphere 1 of 1, a number"},
    });
}

TEST(TextFormatErrors, ShowsWordsAndBinaryBytesHarmlessly) {
    expect_text_messages({
        {"hello world", "1:1: found 'hello', expected the number of spheres, a whole number"},
        {"\xEF\xBB\xBFhello", "1:1: found 'hello', expected the number of spheres, a whole number"},
        {std::string("\x89PNG\r\n\x1a\n\0", 9), "1:1: found '\\x89PNG', expected the number of spheres, a whole number"},
        {std::string("\0\0\0\0", 4), "1:1: found '\\x00\\x00\\x00\\x00', expected the number of spheres, a whole number"},
        {std::string("1\0", 2), "1:1: found '1\\x00', expected the number of spheres, a whole number"},
        {"1 2\xC3\xA9 3", "1:3: found '2\\xc3\\xa9', expected the red of sphere 1 of 1, a whole number"},
        {std::string(1000, 'x'),
         "1:1: found 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...', expected the number of spheres, a whole number"},
    });
}

}  // namespace sphereview
