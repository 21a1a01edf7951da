#include "panels/paths.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "panels/labels.hpp"

namespace sphereview {

TEST(Paths, AreTypedAbsoluteRelativeOrFromHome) {
    EXPECT_EQ(typed_path("/a/b", "/x"), "/a/b");
    EXPECT_EQ(typed_path("b/c", "/x"), "/x/b/c");
    EXPECT_EQ(typed_path("../c", "/x/y"), "/x/c");
    EXPECT_EQ(typed_path("  /a/b/ \n", "/x"), "/a/b");
    EXPECT_EQ(typed_path("/", "/x"), "/");
    EXPECT_EQ(typed_path("", "/x"), "/x");
    EXPECT_EQ(typed_path("..", "/"), "/");
    EXPECT_EQ(typed_path("~", "/x"), home_folder());
    EXPECT_EQ(typed_path("~/c", "/x"), home_folder() / "c");
    EXPECT_EQ(typed_path("~c", "/x"), "/x/~c") << "another user's home is not looked up";
}

TEST(Paths, KeepTheirBytes) {
    for (const std::string text : {"/a/Kugeln äöü.txt", "/球/四.toml", "/bad \xff utf"})
        EXPECT_EQ(text_from(path_from(text)), text);
}

TEST(Paths, HaveEndings) {
    EXPECT_TRUE(has_ending("a.txt", ".txt"));
    EXPECT_TRUE(has_ending("A.TXT", ".txt"));
    EXPECT_FALSE(has_ending("a.txt.png", ".txt"));
    EXPECT_FALSE(has_ending("txt", ".txt"));
}

TEST(Labels, AreFitForImGui) {
    EXPECT_EQ(as_label("a##b###c"), "a# #b# # #c");
    EXPECT_EQ(as_label("a\nb\tc\x7f"), "a b c ");
    EXPECT_EQ(as_label("ä"), "ä");
    EXPECT_EQ(on_one_line("##\r\n"), "##  ");
}

}  // namespace sphereview
