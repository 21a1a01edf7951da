// The loop that a person lives in: slider, picture, undo, export, and a file that another program edits.
#include <gtest/gtest.h>

#include <fstream>

#include "support/text_match.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

class Live : public Editing {
protected:
    Live() { take_marks_away(); }
};

}  // namespace

TEST_F(Live, ASliderThatIsDraggedChangesThePictureAsOneStep) {
    const Picture before = window_.picture();
    for (const char* slider : {"slider x", "slider z", "slider radius"}) {
        SCOPED_TRACE(slider);
        select(0);
        const Place from = window_.widget(slider);
        window_.drag(from, {from.x - 25, from.y});
        window_.wait_until("a step", [](const Json& frame) { return frame.at("undo") != ""; });
        take_marks_away();
        EXPECT_FALSE(same_picture(window_.picture(), before));
        window_.key("ctrl+z");
        window_.wait_for("undo", "");
        take_marks_away();
        EXPECT_TRUE(same_picture(window_.picture(), before));
        window_.key("ctrl+shift+z");
        window_.wait_for("redo", "");
        expect_rendered();
        window_.key("ctrl+z");
        window_.wait_for("undo", "");
    }
    window_.key("ctrl+s");
    window_.wait_for("changed", false);
    EXPECT_EQ(folder_.read("scene.txt"), two_spheres);
}

TEST_F(Live, AClickSelectsWhatIsSeen) {
    select_red();
    window_.click({window_.pixel(20, 20)});
    window_.wait_for("selection", Json::array());
}

TEST_F(Live, ASphereThatIsDraggedIsDrawnWhereItWasDropped) {
    select_red();
    const Place from = red();
    window_.drag(from, {from.x - 150, from.y + 90});
    window_.wait_for("undo", "Move sphere 0");
    EXPECT_EQ(window_.frame().at("changed"), true);
    EXPECT_TRUE(contains(window_.frame().at("title").get<std::string>(), "*"));
    expect_rendered();
    window_.key("ctrl+z");
    window_.wait_for("undo", "");
    expect_rendered();
    EXPECT_EQ(folder_.read("scene.txt"), two_spheres);
}

TEST_F(Live, TypedValuesAndColoursAreInThePicture) {
    select(1);
    window_.key_down("ctrl");
    window_.click_widget("slider x");
    window_.key_up("ctrl");
    window_.widget("slider x");
    window_.key("ctrl+a");
    window_.type("-40.125");
    window_.key("Return");
    window_.wait_until("a step", [](const Json& frame) { return frame.at("undo") != ""; });
    expect_rendered();
    EXPECT_TRUE(contains(folder_.read("scene.txt"), "-40.125 0 300"));
}

TEST_F(Live, F12WritesTheVeryBytesOfRender) {
    const Place middle = window_.pixel(300, 300);
    window_.drag(middle, {middle.x + 120, middle.y + 60});  // orbits
    window_.wait_until("another view", [](const Json& frame) { return frame.at("camera")[0][0] != 0.0; });
    window_.key("F12");
    window_.wait_until("an export", [](const Json& frame) { return frame.at("announcement") != ""; });
    window_.key("ctrl+Home");  // the view becomes the scene's camera
    window_.wait_until("a step", [](const Json& frame) { return frame.at("undo") != ""; });
    window_.key("F12");
    window_.wait_until("a second export",
                       [](const Json& frame) { return contains(frame.at("announcement").get<std::string>(), "scene-1.png"); });
    EXPECT_EQ(folder_.read("scene.png"), folder_.read("scene-1.png"));

    window_.key("ctrl+shift+s");
    choose_file(window_, "seen.toml");
    window_.wait_for("path", folder_.path("seen.toml"));
    for (const char* backend : {"cpu", "egl"}) {
        Command render;
        render.arguments = {"render", folder_.path("seen.toml"), "--backend", backend, "-o", folder_.path("rendered.png")};
        ASSERT_EQ(run(render).status, 0);
        EXPECT_EQ(folder_.read("rendered.png"), folder_.read("scene.png")) << backend;
    }
    const Json& frame = take_marks_away();
    EXPECT_TRUE(same_picture(window_.picture(), rendered(folder_, folder_.path("seen.toml"), frame)));
}

TEST_F(Live, AFileThatAnotherProgramWritesAppearsAndABrokenOneDoesNotTakeTheWindowDown) {
    const Json camera = window_.frame().at("camera");
    replace_by_rename(folder_, "scene.txt", "1\n0 0 255\n0 0 300\n50\n");
    window_.wait_for("spheres", 1);
    EXPECT_TRUE(same_picture(window_.picture(), rendered(folder_, scene_, take_marks_away())));

    std::ofstream(scene_) << "1\n0 0 255\n0 0 300\n-50\n";  // in place, and broken
    window_.wait_until("an error", [](const Json& frame) { return frame.at("scene_error") != ""; });
    EXPECT_TRUE(contains(window_.frame().at("scene_error").get<std::string>(), scene_ + ":4:1: found '-50', expected"));
    EXPECT_TRUE(window_.frame().at("widgets").contains("message scene error"));
    EXPECT_EQ(window_.frame().at("spheres"), 1);
    EXPECT_EQ(window_.frame().at("changed"), false);

    std::ofstream(scene_) << two_spheres;
    window_.wait_for("spheres", 2);
    EXPECT_EQ(window_.frame().at("scene_error"), "");
    EXPECT_EQ(window_.frame().at("camera"), camera);
    EXPECT_TRUE(same_picture(window_.picture(), rendered(folder_, scene_, take_marks_away())));
    window_.key("ctrl+z");  // a reload is a step like any other
    window_.wait_for("spheres", 1);
}

}  // namespace sphereview::test
