// PLY.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include "formats/scene_format.hpp"
#include "support/spheres.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

using namespace std::string_literals;

SphereData ply(const std::string& text, const DataOptions& options = {}) { return read_ply(text, "a.ply", options); }

std::string ply_head(const std::string& format, const std::string& rest) {
    return "ply\nformat " + format + " 1.0\n" + rest + "end_header\n";
}

const std::string ply_xyz = "property float x\nproperty float y\nproperty float z\n";

// The bytes of a number, in the order of the file.
template <typename Number>
std::string bytes_of(Number number, bool big_endian) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    if (big_endian != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
    return bytes;
}

Centers ply_centers(const std::string& text) { return centers_of(ply(text).scene); }

using Points = Centers;

}  // namespace

TEST(Ply, ReadsPointsInText) {
    const std::string text = ply_head("ascii", "element vertex 2\n" + ply_xyz) + "0 0 0\n1 0 0\n";
    const SphereData data = ply(text);
    ASSERT_EQ(data.scene.spheres.size(), 2U);
    EXPECT_EQ(data.scene.spheres[1], (Sphere{{1, 0, 0}, 0.25, {255, 255, 255}, false}));
    ASSERT_EQ(data.warnings.size(), 1U);
    EXPECT_TRUE(data.warnings[0].starts_with("a.ply: no radius in the file: all get 0.25")) << data.warnings[0];
    EXPECT_EQ(ply(text, {.radius = 2.0}).scene.spheres[0].radius, 2.0);
    for (const char* name : {"a", "a.txt", "stdin"}) EXPECT_EQ(detect_format(text, name).name, "PLY");
    EXPECT_EQ(format_of_name("a.PLY").name, "PLY");
    std::string crlf;
    std::string cr;
    for (const char c : text) {
        crlf += c == '\n' ? "\r\n" : std::string(1, c);
        cr += c == '\n' ? '\r' : c;
    }
    EXPECT_EQ(ply(crlf).scene, data.scene);
    EXPECT_EQ(ply(cr).scene, data.scene);
}

