// Our PNGs, judged by libpng.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "image/png.hpp"
#include "support/picture.hpp"

namespace sphereview {

namespace {

void expect_libpng_reads(const Image& image) {
    SCOPED_TRACE(std::to_string(image.width()) + "x" + std::to_string(image.height()) + "x" + std::to_string(image.channels()));
    const std::string bytes(image.bytes().begin(), image.bytes().end());
    const std::string file = encode_png(image);
    EXPECT_EQ(test::decode_png(file), (test::Picture{image.width(), image.height(), image.channels(), bytes}));
    EXPECT_EQ(encode_png(image), file);  // the same picture gives the same file
    const Image again = decode_png(file, "x.png");
    ASSERT_EQ(again.width(), image.width());
    ASSERT_EQ(again.channels(), image.channels());
    EXPECT_TRUE(std::ranges::equal(again.bytes(), image.bytes()));
}

}  // namespace

TEST(PngWriter, WritesWhatLibpngReads) {
    std::mt19937 random(1);
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 3}, {7, 5}, {255, 3}, {257, 129}}) {
        for (const int channels : {3, 4}) {
            Image noise(width, height, channels);
            for (std::uint8_t& byte : noise.bytes()) byte = static_cast<std::uint8_t>(random());
            expect_libpng_reads(noise);
            Image steps(width, height, channels);
            for (std::size_t i = 0; i < steps.bytes().size(); ++i) steps.bytes()[i] = static_cast<std::uint8_t>(i / 100);
            expect_libpng_reads(steps);
        }
    }
}

TEST(PngWriter, MakesAFlatPictureSmall) {
    Image image(1000, 1000, 3);
    std::ranges::fill(image.bytes(), std::uint8_t{200});
    EXPECT_LT(encode_png(image).size(), 20'000U);
}

}  // namespace sphereview
