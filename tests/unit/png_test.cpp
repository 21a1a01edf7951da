// Our PNG code and libpng: each reads what the other wrote.
#include "image/png.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "image/compare.hpp"
#include "support/picture.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

// What libpng shall write. `rows` holds the packed bytes of all rows, top row first, as the PNG standard lays them out.
struct PngSpec {
    int width = 1;
    int height = 1;
    int color_type = PNG_COLOR_TYPE_RGB;
    std::vector<std::uint8_t> rows;
    int depth = 8;
    bool interlaced = false;
    std::vector<png_color> palette = {};
    std::vector<std::uint8_t> palette_alpha = {};  // a tRNS chunk for the first colours of the palette
    bool has_clear_color = false;                  // a tRNS chunk that makes one colour of an RGB or grey picture transparent
    png_color_16 clear_color{};
};

// A specification that libpng refuses is a mistake in a test.
[[noreturn]] void on_error(png_structp /*png*/, png_const_charp message) {
    std::fprintf(stderr, "libpng: %s\n", message);
    std::abort();
}

void append(png_structp png, png_bytep data, png_size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

std::string libpng_written(PngSpec spec) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(spec.width), static_cast<png_uint_32>(spec.height), spec.depth,
                 spec.color_type, spec.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (!spec.palette.empty()) png_set_PLTE(png, info, spec.palette.data(), static_cast<int>(spec.palette.size()));
    if (!spec.palette_alpha.empty()) {
        png_set_tRNS(png, info, spec.palette_alpha.data(), static_cast<int>(spec.palette_alpha.size()), nullptr);
    }
    if (spec.has_clear_color) png_set_tRNS(png, info, nullptr, 0, &spec.clear_color);

    std::vector<png_bytep> rows;
    const std::size_t row_bytes = png_get_rowbytes(png, info);
    for (int y = 0; y < spec.height; ++y) rows.push_back(spec.rows.data() + static_cast<std::size_t>(y) * row_bytes);
    png_set_rows(png, info, rows.data());
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

using Bytes = std::vector<std::uint8_t>;

struct Case {
    const char* kind;
    PngSpec png;
    int channels;
    Bytes pixels;
};

Bytes noise(std::size_t size) {
    std::mt19937 random(1);
    Bytes bytes(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    return bytes;
}

PngSpec noisy_rgb(bool interlaced) { return {.width = 13, .height = 11, .rows = noise(13 * 11 * 3), .interlaced = interlaced}; }

// The file with another width and height, 4 bytes, and the sum that belongs to them.
std::string with_size(std::string file, const std::string& side) {
    file.replace(16, 4, side).replace(20, 4, side);
    const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(file.data() + 12), 17);
    for (std::size_t i = 0; i < 4; ++i) file[29 + i] = static_cast<char>(sum >> (24 - 8 * i));
    return file;
}

std::string refusal(std::string_view file) {
    return message_of<InputError>([&] { decode_png(file, "x.png"); });
}

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

TEST(PngReader, ReadsEveryKindAsRgbOrRgba) {
    const std::vector<png_color> palette = {{255, 1, 2}, {3, 4, 5}, {6, 7, 8}};
    const std::vector<Case> cases = {
        {"RGB", {.width = 2, .rows = {1, 2, 3, 4, 5, 6}}, 3, {1, 2, 3, 4, 5, 6}},
        {"RGBA", {.color_type = PNG_COLOR_TYPE_RGBA, .rows = {1, 2, 3, 0}}, 4, {1, 2, 3, 0}},
        {"grey", {.width = 2, .color_type = PNG_COLOR_TYPE_GRAY, .rows = {0, 77}}, 3, {0, 0, 0, 77, 77, 77}},
        {"grey with alpha", {.color_type = PNG_COLOR_TYPE_GRAY_ALPHA, .rows = {9, 128}}, 4, {9, 9, 9, 128}},
        {"1-bit grey",
         {.width = 3, .color_type = PNG_COLOR_TYPE_GRAY, .rows = {0b10100000}, .depth = 1},
         3,
         {255, 255, 255, 0, 0, 0, 255, 255, 255}},
        {"4-bit grey", {.width = 2, .color_type = PNG_COLOR_TYPE_GRAY, .rows = {0x1F}, .depth = 4}, 3, {17, 17, 17, 255, 255, 255}},
        {"palette",
         {.width = 2, .color_type = PNG_COLOR_TYPE_PALETTE, .rows = {2, 0}, .palette = palette},
         3,
         {6, 7, 8, 255, 1, 2}},
        {"2-bit palette",
         {.width = 2, .color_type = PNG_COLOR_TYPE_PALETTE, .rows = {0b01100000}, .depth = 2, .palette = palette},
         3,
         {3, 4, 5, 6, 7, 8}},
        {"palette with alpha",
         {.width = 2, .color_type = PNG_COLOR_TYPE_PALETTE, .rows = {0, 1}, .palette = palette, .palette_alpha = {64}},
         4,
         {255, 1, 2, 64, 3, 4, 5, 255}},
        {"RGB with a clear colour",
         {.width = 2, .rows = {1, 2, 3, 4, 5, 6}, .has_clear_color = true, .clear_color = {0, 1, 2, 3, 0}},
         4,
         {1, 2, 3, 0, 4, 5, 6, 255}},
        {"grey with a clear colour",
         {.width = 2, .color_type = PNG_COLOR_TYPE_GRAY, .rows = {5, 6}, .has_clear_color = true, .clear_color = {0, 0, 0, 0, 6}},
         4,
         {5, 5, 5, 255, 6, 6, 6, 0}},
        {"interlaced", noisy_rgb(true), 3, noise(13 * 11 * 3)},
        {"not interlaced", noisy_rgb(false), 3, noise(13 * 11 * 3)},
    };
    for (const Case& input : cases) {
        SCOPED_TRACE(input.kind);
        const Image image = decode_png(libpng_written(input.png), "x.png");
        EXPECT_EQ(image.width(), input.png.width);
        EXPECT_EQ(image.height(), input.png.height);
        EXPECT_EQ(image.channels(), input.channels);
        EXPECT_EQ(Bytes(image.bytes().begin(), image.bytes().end()), input.pixels);
    }
}

TEST(PngReader, RefusesSixteenBitsRatherThanRoundThem) {
    const std::string rgb = libpng_written({.rows = {0, 1, 0, 2, 0, 3}, .depth = 16});
    const std::string grey = libpng_written({.color_type = PNG_COLOR_TYPE_GRAY, .rows = {0, 1}, .depth = 16});
    EXPECT_EQ(refusal(rgb), "x.png: not a usable PNG: its channels have 16 bits, expected 8");
    EXPECT_EQ(refusal(grey), "x.png: not a usable PNG: its channels have 16 bits, expected 8");
}

TEST(PngReader, RefusesEveryTruncatedFile) {
    for (const bool interlaced : {false, true}) {
        const std::string file = libpng_written(noisy_rgb(interlaced));
        // The last 4 bytes are a checksum behind the picture's end.
        for (std::size_t size = 0; size < file.size() - 4; ++size) {
            EXPECT_TRUE(refusal(file.substr(0, size)).starts_with("x.png: not a usable PNG: ")) << size;
        }
    }
}

TEST(PngReader, RefusesWhatIsNoPng) {
    for (const std::string file : {"", "x", "1\n255 0 0\n0 0 200\n20\n", "\x89PNG\r\n\x1a\n", "\xFF\xD8\xFF\xE0", "GIF89a"}) {
        EXPECT_TRUE(refusal(file).starts_with("x.png: not a usable PNG: ")) << file;
    }
}

TEST(PngReader, RefusesAClaimedSizeBeforeAnythingIsAllocated) {
    const std::string grey = libpng_written({.color_type = PNG_COLOR_TYPE_GRAY, .rows = {1}});
    EXPECT_EQ(refusal(with_size(grey, std::string("\0\0\x60\0", 4))),
              "x.png: found 603,979,776 pixels, expected at most 429,496,729");
    EXPECT_TRUE(refusal(with_size(grey, std::string(4, '\0'))).starts_with("x.png: not a usable PNG: "));
}

TEST(PngReader, GivesRowsOfAnInterlacedFileOutOfOrderButTheFirstDifferenceInReadingOrder) {
    const Bytes bytes = noise(13 * 11 * 3);
    const std::string file = libpng_written(noisy_rgb(true));
    Image actual(13, 11, 3);
    std::ranges::copy(bytes, actual.bytes().begin());
    const auto compared = [&] {
        PngReader reader("x.png", [rest = std::string_view(file)](char* to, std::size_t most) mutable {
            const std::size_t count = rest.copy(to, most);
            rest.remove_prefix(count);
            return count;
        });
        return compare(actual, reader);
    };
    EXPECT_TRUE(compared().equal());
    for (const auto& [x, y] : {std::pair{8, 8}, {1, 5}, {4, 4}, {3, 4}}) {  // of the first pass, the last, and two between
        actual.at(x, y)[1] ^= 1;
    }
    const Comparison comparison = compared();
    EXPECT_EQ(comparison.different_pixels, 4);
    EXPECT_EQ(std::pair(comparison.first_x, comparison.first_y), std::pair(3, 4));
}

TEST(PngReader, PassesOverTextsButNotOverOddTransparency) {
    const std::string good = libpng_written({.width = 2, .rows = {1, 2, 3, 4, 5, 6}});
    const auto with_chunk = [&](const std::string& type_and_content) {
        constexpr std::size_t behind_header = 33;
        std::string chunk(12 + type_and_content.size() - 4, '\0');
        chunk[3] = static_cast<char>(type_and_content.size() - 4);
        chunk.replace(4, type_and_content.size(), type_and_content);
        const auto* data = reinterpret_cast<const Bytef*>(type_and_content.data());
        const uLong sum = crc32(0, data, static_cast<uInt>(type_and_content.size()));
        for (std::size_t i = 0; i < 4; ++i) chunk[chunk.size() - 4 + i] = static_cast<char>(sum >> (24 - 8 * i));
        return std::string(good).insert(behind_header, chunk);
    };
    for (const char* chunk : {"tEXtno zero byte", "iCCPno profile", "abCdunknown"}) {
        EXPECT_EQ(decode_png(with_chunk(chunk), "x.png").channels(), 3) << chunk;
    }
    EXPECT_EQ(refusal(with_chunk("tRNSab")), "x.png: not a usable PNG: tRNS: invalid");
    EXPECT_EQ(refusal(with_chunk("ABCDunknown")), "x.png: not a usable PNG: ABCD: unhandled critical chunk");
}

TEST(PngReader, RefusesDamageOfAnyByte) {
    const std::string good = libpng_written(noisy_rgb(true));
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string file = good;
        file[i] = static_cast<char>(file[i] ^ 1);
        EXPECT_TRUE(refusal(file).starts_with("x.png: not a usable PNG: ")) << i;
    }
}

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
