// Many spheres at once: boxes, commands that select, edits of all that are selected.
#include <gtest/gtest.h>

#include "ui/viewer_window.hpp"

namespace sphereview::test {

namespace {

// In a row from left to right, the fourth behind the third; two of them blue.
constexpr const char* five_spheres =
    "5\n255 0 0\n-100 0 300\n25\n0 0 255\n-40 0 300\n25\n0 255 0\n20 0 300\n25\n255 255 0\n40 0 600\n20\n"
    "0 0 255\n100 0 300\n25\n";

class Many : public testing::Test {
protected:
    Many() : scene_(folder_.write("scene.txt", five_spheres)), window_(folder_, {scene_}) {
        const Json& size = window_.frame().at("picture_size");
        middle_ = {size[0].get<double>() / 2, size[1].get<double>() / 2};
        unit_ = std::min(size[0].get<double>(), size[1].get<double>()) / 100.0;
    }

    // By the coordinates on the default screen: (0, 0) is the middle, 50 a half of the shorter side.
    Place on_screen(double x, double y) { return window_.pixel(middle_.x + unit_ * x, middle_.y - unit_ * y); }

    void box(const Place& from, const Place& to, const std::vector<std::string>& held) {
        for (const std::string& key : held) window_.key_down(key);
        window_.drag(from, to);
        for (const std::string& key : held) window_.key_up(key);
    }

    std::string saved() {
        window_.key("ctrl+s");
        window_.wait_for("changed", false);
        return folder_.read("scene.txt");
    }

    TemporaryFolder folder_;
    std::string scene_;
    ViewerWindow window_;
    Place middle_;
    double unit_ = 1.0;
};

}  // namespace

TEST_F(Many, ABoxSelectsWhatIsSeenInIt) {
    const Json camera = window_.frame().at("camera");
    box(on_screen(-20, 20), on_screen(12, -20), {"ctrl"});
    window_.wait_for("selection", {1, 2});  // not the yellow one behind
    box(on_screen(25, -20), on_screen(48, 20), {"ctrl", "shift"});
    window_.wait_for("selection", {1, 2, 4});
    box(on_screen(4, 5), on_screen(8, -5), {"ctrl", "shift"});
    window_.wait_for("selection", {1, 4});
    window_.key_down("ctrl");
    window_.click(on_screen(-33, 0));
    window_.key_up("ctrl");
    window_.wait_for("selection", {0, 1, 4});
    window_.key_down("ctrl");
    window_.click(on_screen(-33, 0));
    window_.key_up("ctrl");
    window_.wait_for("selection", {1, 4});
    EXPECT_EQ(window_.frame().at("camera"), camera);
    EXPECT_EQ(window_.frame().at("changed"), false);
    box(on_screen(-48, 45), on_screen(48, 40), {"ctrl"});
    window_.wait_for("selection", Json::array());
}

TEST_F(Many, CommandsSelectAllNoneInverseAndByColour) {
    window_.key("ctrl+a");
    window_.wait_for("selection", {0, 1, 2, 3, 4});
    window_.key("ctrl+i");
    window_.wait_for("selection", Json::array());
    window_.click(on_screen(-13, 0));
    window_.wait_for("selection", {1});
    window_.key("ctrl+l");
    window_.wait_for("selection", {1, 4});
    window_.key("ctrl+i");
    window_.wait_for("selection", {0, 2, 3});
    window_.key("h");
    window_.wait_for("undo", "Hide 3 spheres");
    window_.key("Escape");
    window_.wait_for("selection", Json::array());
    window_.key("ctrl+h");
    window_.wait_for("selection", {0, 2, 3});
}

TEST_F(Many, WhatIsSelectedMovesTogetherAndOneUndoBringsTheBytesBack) {
    const std::string before = folder_.read("scene.txt");  // written as the program writes
    window_.key("ctrl+a");
    window_.wait_for("selected", 5);
    const Place from = on_screen(-33, 0);
    window_.drag(from, {from.x + 40, from.y - 25});
    window_.wait_for("undo", "Move 5 spheres");
    const std::string moved = saved();
    EXPECT_NE(moved, before);
    window_.drag(window_.widget("slider radius", 0.5), window_.widget("slider radius", 0.6));
    window_.wait_for("undo", "Change radius of 5 spheres");
    window_.drag(window_.widget("slider y", 0.5), window_.widget("slider y", 0.6));
    window_.wait_for("undo", "Move 5 spheres");
    window_.key("Delete");
    window_.wait_for("spheres", 0);
    for (int i = 0; i < 3; ++i) window_.key("ctrl+z");
    window_.wait_until("the first move alone",
                       [](const Json& frame) { return frame.at("undo") == "Move 5 spheres" && frame.at("changed") == false; });
    window_.key("ctrl+z");
    window_.wait_for("undo", "");
    EXPECT_EQ(saved(), before);
}

// A wall of spheres that fills the picture.
TEST(HundredThousand, MoveTogetherAndOneUndoBringsTheBytesBack) {
    constexpr int side = 400;
    constexpr int rows = 250;
    std::string text = std::to_string(side * rows) + "\n";
    for (int i = 0; i < side * rows; ++i) {
        const std::string center = std::to_string(i % side - side / 2) + " " + std::to_string(i / side - rows / 2);
        text += "200 " + std::to_string(i % 256) + " 0\n" + center + " 300\n0.4\n";
    }
    const TemporaryFolder folder;
    const std::string scene = folder.write("wall.txt", text);
    ViewerWindow window(folder, {scene});
    window.key("ctrl+a");
    window.wait_for("selected", side * rows);
    const Json& size = window.frame().at("picture_size");
    const Place from = window.pixel(size[0].get<double>() / 2, size[1].get<double>() / 2);
    window.drag(from, {from.x + 30, from.y + 20});
    window.wait_for("undo", "Move 100,000 spheres");
    window.key("ctrl+z");
    window.wait_for("undo", "");
    EXPECT_EQ(window.frame().at("changed"), false);
    window.key("ctrl+i");
    window.wait_for("selected", 0);
    window.key("ctrl+shift+s");
    window.wait_for("dialogs", {"browser"});
    window.click_widget("browser name");
    window.key("ctrl+a");
    window.type("back.txt");
    window.click_widget("browser ok");
    window.wait_for("path", folder.path("back.txt"));
    EXPECT_EQ(folder.read("back.txt"), text);
}

}  // namespace sphereview::test
