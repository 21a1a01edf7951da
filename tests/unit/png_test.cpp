// Our PNG code and libpng: each reads what the other wrote.
#include "image/png.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "image/compare.hpp"
#include "support/folders.hpp"
#include "support/picture.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes noise(std::size_t size) {
    std::mt19937 random(1);
    Bytes bytes(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    return bytes;
}

// One of the files that the fuzzer begins with; libpng wrote it. rgb_interlaced holds noise(13 * 11 * 3).
std::string corpus(const std::string& name) {
    return std::string(InputFile(test::source_file("tests/fuzz/corpus/png/" + name + ".png"), Content::binary).bytes());
}

test::Picture as_picture(const Image& image) {
    return {image.width(), image.height(), image.channels(), {image.bytes().begin(), image.bytes().end()}};
}

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
    const std::string file = encode_png(image);
    EXPECT_EQ(test::decode_png(file), as_picture(image));
    EXPECT_EQ(encode_png(image), file);  // the same picture gives the same file
    EXPECT_EQ(as_picture(decode_png(file, "x.png")), as_picture(image));
}

}  // namespace

TEST(PngReader, ReadsEveryKindAsLibpngsSimpleReaderDoes) {
    for (const std::string name : {"rgb", "rgba", "grey", "grey_alpha", "grey1", "grey4", "palette", "palette2", "palette_alpha",
                                   "rgb_clear", "grey_clear", "interlaced", "rgb_interlaced"}) {
        const std::string file = corpus(name);
        EXPECT_EQ(as_picture(decode_png(file, "x.png")), test::decode_png(file)) << name;
    }
    EXPECT_EQ(test::decode_png(corpus("rgb_clear")).at(0, 0), (std::vector<int>{1, 2, 3, 0}));
    EXPECT_EQ(test::decode_png(corpus("palette2")).at(0, 0), (std::vector<int>{3, 4, 5}));
    EXPECT_EQ(test::decode_png(corpus("grey4")).at(0, 0), (std::vector<int>{17, 17, 17}));
}

TEST(PngReader, RefusesSixteenBitsRatherThanRoundThem) {
    EXPECT_EQ(refusal(corpus("sixteen")), "x.png: not a usable PNG: its channels have 16 bits, expected 8");
}

TEST(PngReader, RefusesEveryTruncatedFile) {
    for (const std::string name : {"rgb", "rgb_interlaced"}) {
        const std::string file = corpus(name);
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
    const std::string grey = corpus("grey");
    EXPECT_EQ(refusal(with_size(grey, std::string("\0\0\x60\0", 4))),
              "x.png: found 603,979,776 pixels, expected at most 429,496,729");
    EXPECT_TRUE(refusal(with_size(grey, std::string(4, '\0'))).starts_with("x.png: not a usable PNG: "));
}

TEST(PngReader, GivesRowsOfAnInterlacedFileOutOfOrderButTheFirstDifferenceInReadingOrder) {
    const Bytes bytes = noise(13 * 11 * 3);
    const std::string file = corpus("rgb_interlaced");
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
    const std::string good = corpus("rgb");
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
    const std::string good = corpus("rgb_interlaced");
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
