#include "image/picture_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "image/png.hpp"
#include "support/temporary_folder.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

std::vector<int> values(const Image& image) { return {image.bytes().begin(), image.bytes().end()}; }
std::vector<int> values_of(const std::string& bytes) {
    const test::TemporaryFolder folder;
    return values(read_picture(folder.write("p", bytes)));
}

// Two pixels, one above the other, of 24 bits; rows from below, each filled up to four bytes.
std::string small_bmp() {
    const std::string head("BM\x3e\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\1\0\0\0\2\0\0\0\1\0\x18\0\0\0\0\0\x08\0\0\0", 38);
    return head + std::string(16, '\0') + std::string("\3\2\1\0\6\5\4\0", 8);
}

}  // namespace

TEST(PictureFile, ReadsWhatOtherProgramsWrite) {
    EXPECT_EQ(values_of("P3\n# by hand\n2 1 255\n1 2 3\n# more\n 255 254 253"), (std::vector{1, 2, 3, 255, 254, 253}));
    EXPECT_EQ(values_of("P3 1 1 15 15 0 7"), (std::vector{255, 0, 119}));
    EXPECT_EQ(values_of("P2\n1 2\n100\n100\n50\n"), (std::vector{255, 255, 255, 128, 128, 128}));
    EXPECT_EQ(values_of("P6\n1 1\n255\n\1\2\3"), (std::vector{1, 2, 3}));
    EXPECT_EQ(values_of("P5 2 1 255\n\7\10"), (std::vector{7, 7, 7, 8, 8, 8}));
    EXPECT_EQ(values_of(small_bmp()), (std::vector{4, 5, 6, 1, 2, 3}));
    std::string from_above = small_bmp();
    from_above.replace(22, 4, "\xfe\xff\xff\xff");
    EXPECT_EQ(values_of(from_above), (std::vector{1, 2, 3, 4, 5, 6}));
    Image image(1, 1, 4);
    for (std::size_t i = 0; i < 4; ++i) image.bytes()[i] = static_cast<std::uint8_t>(9 + i);
    EXPECT_EQ(values_of(encode_png(image)), values(image));
}

TEST(PictureFile, SaysWhatIsWrong) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"", "p: found an empty file, expected a PNG, PPM, PGM or BMP picture"},
        {"GIF89a", "p: found a GIF picture, expected a PNG, PPM, PGM or BMP picture"},
        {"\xFF\xD8\xFF\xE0", "p: found a JPEG picture, whose colours are not exact, expected a PNG, PPM, PGM or BMP picture"},
        {"RIFF1234WEBPVP8", "p: found a WebP picture, expected a PNG, PPM, PGM or BMP picture"},
        {"sphere", "p: found a file that begins with 'sphere', expected a PNG, PPM, PGM or BMP picture"},
        {"P6 90 90 255 123", "p: found 16 bytes, expected more for a picture of 90 x 90 pixels"},
        {"P3\n1 1\n255\n1 2", "p:4:4: found the end of the file, expected a value, 0 to 255"},
        {"P3\n1 1\n255\n1 256 3", "p:4:3: found '256', expected a value, 0 to 255"},
        {"P3 0 1 255 1", "p:1:4: found '0', expected the width, 1 to 2147483647"},
        {"P3 1 1 255 # no end", "p:1:20: found the end of the file, expected a value, 0 to 255"},
        {"P2 65536 65536 255 1", "p: found a picture of 65536 x 65536 pixels, expected 1 to 429,496,729"},
        {"P6\n2 2\n255\n123", "p: found the end of the file, expected more pixels"},
        {"BM", "p: not a usable BMP: unknown image type"},
        {small_bmp().substr(0, 60), "p: found 60 bytes of a BMP, expected 62"},
    };
    const test::TemporaryFolder folder;
    for (const auto& refused : cases) {
        const std::string path = folder.write("p", refused.first);
        EXPECT_EQ(message_of<InputError>([&] { read_picture(path); }), folder.path() + "/" + refused.second);
    }
}

#ifndef _WIN32
TEST(PictureFile, WhatIsNoneIsNotReadToItsEnd) {
    EXPECT_EQ(
        message_of<InputError>([] { read_picture("/dev/zero"); }),
        "/dev/zero: found a file that begins with '\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00', expected a PNG, PPM, PGM or BMP "
        "picture");
}
#endif

}  // namespace sphereview
