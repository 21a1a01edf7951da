// Sliders, the mouse in the picture, undo: every change is in the window's picture, which is what `render` makes of it.
#include <gtest/gtest.h>

#include "support/text_match.hpp"
#include "ui/viewer_window.hpp"

namespace sphereview::test {

namespace {

// A large red sphere straight ahead, a green one to the right of it.
constexpr const char* two_spheres = "2\n255 0 0\n0 0 300\n60\n0 255 0\n100 0 300\n30\n";

class Editing : public testing::Test {
protected:
    Editing() : scene_(folder_.write("scene.txt", two_spheres)), window_(folder_, {scene_}) {
        window_.key("m");  // the frame of the export is drawn over the picture
    }

    // Where the window shows the middle of the picture, and so of the red sphere.
    Place red() {
        const Json& size = window_.frame().at("picture_size");
        return window_.pixel(size[0].get<int>() / 2, size[1].get<int>() / 2);
    }

    // Saves the scene under a name and expects that the window shows it as `render` does.
    void expect_rendered(const std::string& name) {
        const std::string path = folder_.path(name);
        window_.key("ctrl+shift+s");
        window_.wait_for("dialogs", {"browser"});
        window_.click_widget("browser name");
        window_.key("ctrl+a");
        window_.type(name);
        window_.click_widget("browser ok");
        window_.wait_for("path", path);
        // Nothing marked: an outline is the window's alone.
        window_.key("ctrl+shift+a");
        window_.key("Escape");
        window_.move_to({5, 5});
        const Json& frame = window_.wait_until("no marks", [](const Json& f) {
            return f.at("selection").empty() && f.at("hovered").is_null() && f.at("announcement") == "";
        });
        EXPECT_TRUE(same_picture(window_.picture(), rendered(folder_, path, frame))) << name;
    }

    TemporaryFolder folder_;
    std::string scene_;
    ViewerWindow window_;
};

}  // namespace

TEST_F(Editing, AClickSelectsWhatIsSeen) {
    window_.click(red());
    window_.wait_for("selection", {0});
    window_.click({window_.pixel(20, 20)});
    window_.wait_for("selection", Json::array());
}

TEST_F(Editing, ASphereThatIsDraggedIsDrawnWhereItWasDropped) {
    window_.click(red());
    window_.wait_for("selection", {0});
    const Place from = red();
    window_.drag(from, {from.x - 150, from.y + 90});
    window_.wait_for("undo", "Move sphere 0");
    EXPECT_EQ(window_.frame().at("changed"), true);
    EXPECT_TRUE(contains(window_.frame().at("title").get<std::string>(), "*"));
    expect_rendered("moved.txt");
    window_.key("ctrl+z");
    window_.wait_for("undo", "");
    expect_rendered("back.txt");
    EXPECT_EQ(folder_.read("back.txt"), folder_.read("scene.txt"));
}

}  // namespace sphereview::test
