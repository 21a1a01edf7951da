// A scene file that another program changes while it is shown.
#include <gtest/gtest.h>

#include "support/text_match.hpp"
#include "ui/file_steps.hpp"

namespace sphereview::test {

namespace {

class Reloading : public testing::Test {
protected:
    Reloading() : scene_(folder_.write("scene.txt", two_spheres)), window_(folder_, {scene_}) {}

    TemporaryFolder folder_;
    std::string scene_;
    ViewerWindow window_;
};

}  // namespace

TEST_F(Reloading, ShowsAFileThatWasReplacedAndKeepsTheViewAndSelection) {
    window_.key("ctrl+a");
    window_.wait_for("selection", {0, 1});
    const Json home = window_.frame().at("camera");
    window_.drag(window_.pixel(60, 60), window_.pixel(160, 90));
    const Json view = window_.wait_until("another view", [&](const Json& f) { return f.at("camera") != home; }).at("camera");
    replace_by_rename(folder_, "scene.txt", std::string("3") + (two_spheres + 1) + "0 0 255\n-100 0 300\n30\n");
    window_.wait_for("spheres", 3);
    EXPECT_EQ(window_.frame().at("camera"), view);
    EXPECT_EQ(window_.frame().at("selection"), Json({0, 1}));
    EXPECT_EQ(window_.frame().at("changed"), false);
    folder_.write("scene.txt", one_sphere);  // in place
    window_.wait_for("spheres", 1);
    EXPECT_EQ(window_.frame().at("camera"), view);
    EXPECT_EQ(window_.frame().at("selection"), Json({0}));
    // A reload is a step like any other; what was there before it is not what the file holds.
    window_.key("ctrl+z");
    window_.wait_for("spheres", 3);
    EXPECT_EQ(window_.frame().at("changed"), true);
    window_.key("ctrl+y");
    window_.wait_for("spheres", 1);
    EXPECT_EQ(window_.frame().at("changed"), false);
}

TEST_F(Reloading, KeepsTheLastGoodSceneWhileTheFileIsBroken) {
    const auto says = [](const std::string& part) {
        return [part](const Json& f) {
            return contains(f.at("scene_error").get<std::string>(), part) && f.at("widgets").contains("message scene error");
        };
    };
    folder_.write("scene.txt", "1\n255 0 0\n0 0 three\n60\n");
    window_.wait_until("an error", says("scene.txt:3:5: "));
    EXPECT_EQ(window_.frame().at("spheres"), 2);
    // However long the word is that cannot be read, the message has its end in the window.
    replace_by_rename(folder_, "scene.txt", "1\n255 0 " + std::string(100'000, 'x'));
    window_.wait_until("another error", says("scene.txt:2:7: "));
    const Json box = window_.frame().at("widgets").at("message scene error");
    EXPECT_LT(box[3].get<double>(), window_.frame().at("picture")[3].get<double>());
    replace_by_rename(folder_, "scene.txt", one_sphere);
    window_.wait_for("spheres", 1);
    EXPECT_EQ(window_.frame().at("scene_error"), "");
    EXPECT_FALSE(window_.frame().at("widgets").contains("message scene error"));
}

TEST_F(Reloading, AsksWhenThereAreChangesHere) {
    edit(window_);
    replace_by_rename(folder_, "scene.txt", one_sphere);
    answer(window_, "reload", "Keep mine");
    wait_for_no_dialogs(window_);
    EXPECT_EQ(window_.frame().at("spheres"), 3);
    EXPECT_EQ(window_.frame().at("changed"), true);
    // Broken and then good again: the complaint goes although the changes stay.
    folder_.write("scene.txt", "1\n");
    window_.wait_until("an error", [](const Json& f) { return f.at("scene_error") != ""; });
    folder_.write("scene.txt", one_sphere);
    window_.wait_for("dialogs", Json::array({"reload"}));
    EXPECT_EQ(window_.frame().at("scene_error"), "");
    // Changed once more before the answer: asked once, of what the file holds now.
    replace_by_rename(folder_, "scene.txt", "0\n");
    const int frame = window_.frame().at("frame");
    window_.wait_until("another frame", [&](const Json& f) { return f.at("frame") > frame; });
    answer(window_, "reload", "Reload the file");
    window_.wait_for("spheres", 0);
    wait_for_no_dialogs(window_);
    EXPECT_EQ(window_.frame().at("changed"), false);
    window_.key("ctrl+z");
    window_.wait_for("spheres", 3);
}

TEST_F(Reloading, DoesNotTakeItsOwnSaveForAChange) {
    edit(window_);
    window_.key("ctrl+s");
    announced(window_, "Saved ");
    edit(window_);
    // The next change from outside comes after whatever the save could have caused.
    folder_.write("scene.txt", "broken");
    window_.wait_until("an error", [](const Json& f) { return f.at("scene_error") != ""; });
    EXPECT_EQ(window_.frame().at("dialogs"), Json::array());
    EXPECT_EQ(window_.frame().at("spheres"), 4);
    EXPECT_EQ(window_.frame().at("undo"), "Add sphere 3");
}

}  // namespace sphereview::test
