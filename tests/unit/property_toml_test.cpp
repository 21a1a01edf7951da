// Properties in the native format.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "formats/scene_format.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

Scene scene_with_values(std::uint32_t count) {
    constexpr float small = std::numeric_limits<float>::denorm_min();
    Scene scene;
    std::vector<double> doubles;
    std::vector<float> floats;
    std::vector<std::int32_t> wholes;
    Labels labels{{"", "A \"1\"", "b", "never"}, {}};
    Labels plain;
    for (std::uint32_t i = 0; i < count; ++i) {
        scene.spheres.push_back({{i, 0.0, 200.0}, 1.0, {}, false});
        doubles.push_back(i % 3 == 0 ? NAN : i % 3 == 1 ? -0.0 : 0.1 * i);
        floats.push_back(i % 3 == 0 ? NAN : i % 3 == 1 ? small * static_cast<float>(i) : 0.1F * static_cast<float>(i));
        wholes.push_back(i % 4 == 0 ? no_whole_number : static_cast<std::int32_t>(i) - 5);
        labels.numbers.push_back(2 - i % 3);
        plain.numbers.push_back(i % 2);
    }
    if (count > 1) plain.words = {"C", "H"};
    scene.properties = {{"charge", doubles}, {"heat \"x\"", floats}, {"id", wholes}, {"chain", labels}, {"element", plain}};
    return scene;
}

const std::string two = "spheres = '''2\n0 0 0 0 0 0 1\n0 0 0 1 0 0 1'''\n[[property]]\nname = 'q'\n";

std::string fault_of(const std::string& text) {
    return message_of<InputError>([&] { parse_scene(text, "s.toml"); });
}

}  // namespace

TEST(PropertiesInToml, AreReadBackBitForBit) {
    for (const std::uint32_t count : {2U, 40U, 1000U, 1001U, 5000U}) {
        const Scene scene = scene_with_values(count);
        const std::string text = write_scene(scene, SceneFormat::toml);
        EXPECT_TRUE(parse_scene(text, "s.toml") == scene) << count;
        EXPECT_EQ(find_number_literals(text).has_value(), count > most_sphere_tables);
    }
    EXPECT_EQ(find_number_literals(write_scene(scene_with_values(1001), SceneFormat::toml))->literals.size(), 6U);
}

// Shortest without an exponent, but no integer of TOML.
TEST(PropertiesInToml, WholeNumbersOfMoreThan64BitsAreReadBack) {
    Scene scene = scene_with_values(2);
    scene.properties = {{"charge", std::vector<double>{-184467440737095516160.0, 9223372036854775808.0}},
                        {"heat", std::vector<float>{0x1p63F, -0x1p67F}}};
    EXPECT_TRUE(parse_scene(write_scene(scene, SceneFormat::toml), "s.toml") == scene);
}

TEST(PropertiesInToml, ReadAsPeopleWriteThem) {
    const std::string text = two +
                             "values = [1, 0.5]\n[[property]]\nname = 'chain'\nvalues = ['A', 'B']\n"
                             "[[property]]\nname = 'n'\ntype = 'int'\nvalues = '7 nan'\n";
    const SphereData data = read_toml(text, "s.toml", {});
    EXPECT_EQ(data.property_names, (std::vector<std::string>{"q", "chain", "n"}));
    ASSERT_EQ(data.scene.properties.size(), 3U);
    EXPECT_EQ(data.scene.properties[0], (Property{"q", std::vector<double>{1.0, 0.5}}));
    EXPECT_EQ(data.scene.properties[1], (Property{"chain", Labels{{"A", "B"}, {0, 1}}}));
    EXPECT_EQ(data.scene.properties[2], (Property{"n", std::vector<std::int32_t>{7, no_whole_number}}));
}

TEST(PropertiesInToml, SayWhatIsWrongAndWhere) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"values = [1]\n", "6:10: found 1 values, expected 2, one for each sphere"},
        {"values = '''\n1\n2 3'''\n", "8:3: found '3', expected the end of the text after 2 values"},
        {"values = '''\n1'''\n", "6:10: found 1 values, expected 2, one for each sphere"},
        {"values = '''\n1\n  1x'''\n", "8:3: found '1x', expected value 2 of 2, a number"},
        {"values = [1, inf]\n", "6:14: found inf, expected a finite number, or nan"},
        {"values = [1, 'a']\n", "6:14: found 'a', expected a finite number, or nan"},
        {"type = 'int'\nvalues = [1, 0.5]\n", "7:14: found 0.5, expected a whole number of 32 bits, or nan"},
        {"type = 'int'\nvalues = '1 3000000000'\n", "7:13: found '3000000000', expected a whole number of 32 bits, or nan"},
        {"type = 'word'\nvalues = [1, 1]\n", "6:8: found 'word', expected 'type' as \"double\", \"float\" or \"int\""},
        {"words = ['A']\nvalues = [0, 1]\n", "7:14: found 1, expected the number of one of 'words', from 0"},
        {"words = ['A', 'A']\nvalues = [0, 0]\n", "6:15: found 'A' again, expected each word once"},
        {"words = ['A']\ntype = 'int'\nvalues = [0, 0]\n", "7:8: found both 'type' and 'words', expected only one of them"},
        {"value = [0, 0]\n", "6:1: found the unknown key 'value' in [[property]] 1, expected one of name, type, words, values"},
        {"", "4:1: [[property]] 1 has no 'values', which it needs"},
        {"values = [0, 0]\n[[property]]\nname = 'q'\nvalues = [0, 0]\n", "8:8: found 'q' again, expected each name once"},
        {"values = ['A', 1]\n", "6:16: found 1, expected a string, as the values before it"},
    };
    for (const auto& [end, expected] : cases)
        EXPECT_TRUE(fault_of(two + end).starts_with("s.toml:" + expected)) << fault_of(two + end);
}

TEST(PropertiesInToml, AreLostInText) { EXPECT_EQ(lost_in(scene_with_values(2), SceneFormat::text), "the properties (5)"); }

}  // namespace sphereview
