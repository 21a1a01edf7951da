// CSV files as other programs write them, and wrong ones with the whole message that each gets.
#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"
#include "formats/sphere_data.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

Scene scene_of(const std::string& text, const DataOptions& options = {}) { return read_csv(text, "a.csv", options).scene; }

struct Case {
    std::string text;
    const char* message;  // behind "a.csv:"
};

void expect_messages(const std::vector<Case>& cases) {
    for (const Case& wrong : cases) {
        SCOPED_TRACE(testing::PrintToString(wrong.text));
        EXPECT_EQ(message_of<InputError>([&] { scene_of(wrong.text); }), "a.csv:" + std::string(wrong.message));
    }
}

}  // namespace

TEST(Csv, FindsItsColumnsInTheHeader) {
    const std::vector<Sphere> two = {{{1, 2.5, -3}, 0.5, {255, 0, 7}, false}, {{4e10, 0, 0.25}, 2, {1, 2, 3}, false}};
    const std::map<std::uint32_t, std::string> names = {{0, "sun"}, {1, "the \"moon\", far"}};
    for (const char* text : {
             "x,y,z,radius,r,g,b,name\n1,2.5,-3,0.5,255,0,7,sun\n4e10,0,0.25,2,1,2,3,\"the \"\"moon\"\", far\"\n",
             // pandas: an index, other columns, no line end at the end
             ",name,id,z,y,x,B,G,R,Radius\n0,sun,a,-3,2.5,1,7,0,255,0.5\n1,\"the \"\"moon\"\", far\",b,0.25,0,4e10,3,2,1,2",
             // a spreadsheet: quotes around everything, CR LF, a byte-order mark
             "\xEF\xBB\xBF\"x\",\"y\",\"z\",\"radius\",\"r\",\"g\",\"b\",\"name\"\r\n\"1\",\"2.5\",\"-3\",\"0.5\",\"255\",\"0\","
             "\"7\",\"sun\"\r\n\r\n"
             "\"4e10\",\"0\",\"0.25\",\"2\",\"1\",\"2\",\"3\",\"the \"\"moon\"\", far\"\r\n",
             // another separator, blanks, CR
             "\rx ; y ; z ; radius ; r ; g ; b ; name\r\r+1 ; 2.5 ; -3 ; .5 ; 255 ; 0 ; 7 ; sun\r 4e10 ; 0 ; .25 ; 2 ; 1 ; 2 ; 3 ; "
             "\"the \"\"moon\"\", "
             "far\" \r \r",
             "\"x\"\t\"y\"\t\"z\"\t\"radius\"\t\"r\"\t\"g\"\t\"b\"\tname\n1\t2.5\t-3\t0.5\t255\t0\t7\tsun\n4e10\t0\t0."
             "25\t2\t1\t2\t3\tthe \"moon\", far\n",
             // numpy.savetxt; a separator at the ends of lines
             "# x,y,z,radius,r,g,b,name,\n1,2.5,-3,0.5,255,0,7,sun,\n4e10,0,0.25,2,1,2,3,\"the \"\"moon\"\", far\",\n",
         }) {
        const Scene scene = scene_of(text);
        EXPECT_EQ(scene.spheres, two) << text;
        EXPECT_EQ(scene.names, names) << text;
        EXPECT_EQ(scene.camera, Camera{});
    }
}

TEST(Csv, KnowsWhatToDoWithoutTheOptionalColumns) {
    EXPECT_EQ(scene_of("x,y,z\n1,2,3\n").spheres, (std::vector<Sphere>{{{1, 2, 3}, 1, {255, 255, 255}, false}}));
    EXPECT_EQ(scene_of("x,y,z\n1,2,3\n", {0, 4.5}).spheres[0].radius, 4.5);
    EXPECT_EQ(scene_of("x,y,z\r\n"), Scene{});
    EXPECT_EQ(scene_of("z,x,y"), Scene{});
    const Scene scene = scene_of("x,y,z,radius,r,g,b,name\n1,2,3,,,,,\n1,2,3,0.25,1,2,3,a\n", {0, 7.0});
    EXPECT_EQ(scene.spheres, (std::vector<Sphere>{{{1, 2, 3}, 7, {255, 255, 255}, false}, {{1, 2, 3}, 0.25, {1, 2, 3}, false}}));
    EXPECT_EQ(scene.names, (std::map<std::uint32_t, std::string>{{1, "a"}}));
}

TEST(Csv, ReadsFieldsOfSeveralLinesAndOfAnyEncoding) {
    const Scene scene =
        scene_of("name,x,y,z\n\"two\nlines\",1,2,3\n\"\",4,5,6\n\"\r\n\"\"\n\",7,8,9\nM\xFCller,1,2,3\nRen\xC3\xA9,1,2,3\n");
    ASSERT_EQ(scene.spheres.size(), 5U);
    EXPECT_EQ(scene.spheres[2].center, glm::dvec3(7, 8, 9));
    EXPECT_EQ(scene.names, (std::map<std::uint32_t, std::string>{
                               {0, "two\nlines"}, {2, "\r\n\"\n"}, {3, "M\xEF\xBF\xBDller"}, {4, "Ren\xC3\xA9"}}));
}

