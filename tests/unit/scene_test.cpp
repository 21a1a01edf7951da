#include "scene/scene.hpp"

#include <gtest/gtest.h>

namespace sphereview {

TEST(Background, ReadsWhatItsSyntaxSays) {
    const std::vector<std::pair<const char*, Background>> cases = {
        {"black", {{0, 0, 0}, false}},       {"white", {{255, 255, 255}, false}},      {"transparent", {{0, 0, 0}, true}},
        {"#0080ff", {{0, 128, 255}, false}}, {"#ABCDEF", {{0xAB, 0xCD, 0xEF}, false}},
    };
    for (const auto& [text, expected] : cases) {
        Background background{{1, 2, 3}, true};
        EXPECT_TRUE(parse_background(text, background)) << text;
        EXPECT_EQ(background, expected) << text;
    }
}

TEST(Background, LeavesTheValueAloneWhenTheTextIsWrong) {
    for (const char* text : {"", "Black", "grey", "#fff", "#12345", "#1234567", "#12345g", "#-12345", "#+12345", "# 12345",
                             "#12 456", "123456", "#1-2-3-", "white "}) {
        Background background{{1, 2, 3}, true};
        EXPECT_FALSE(parse_background(text, background)) << text;
        EXPECT_EQ(background, (Background{{1, 2, 3}, true})) << text;
    }
}

TEST(Background, IsWrittenInItsShortestSpelling) {
    EXPECT_EQ(to_string(Background{}), "black");
    EXPECT_EQ(to_string(Background{{255, 255, 255}, false}), "white");
    EXPECT_EQ(to_string(Background{{0, 0, 0}, true}), "transparent");
    EXPECT_EQ(to_string(Background{{1, 0, 255}, false}), "#0100ff");
}

}  // namespace sphereview
