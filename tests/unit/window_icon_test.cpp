// The window's icon is the installed one.
#include "viewer/window_icon.hpp"

#include <gtest/gtest.h>

#include "app/load_scene.hpp"
#include "support/folders.hpp"

namespace sphereview {

TEST(WindowIcon, IsThatOfThePackages) {
    Scene installed = load_scene(test::source_file("packaging/icon.toml")).scene;
    installed.names.clear();
    EXPECT_EQ(icon_scene(), installed);
    for (const Image& icon : window_icons()) {
        const int side = icon.width();
        EXPECT_EQ(icon.height(), side);
        EXPECT_EQ(icon.channels(), 4);
        EXPECT_EQ(icon.at(side - 1, side - 1)[3], 0) << "transparent around";
        const std::uint8_t* blue = icon.at(side * 6 / 10, side / 2);
        EXPECT_EQ(blue[3], 255);
        EXPECT_GT(blue[2], blue[0]);
    }
}

}  // namespace sphereview
