// Lines, dots and letters over a picture.
#include "image/strokes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace sphereview {

namespace {

Image grey(int width, int height, int channels = 3, std::uint8_t level = 100) {
    Image image(width, height, channels);
    std::ranges::fill(image.bytes(), level);
    return image;
}

std::vector<int> at_pixel(const Image& image, int x, int y) { return {image.at(x, y), image.at(x, y) + image.channels()}; }

constexpr std::array<std::uint8_t, 3> white_ink{255, 255, 255};

}  // namespace

TEST(Strokes, CoverWholePixelsAndPartsOfThem) {
    Image image = grey(10, 5);
    // From the middle of pixel 2 to that of pixel 6, one pixel wide; half a pixel lower.
    draw(std::vector<Stroke>{{{40, 40}, {104, 40}, 16, white_ink}}, image);
    EXPECT_EQ(at_pixel(image, 4, 2), (std::vector<int>{255, 255, 255}));
    EXPECT_EQ(at_pixel(image, 4, 1), (std::vector<int>{100, 100, 100}));
    EXPECT_EQ(at_pixel(image, 4, 3), (std::vector<int>{100, 100, 100}));
    Image lower = grey(10, 5);
    draw(std::vector<Stroke>{{{40, 48}, {104, 48}, 16, white_ink}}, lower);
    EXPECT_EQ(at_pixel(lower, 4, 2), (std::vector<int>{178, 178, 178})) << "(255 + 100) / 2, halves rounded up";
    EXPECT_EQ(at_pixel(lower, 4, 3), (std::vector<int>{178, 178, 178}));
}

TEST(Strokes, ADotIsRound) {
    Image image = grey(40, 40, 3, 0);
    draw(std::vector<Stroke>{{{320, 320}, {320, 320}, 320, white_ink}}, image);
    double area = 0.0;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) {
            area += *image.at(x, y) / 255.0;
            EXPECT_EQ(*image.at(x, y), *image.at(39 - x, y)) << "symmetric";
            EXPECT_EQ(*image.at(x, y), *image.at(y, x));
        }
    }
    EXPECT_NEAR(area, 314.16, 2.0);
}

TEST(Strokes, WhatIsBeyondThePictureIsLeftOut) {
    Image image = grey(8, 8);
    draw(std::vector<Stroke>{{{-1000, -1000}, {1000, 1000}, 32, white_ink}, {{9000, 20}, {9000, 20}, 64, white_ink}}, image);
    EXPECT_EQ(at_pixel(image, 3, 3), (std::vector<int>{255, 255, 255}));
    EXPECT_EQ(at_pixel(image, 7, 0), (std::vector<int>{100, 100, 100}));
}

TEST(Strokes, MakeATransparentPictureOpaqueWhereTheyAre) {
    Image image = grey(8, 8, 4, 0);
    draw(std::vector<Stroke>{{{64, 64}, {64, 64}, 64, {200, 100, 50}}}, image);
    EXPECT_EQ(at_pixel(image, 4, 4), (std::vector<int>{200, 100, 50, 255}));
    EXPECT_EQ(at_pixel(image, 0, 0), (std::vector<int>{0, 0, 0, 0}));
    const std::vector<int> edge = at_pixel(image, 2, 3);
    EXPECT_GT(edge[3], 0);
    EXPECT_LT(edge[3], 255);
    EXPECT_EQ(edge[0], 200) << "the colour is that of the covered part alone";
}

TEST(Strokes, LettersStayInTheirPlace) {
    Image image = grey(200, 30, 3, 0);
    const int unit = 32;
    draw(strokes_of_text("20 at depth 300", {160, 160}, unit, unit, white_ink), image);
    const int right = (160 + width_of_strokes("20 at depth 300", unit)) / stroke_unit;
    int lit = 0;
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 200; ++x) {
            if (*image.at(x, y) == 0) continue;
            ++lit;
            EXPECT_GE(x, 10);
            EXPECT_LE(x, right);
            EXPECT_GE(y, 10);
            EXPECT_LE(y, 10 + 2 * (height_of_letters + 2)) << "p goes below the line";
        }
    }
    EXPECT_GT(lit, 400);
    EXPECT_TRUE(strokes_of_text("\xC3\xBC\n", {0, 0}, unit, unit, white_ink).empty());
    EXPECT_EQ(width_of_strokes("", unit), 0);
}

}  // namespace sphereview