TEST(Ply, PassesOverWhatItDoesNotDraw) {
    const std::string head =
        ply_head("ascii",
                 "comment made by hand\nobj_info 1\nelement camera 2\nproperty list uchar int of\nelement vertex 3\n"
                 "property list uchar float weights\nproperty uchar quality\nproperty double z\nproperty float y\n"
                 "property int x\nproperty float radius\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                 "property uchar alpha\nelement face 1\nproperty list uchar int vertex_indices\n");
    const std::string text =
        head + "3 1 2 3\n0\n2 0.5 0.5 9 3e0 2 1 0.5 255 128 0 255\n\n0 9 6 5 4 0 1 2 3 255\n  0 9 nan 8 7 1 1 2 3 0\n3 0 1 2\n";
    const SphereData data = ply(text);
    ASSERT_EQ(data.scene.spheres.size(), 2U);
    EXPECT_EQ(data.scene.spheres[0], (Sphere{{1, 2, 3}, 0.5, {255, 128, 0}, false}));
    EXPECT_EQ(data.scene.spheres[1], (Sphere{{4, 5, 6}, 1.0, {1, 2, 3}, false}));  // 0 is no radius
    EXPECT_EQ(data.warnings, (std::vector<std::string>{"a.ply: 1 vertex has no coordinates and is left out"}));
}

TEST(Ply, ReadsPointsInBytes) {
    for (const bool big : {false, true}) {
        const std::string format = big ? "binary_big_endian" : "binary_little_endian";
        const std::string color = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
        std::string text =
            ply_head(format, "element vertex 40000\nproperty double x\nproperty float y\nproperty short z\nproperty ushort q\n" +
                                 color + "property float radius\n");
        for (int i = 0; i < 40'000; ++i) {
            text += bytes_of(0.1 * i, big) + bytes_of(0.5F, big) + bytes_of(static_cast<std::int16_t>(-i / 2), big) +
                    bytes_of(static_cast<std::uint16_t>(7), big) + "\x01\x02\xFF"s + bytes_of(0.25F, big);
        }
        const SphereData data = ply(text);
        ASSERT_EQ(data.scene.spheres.size(), 40'000U);
        for (int i = 0; i < 40'000; ++i) {
            const Sphere& sphere = data.scene.spheres[static_cast<std::size_t>(i)];
            ASSERT_EQ(sphere, (Sphere{{0.1 * i, 0.5, -i / 2}, 0.25, {1, 2, 255}, false})) << i;
        }
        EXPECT_EQ(detect_format(text, "a").name, "PLY");
        // Lists before and among the vertices.
        const std::string lists =
            ply_head(format, "element face 2\nproperty list uchar int i\nproperty int n\nelement vertex 2\n" + ply_xyz +
                                 "property list ushort double l\nelement edge 5\nproperty int a\n") +
            "\x01"s + bytes_of(7, big) + bytes_of(8, big) + "\0"s + bytes_of(9, big) + bytes_of(1.0F, big) + bytes_of(2.0F, big) +
            bytes_of(3.0F, big) + bytes_of(std::uint16_t{2}, big) + bytes_of(1.0, big) + bytes_of(1.0, big) + bytes_of(4.0F, big) +
            bytes_of(5.0F, big) + bytes_of(6.0F, big) + bytes_of(std::uint16_t{0}, big);
        EXPECT_EQ(ply_centers(lists), (Points{{1, 2, 3}, {4, 5, 6}}));
    }
}

TEST(Ply, ColoursAreWhatTheColumnsHold) {
    const auto color = [](const std::string& type, const std::string& values) {
        const std::string head = ply_head("ascii", "element vertex 1\n" + ply_xyz + "property " + type + " red\nproperty " + type +
                                                       " green\nproperty " + type + " blue\n");
        return ply(head + "0 0 0 " + values + "\n").scene.spheres.at(0).color;
    };
    EXPECT_EQ(color("uchar", "255 128 0"), (Color{255, 128, 0}));
    EXPECT_EQ(color("uchar", "1 1 0"), (Color{1, 1, 0}));
    EXPECT_EQ(color("ushort", "65535 32896 0"), (Color{255, 128, 0}));
    EXPECT_EQ(color("float", "1 0.5 0"), (Color{255, 128, 0}));
    EXPECT_EQ(color("float", "255.0 128 0"), (Color{255, 128, 0}));
    EXPECT_EQ(color("float", "0 65535 32896"), (Color{0, 255, 128}));  // as in other tables
    for (const char* none : {"nan 1 1", "1 -1 1", "1 1 1e999", "NA 0.5 0"}) {
        EXPECT_EQ(color("float", none), (Color{255, 255, 255})) << none;
    }
    const std::string diffuse = "property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n";
    EXPECT_EQ(ply(ply_head("ascii", "element vertex 1\n" + ply_xyz + diffuse) + "0 0 0 1 2 3\n").scene.spheres.at(0).color,
              (Color{1, 2, 3}));
    const std::string diameter = "property float diameter\n";
    EXPECT_EQ(ply(ply_head("ascii", "element vertex 1\n" + ply_xyz + diameter) + "0 0 0 3\n").scene.spheres.at(0).radius, 1.5);
}

TEST(Ply, MayHaveBlankLinesAndNoZ) {
    const std::vector<glm::dvec3> places = {{1, 2, 3}, {4, 5, 6}};
    EXPECT_EQ(ply_centers(ply_head("ascii", "element vertex 2\n" + ply_xyz) + "\n \n1 2 3\n\n4 5 6\n\n"), places);
    const SphereData flat = ply(ply_head("ascii", "element vertex 2\nproperty float x\nproperty float y\n") + "1 2\n4 5\n");
    EXPECT_EQ(flat.scene.spheres.at(1).center, glm::dvec3(4, 5, 0));
    EXPECT_EQ(flat.warnings.at(0), "a.ply: no property z: all lie in the plane z = 0");
}

TEST(PlyErrors, SayWhatIsWrong) {
    const auto read = [](const std::string& text) { ply(text); };
    const auto ascii = [](const std::string& rest) { return ply_head("ascii", rest); };
    const auto binary = [](const std::string& rest) { return ply_head("binary_little_endian", rest); };
    const std::string list = "property list uchar int a\n";
    std::string many = "ply\nformat ascii 1.0\nelement e 1\n";
    for (int i = 0; i < 10'000; ++i) many += "property int a\n";
    expect_messages(
        "a.ply", read,
        {
            {"", "1:1: the text ends, expected end_header"},
            {"hello\n", "1:1: found 'hello', expected ply"},
            {"ply\n", "2:1: the text ends, expected end_header"},
            {"ply\nend_header\n", "2:1: found 'end_header', expected the line format before it"},
            {"ply\nformat\n", "2:7: the line ends, expected ascii, binary_little_endian or binary_big_endian"},
            {"ply\nformat xml 1.0\n", "2:8: found 'xml', expected ascii, binary_little_endian or binary_big_endian"},
            {"ply\nhello\n", "2:1: found 'hello', expected format, element, property, comment or end_header"},
            {"ply\nproperty int a\n", "2:1: found 'property', expected an element before it"},
            {"ply\nelement vertex -1\n", "2:16: found '-1', expected the number of elements, a whole number"},
            {"ply\nelement vertex 1\nproperty half x\n",
             "3:10: found 'half', expected a type: char, uchar, short, ushort, int, uint, float, double, or a list"},
            {"ply\nelement vertex 1\nproperty list float int x\n",
             "3:15: found 'float', expected a whole type for the number of a list's values"},
            {many, "10003:1: found 'property', expected at most 10,000 elements and properties"},
            {ascii(""), "4:1: found no element vertex, expected one in the header"},
            {ascii("element vertex 1\nproperty int x\n"),
             "3:9: found vertices without x and y, expected these among their properties"},
            {ascii("element vertex 2\n" + ply_xyz) + "0 0 0\n", "9:1: the text ends, expected vertex 2 of 2"},
            {ascii("element vertex 1000000000000000000\n" + ply_xyz) + "0 0 0\n",
             "9:1: the text ends, expected vertex 2 of 1000000000000000000"},
            {ascii("element vertex 1\n" + ply_xyz) + "0 0\n", "8:4: the line ends, expected 'z' of vertex 1 of 1"},
            {ascii("element vertex 1\n" + ply_xyz) + "0 zero 0\n", "8:3: found 'zero', expected 'y' of vertex 1 of 1, a number"},
            {ascii("element vertex 1\n" + ply_xyz) + "0 1e999 0\n",
             "8:3: found '1e999', expected 'y' of vertex 1 of 1, a number that a double can hold (at most 1.8e308)"},
            {ascii("element vertex 1\n" + list + ply_xyz) + "1000000000000 0 0 0\n",
             "9:1: found '1000000000000', expected 'a' of vertex 1 of 1 from 0 to 19"},
            {binary("element vertex 1000000000000000000\n" + ply_xyz) + "01234567890123456789",
             "8:21: the file ends, expected 'vertex' 2 of 1000000000000000000"},
            {binary("element face 18446744073709551615\nproperty double a\nelement vertex 1\n" + ply_xyz) + "0123456789",
             "10:11: the file ends, expected 'face' 2 of 18446744073709551615"},
            {binary("element face 18446744073709551615\n" + list + "element vertex 1\n" + ply_xyz) + "\0\0\x02"s + "abcdefg",
             "10:11: the file ends, expected 'face' 3 of 18446744073709551615"},
            {binary("element vertex 1\n" + ply_xyz + "property list char int a\n") + "0123456789AB\xFF",
             "9:13: found a list of -1 values, expected 0 or more"},
        });
}

}  // namespace sphereview
