// Pictures averaged and compared.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "image/compare.hpp"
#include "image/image.hpp"
#include "support/picture.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

using Values = std::vector<int>;

Image image(int width, int height, int channels, const Values& bytes) {
    Image made(width, height, channels);
    std::ranges::copy(bytes, made.bytes().begin());
    return made;
}

// All of `points`, averaged.
Values averaged(const Image& points, int side) {
    Image picture(points.width() / side, points.height() / side, points.channels());
    average_into(points, side, picture, 0, 0);
    return {picture.bytes().begin(), picture.bytes().end()};
}

Image filled(int width, int height, int channels, std::uint8_t value) {
    Image image(width, height, channels);
    std::ranges::fill(image.bytes(), value);
    return image;
}

std::vector<int> pixel(const Image& image, int x, int y) { return {image.at(x, y), image.at(x, y) + image.channels()}; }

}  // namespace

TEST(Average, RoundsHalvesUp) {
    EXPECT_EQ(averaged(image(2, 2, 3, {0, 1, 255, 0, 1, 255, 0, 0, 255, 1, 0, 255}), 2), (Values{0, 1, 255}));
    EXPECT_EQ(averaged(image(2, 2, 3, {10, 0, 0, 11, 0, 0, 10, 0, 0, 11, 0, 1}), 2), (Values{11, 0, 0}));
    Values sixteen(48, 0);
    for (std::size_t i = 0; i < 8; ++i) sixteen[3 * i] = 1;      // 8 / 16
    for (std::size_t i = 0; i < 7; ++i) sixteen[3 * i + 1] = 1;  // 7 / 16
    for (std::size_t i = 0; i < 16; ++i) sixteen[3 * i + 2] = 255;
    EXPECT_EQ(averaged(image(4, 4, 3, sixteen), 4), (Values{1, 0, 255}));
}

TEST(Average, OfOnePointIsThatPoint) {
    const Values bytes = {1, 2, 3, 4, 250, 6, 7, 128};
    EXPECT_EQ(averaged(image(2, 1, 4, bytes), 1), bytes);
}

TEST(Average, OfClearPointsIsAllZero) {
    EXPECT_EQ(averaged(image(2, 2, 4, {9, 9, 9, 0, 9, 9, 9, 0, 9, 9, 9, 0, 9, 9, 9, 0}), 2), (Values{0, 0, 0, 0}));
    // An alpha that rounds to 0 takes its colour with it.
    EXPECT_EQ(averaged(image(2, 2, 4, {9, 9, 9, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), 2), (Values{0, 0, 0, 0}));
}

TEST(Average, ClearPointsDoNotDarkenAnEdge) {
    EXPECT_EQ(averaged(image(2, 2, 4, {200, 100, 3, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), 2), (Values{200, 100, 3, 64}));
    EXPECT_EQ(averaged(image(2, 2, 4, {200, 0, 0, 255, 101, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0, 0}), 2), (Values{151, 0, 0, 128}));
}

TEST(Average, IsTheRoundedFractionOfRandomPoints) {
    std::mt19937 random(7);
    for (const int side : {2, 4}) {
        for (const int channels : {3, 4}) {
            Image points(12, 8, channels);
            for (std::uint8_t& byte : points.bytes()) byte = static_cast<std::uint8_t>(random() % 3 == 0 ? 255 : random());
            const std::string bytes(points.bytes().begin(), points.bytes().end());
            const Values found = averaged(points, side);
            EXPECT_EQ(std::string(found.begin(), found.end()), test::averaged({12, 8, channels, bytes}, side).bytes);
        }
    }
}

TEST(Average, WritesNothingBesideItsPart) {
    Image picture(4, 3, 3);
    std::ranges::fill(picture.bytes(), std::uint8_t{77});
    Image points(4, 2, 3);
    std::ranges::fill(points.bytes(), std::uint8_t{9});
    average_into(points, 2, picture, 1, 2);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) EXPECT_EQ(*picture.at(x, y), y == 2 && (x == 1 || x == 2) ? 9 : 77) << x << "," << y;
    }
}

TEST(Compare, FindsEqualPicturesEqual) {
    const Image a = filled(3, 2, 3, 100);
    const Image b = filled(3, 2, 3, 100);
    EXPECT_TRUE(compare(a, b).equal());
    EXPECT_EQ(describe(compare(a, b)), "the pictures are equal");
}

