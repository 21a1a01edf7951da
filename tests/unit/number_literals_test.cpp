// The numbers of a scene in the native format, which are taken out before the rest is parsed.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/sphere_data.hpp"

namespace sphereview {

TEST(NumberLiterals, IsTakenOutAndLeavesItsLines) {
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
        const auto literal = find_number_literals(found.content);
        ASSERT_TRUE(literal.has_value());
        EXPECT_EQ(literal->literals.at(0).text, found.text);
        EXPECT_EQ(literal->rest, found.rest);
    }
}

TEST(NumberLiterals, IsLeftToTheParserWhereItIsNotPlain) {
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
        EXPECT_FALSE(find_number_literals(content).has_value()) << content;
    }
}

}  // namespace sphereview
