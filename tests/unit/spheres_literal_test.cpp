#include "formats/spheres_literal.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "formats/toml_format.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

TEST(SpheresLiteral, IsTakenOutAndLeavesItsLines) {
    struct Case {
        std::string content;
        std::string text;
        std::string rest;
    };
    const std::vector<Case> cases = {
        {"spheres = \"\"\"\n1\n2 3\n\"\"\"\n[camera]\n", "1\n2 3\n", "spheres = \"\"\"\n\n\n\"\"\"\n[camera]\n"},
        {"# c\r\nbackground = \"red\"\r\n spheres='''\r\n1\r\n2''' # x", "1\r\n2",
         "# c\r\nbackground = \"red\"\r\n spheres='''\n\n2''' # x"},
        {"spheres = \"\"\"1 2\"\"\"", "1 2", "spheres = \"\"\"1 2\"\"\""},
        {"spheres\t=\t\"\"\"\"\"\"", "", "spheres\t=\t\"\"\"\"\"\""},
    };
    for (const Case& found : cases) {
        SCOPED_TRACE(testing::PrintToString(found.content));
        const auto literal = find_spheres_literal(found.content);
        ASSERT_TRUE(literal.has_value());
        EXPECT_EQ(literal->text, found.text);
        EXPECT_EQ(literal->rest, found.rest);
    }
}

TEST(SpheresLiteral, IsLeftToTheParserWhereItIsNotPlain) {
    for (const char* content : {
             "",
             "spheres",
             "spheres = ",
             "spheres = \"0\"",
             "spheres = \"\"\"\n0\n",
             "spheres = \"\"\"\\u0030\"\"\"",
             "spheres = \"\"\"x\"\"\"",
             "spheres = \"\"\"0\r1\"\"\"",
             "spheres = \"\"\"0\"\"\"\"",
             "spheres = \"\"\"0\\\n\"\"\"",
             "\"spheres\" = \"\"\"0\"\"\"",
             "spheres.a = \"\"\"0\"\"\"",
             "[a]\nspheres = \"\"\"0\"\"\"",
             "a = \"\"\"\nspheres = '''0'''\n\"\"\"",
             "a = '''\nspheres = \"\"\"0\"\"\"\n'''",
         }) {
        EXPECT_FALSE(find_spheres_literal(content).has_value()) << content;
    }
}

TEST(SpheresLiteral, KeepsThePlacesOfMistakesAroundIt) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"spheres = \"\"\"\n1\n1 2 3 4 5 6 0\n\"\"\"\n", "s:3:13: found '0', expected the radius of sphere 1 of 1 above 0"},
        {"spheres = \"\"\"\n0\n1\"\"\"\n", "s:3:1: found '1', expected the end of the text after 0 spheres"},
        {"spheres = \"\"\"\r\n\r\n\r\n0\"\"\"\r\ncolour = 1\r\n", "s:5:1: found the unknown key 'colour'"},
        {"spheres = \"\"\"\n0\n\"\"\"\nspheres = \"\"\"0\"\"\"\n", "s:4:11: this is not TOML"},
        {"spheres = \"\"\"\n0\n  0 \"\"\" x\n", "s:3:9: this is not TOML"},
    };
    for (const auto& [content, message] : cases) {
        const std::string found = message_of<InputError>([&, &text = content] { parse_toml(text, "s"); });
        EXPECT_TRUE(found.starts_with(message)) << found;
    }
}

}  // namespace sphereview
