#include "image/compare.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace sphereview {

namespace {

Image filled(int width, int height, int channels, std::uint8_t value) {
    Image image(width, height, channels);
    std::ranges::fill(image.bytes(), value);
    return image;
}

std::vector<int> pixel(const Image& image, int x, int y) { return {image.at(x, y), image.at(x, y) + image.channels()}; }

}  // namespace

TEST(Compare, FindsEqualPicturesEqual) {
    const Image a = filled(3, 2, 3, 100);
    const Image b = filled(3, 2, 3, 100);
    EXPECT_TRUE(compare(a, b).equal());
    EXPECT_EQ(describe(compare(a, b), a, b), "the pictures are equal");
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
    EXPECT_EQ(describe(comparison, actual, expected),
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
    EXPECT_EQ(describe(comparison, rgba, rgb),
              "1 of 2 pixels differ, by at most R 0 G 0 B 0 A 5; the first at pixel 1,0: found (9, 9, 9, 250), expected "
              "(9, 9, 9, 255)");
}

TEST(Compare, TakesAnotherSizeForADifference) {
    const Image a = filled(3, 2, 3, 1);
    const Image b = filled(2, 3, 3, 1);
    EXPECT_FALSE(compare(a, b).same_size);
    EXPECT_FALSE(compare(a, b).equal());
    EXPECT_EQ(describe(compare(a, b), a, b), "the picture is 3x2, expected 2x3");
}

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

}  // namespace sphereview
