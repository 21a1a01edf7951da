#include "formats/text_format.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>

namespace sphereview {

namespace {

Sphere sphere(Color color, glm::dvec3 center, double radius) { return {center, radius, color, false}; }

const std::vector<Sphere> two = {sphere({255, 0, 7}, {1.5, -2.0, 300.0}, 4.0), sphere({1, 2, 3}, {0.0, 0.25, 6.0}, 0.5)};

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
        EXPECT_EQ(parse_text_spheres({"s.txt", text}), two);
    }
}

TEST(TextFormat, TakesNoSpheresAtAll) {
    for (const char* text : {"0", "0\n", "\xEF\xBB\xBF\r\n0\r\n", "+0", "-0", "000"}) {
        SCOPED_TRACE(text);
        EXPECT_TRUE(parse_text_spheres({"s.txt", text}).empty());
    }
}

TEST(TextFormat, KeepsEveryDoubleExactly) {
    const auto spheres = parse_text_spheres({"s.txt", "1 0 0 0 0.1 -0 1.7976931348623157e308 5e-324"});
    ASSERT_EQ(spheres.size(), 1U);
    EXPECT_EQ(spheres[0].center.x, 0x1.999999999999ap-4);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(spheres[0].center.y), std::bit_cast<std::uint64_t>(-0.0));
    EXPECT_EQ(spheres[0].center.z, std::numeric_limits<double>::max());
    EXPECT_EQ(spheres[0].radius, std::numeric_limits<double>::denorm_min());
}

TEST(TextFormat, GivesTheNearestDoubleForWhatIsTooSmall) {
    const auto spheres = parse_text_spheres({"s.txt", "1 0 0 0 1e-400 -1e-400 3e-324 1"});
    ASSERT_EQ(spheres.size(), 1U);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(spheres[0].center.x), std::uint64_t{0});
    EXPECT_EQ(std::bit_cast<std::uint64_t>(spheres[0].center.y), std::bit_cast<std::uint64_t>(-0.0));
    EXPECT_EQ(spheres[0].center.z, std::numeric_limits<double>::denorm_min());
}

TEST(TextFormat, IsWrittenAsItIsDescribed) {
    EXPECT_EQ(write_text_spheres(two), "2\n255 0 7\n1.5 -2 300\n4\n1 2 3\n0 0.25 6\n0.5\n");
    EXPECT_EQ(write_text_spheres({}), "0\n");
}

TEST(TextFormat, LeavesHiddenSpheresOut) {
    Scene scene;
    scene.spheres = two;
    scene.spheres[0].hidden = true;
    EXPECT_EQ(write_text(scene), "1\n1 2 3\n0 0.25 6\n0.5\n");
}

}  // namespace sphereview