TEST(Compare, SaysHowManyHowFarAndWhereTheFirstIs) {
    const Image expected = filled(3, 2, 3, 100);
    Image actual = filled(3, 2, 3, 100);
    actual.at(2, 0)[1] = 90;
    actual.at(0, 1)[0] = 103;
    actual.at(0, 1)[2] = 255;
    const Comparison comparison = compare(actual, expected);
    EXPECT_FALSE(comparison.equal());
    EXPECT_EQ(comparison.different_pixels, 2);
    EXPECT_EQ(comparison.largest, (std::array<int, 4>{3, 10, 155, 0}));
    EXPECT_EQ(describe(comparison),
              "2 of 6 pixels differ, by at most R 3 G 10 B 155; the first at pixel 2,0: found (100, 90, 100), expected "
              "(100, 100, 100)");
}

TEST(Compare, TakesAPictureWithoutAlphaForOpaque) {
    const Image rgb = filled(2, 1, 3, 9);
    Image rgba = filled(2, 1, 4, 9);
    rgba.at(0, 0)[3] = 255;
    rgba.at(1, 0)[3] = 255;
    EXPECT_TRUE(compare(rgb, rgba).equal());
    EXPECT_TRUE(compare(rgba, rgb).equal());
    rgba.at(1, 0)[3] = 250;
    const Comparison comparison = compare(rgba, rgb);
    EXPECT_EQ(describe(comparison),
              "1 of 2 pixels differ, by at most R 0 G 0 B 0 A 5; the first at pixel 1,0: found (9, 9, 9, 250), expected "
              "(9, 9, 9, 255)");
}

TEST(Compare, TakesAnotherSizeForADifference) {
    const Image a = filled(3, 2, 3, 1);
    const Image b = filled(2, 3, 3, 1);
    EXPECT_FALSE(compare(a, b).same_size());
    EXPECT_FALSE(compare(a, b).equal());
    EXPECT_EQ(describe(compare(a, b)), "the picture is 3x2, expected 2x3");
}

namespace {

PngReader reader_of(const Image& picture) {
    return {"golden.png", [bytes = encode_png(picture), done = std::size_t{0}](char* to, std::size_t most) mutable {
                const std::size_t count = bytes.copy(to, most, done);
                done += count;
                return count;
            }};
}

Image difference_picture(const Image& actual, const Image& expected) {
    PngReader reader = reader_of(expected);
    Image difference;
    compare(actual, reader, &difference);
    return difference;
}

}  // namespace

TEST(DifferencePicture, DimsEqualPixelsAndWhitensDifferentOnes) {
    const Image expected = filled(2, 1, 3, 100);
    Image actual = filled(2, 1, 3, 100);
    actual.at(1, 0)[2] = 101;
    const Image picture = difference_picture(actual, expected);
    EXPECT_EQ(picture.channels(), 3);
    EXPECT_EQ(pixel(picture, 0, 0), (std::vector<int>{25, 25, 25}));
    EXPECT_EQ(pixel(picture, 1, 0), (std::vector<int>{255, 255, 255}));
}

TEST(DifferencePicture, ShowsInMagentaWhereOnlyOnePictureReaches) {
    const Image wide = filled(3, 1, 3, 8);
    const Image high = filled(1, 2, 4, 8);
    const Image picture = difference_picture(wide, high);
    EXPECT_EQ(picture.width(), 3);
    EXPECT_EQ(picture.height(), 2);
    EXPECT_EQ(pixel(picture, 0, 0), (std::vector<int>{255, 255, 255}));  // alpha 8 against opaque
    for (const auto& [x, y] : {std::pair{1, 0}, {2, 0}, {0, 1}, {1, 1}}) {
        EXPECT_EQ(pixel(picture, x, y), (std::vector<int>{255, 0, 255})) << x << "," << y;
    }
}

TEST(DifferencePicture, IsRefusedWhereBothPicturesTogetherAreTooLarge) {
    const Image wide = filled(30'000, 1, 3, 8);
    const Image high = filled(1, 30'000, 3, 8);
    PngReader reader = reader_of(high);
    EXPECT_FALSE(compare(wide, reader).same_size());
    EXPECT_EQ(
        message_of<InputError>([&] { difference_picture(wide, high); }),
        "golden.png: the picture of the difference, of 30000x30000 pixels, is too large: expected at most 429,496,729 pixels");
}

}  // namespace sphereview