// More than one core's piece, and the same in one piece, which quotes make of it.
TEST(Csv, ReadsManyRowsInOrder) {
    constexpr int count = 50'000;
    for (const char* quote : {"", "\""}) {
        std::string text = "x,y,z,name\n";
        for (int i = 0; i < count; ++i) {
            text += std::to_string(i) + std::string(static_cast<std::size_t>(i % 5), ' ') + ",1,2," + quote + "n" +
                    std::to_string(i) + quote + "\n";
            if (i % 1000 == 0) text += "\n";
        }
        const Scene scene = scene_of(text);
        ASSERT_EQ(scene.spheres.size(), static_cast<std::size_t>(count));
        ASSERT_EQ(scene.names.size(), static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) {
            ASSERT_EQ(scene.spheres[static_cast<std::size_t>(i)].center, glm::dvec3(i, 1, 2));
            ASSERT_EQ(scene.names.at(static_cast<std::uint32_t>(i)), "n" + std::to_string(i));
        }
        text.replace(text.find("\n40000,") + 1, 5, "4000x");
        text.replace(text.find("\n30000,") + 1, 5, "3000x");
        EXPECT_EQ(message_of<InputError>([&] { scene_of(text); }), "a.csv:30032:1: found '3000x', expected x, a number");
    }
}

TEST(CsvErrors, SayWhatIsWrongWithTheHeader) {
    const std::string syntax = ", expected a header with x, y, z, and perhaps radius, r, g, b, name";
    expect_messages({
        {"", ("1:1: the text is empty" + syntax).c_str()},
        {"\xEF\xBB\xBF \r\n\n", ("1:1: the text is empty" + syntax).c_str()},
        {"1,2,3\n", ("1:1: found '1'" + syntax).c_str()},
        {"\n\n a,y,z\n", ("3:2: found 'a'" + syntax).c_str()},
        {"x y z\n1 2 3\n", ("1:1: found 'x y z'" + syntax).c_str()},
        {"x,y\n1,2\n", ("1:1: found 'x'" + syntax).c_str()},
        {"x,y,z,X\n", "1:7: found 'X', expected each of x, y, z, radius, r, g, b and name only once"},
        {"x,y,z,g\n", "1:7: found 'g', expected all three of r, g and b, or none"},
        {"r,b,x,y,z\n", "1:1: found 'r', expected all three of r, g and b, or none"},
        {"\"x,y,z\n", "1:1: found a quote that nothing closes, expected another one behind it"},
    });
}

TEST(CsvErrors, SayWhatIsWrongWithARow) {
    expect_messages({
        {"x,y,z\n1,2\n", "2:4: the line ends, expected z"},
        {"x,y,z\r\n1,2\r\n", "2:4: the line ends, expected z"},
        {"x,y,z\n1\n", "2:2: the line ends, expected y"},
        {"x,y,z,name\n1,2,3", "2:6: the line ends, expected name"},
        {"x,y,z\n1,2,3,4\n", "2:7: found '4', expected the end of the line after 3 fields, as the header has them"},
        {"x,y,z\n1,2,3,,\n", "2:7: found '', expected the end of the line after 3 fields, as the header has them"},
        {"x,y,z\n1,,3\n", "2:3: found '', expected y, a number"},
        {"x;y;z\n1,5;2;3\n", "2:1: found '1,5', expected x, a number"},
        {"x,y,z\n1,2,3\n 1, 2 , three \n", "3:9: found 'three', expected z, a number"},
        {"x,y,z\n1,inf,3\n", "2:3: found 'inf', expected y, a finite number"},
        {"x,y,z\n-1e400,2,3\n", "2:1: found '-1e400', expected x, a number that a double can hold (at most 1.8e308)"},
        {"x,y,z,radius\n1,2,3,0\n", "2:7: found '0', expected radius above 0"},
        {"x,y,z,radius\n1,2,3,-1\n", "2:7: found '-1', expected radius above 0"},
        {"x,y,z,radius\n1,2,3,big\n", "2:7: found 'big', expected radius, a number"},
        {"x,y,z,r,g,b\n1,2,3,256,0,0\n", "2:7: found '256', expected r, a whole number from 0 to 255"},
        {"x,y,z,r,g,b\n1,2,3,0,-1,0\n", "2:9: found '-1', expected g, a whole number from 0 to 255"},
        {"x,y,z,r,g,b\n1,2,3,0,0,0.5\n", "2:11: found '0.5', expected b, a whole number from 0 to 255"},
        {"x,y,z,r,g,b\n1,2,3,0,,0\n", "2:9: found '', expected g, a whole number from 0 to 255"},
        {"x,y,z,name\n1,2,3,\"a\nb\" c\n", "3:4: found 'c' behind a closing quote, expected ',' or the end of the line"},
        {"x,y,z,name\n1,2,3,\"a\"\"\n1,2,3,b\n", "2:7: found a quote that nothing closes, expected another one behind it"},
        {"x,y,z,name\n1,2,3,\"a\nb\"\n1,2\n", "4:4: the line ends, expected z"},
    });
}

}  // namespace sphereview
