// Which frames a list names.
#include "app/frame_ranges.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/film_options.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

// Of a file of `known` frames.
std::vector<std::int64_t> frames(const std::string& list, std::int64_t known = 10) {
    return frames_in(parse_frames(list).value(), "a.xyz", [=](std::int64_t enough) { return std::min(known, enough); });
}

using Numbers = std::vector<std::int64_t>;

}  // namespace

TEST(FrameRanges, AreSlices) {
    EXPECT_EQ(frames("all", 3), (Numbers{0, 1, 2}));
    EXPECT_EQ(frames(":", 3), (Numbers{0, 1, 2}));
    EXPECT_EQ(frames("2:5"), (Numbers{2, 3, 4}));
    EXPECT_EQ(frames("2:9:3"), (Numbers{2, 5, 8}));
    EXPECT_EQ(frames("::4"), (Numbers{0, 4, 8}));
    EXPECT_EQ(frames("-2:"), (Numbers{8, 9}));
    EXPECT_EQ(frames(":-8"), (Numbers{0, 1}));
    EXPECT_EQ(frames("8:1000"), (Numbers{8, 9}));
    EXPECT_EQ(frames("-1000:2"), (Numbers{0, 1}));
    EXPECT_EQ(frames("0::9223372036854775807"), (Numbers{0}));
    EXPECT_EQ(frames("3"), (Numbers{3}));
    EXPECT_EQ(frames("-1"), (Numbers{9}));
    EXPECT_EQ(frames("0,5,2:4,-1"), (Numbers{0, 5, 2, 3, 9}));
}

TEST(FrameRanges, OnlyWhatIsThere) {
    EXPECT_EQ(message_of<InputError>([] { frames("10"); }), "a.xyz: found 10 frames, 0 to 9, expected frame 10");
    EXPECT_EQ(message_of<InputError>([] { frames("-11"); }), "a.xyz: found 10 frames, 0 to 9, expected frame -11");
    EXPECT_EQ(message_of<InputError>([] { frames("5:5"); }), "a.xyz: found no frame where --frames looks, expected one at least");
    EXPECT_EQ(message_of<InputError>([] { frames("9223372036854775807"); }),
              "a.xyz: found 10 frames, 0 to 9, expected frame 9223372036854775807");
    for (const char* wrong : {"", "a", "1:2:0", "1:2:-1", "1:2:3:4", "1,", "1.5", "all:", "+1", " 1", "99999999999999999999"}) {
        EXPECT_FALSE(parse_frames(wrong)) << wrong;
    }
}

TEST(FrameRanges, PartsAndRates) {
    EXPECT_TRUE(parse_part_of_pictures("2/4")->has(1));
    EXPECT_FALSE(parse_part_of_pictures("2/4")->has(2));
    EXPECT_TRUE(parse_part_of_pictures("2/4")->has(5));
    EXPECT_EQ(parse_frame_rate("30"), (FrameRate{30, 1}));
    EXPECT_EQ(parse_frame_rate("30000/1001"), (FrameRate{30000, 1001}));
    for (const char* wrong : {"", "0", "30/0", "29.97", "-1", "1/", "1000001"}) EXPECT_FALSE(parse_frame_rate(wrong)) << wrong;
}

}  // namespace sphereview
