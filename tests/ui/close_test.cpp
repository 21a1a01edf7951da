// Closing the window: nothing is lost that the person did not give up.
#include <gtest/gtest.h>

#include "support/text_match.hpp"
#include "ui/file_steps.hpp"

namespace sphereview::test {

TEST(Closing, AsksAboutChangesAndMayBeCancelled) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", one_sphere);
    ViewerWindow window(folder, {scene});
    edit(window);
    window.press_close_button();
    answer(window, "save-changes", "Cancel");
    wait_for_no_dialogs(window);
    // Asked once, however often.
    window.press_close_button();
    window.wait_for("dialogs", Json::array({"save-changes"}));
    const int asked = window.frame().at("frame");
    window.press_close_button();
    window.wait_until("another frame", [&](const Json& frame) { return frame.at("frame") > asked; });
    EXPECT_EQ(window.frame().at("dialogs"), Json::array({"save-changes"}));
    window.key("Escape");
    wait_for_no_dialogs(window);
    window.key("ctrl+q");
    answer(window, "save-changes", "Don't save");
    EXPECT_EQ(window.wait_for_end().status, 0);
    EXPECT_EQ(folder.read("scene.txt"), one_sphere);
}

TEST(Closing, SavesAFile) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", one_sphere);
    ViewerWindow window(folder, {scene});
    edit(window);
    window.press_close_button();
    answer(window, "save-changes", "Save");
    EXPECT_EQ(window.wait_for_end().status, 0);
    EXPECT_EQ(lines(folder.read("scene.txt")).front(), "2");
}

TEST(Closing, SavesAnUntitledSceneUnderANameFirst) {
    const TemporaryFolder folder;
    ViewerWindow window(folder, {});
    edit(window);
    window.key("ctrl+q");
    answer(window, "save-changes", "Save");
    window.click_widget("browser cancel");
    wait_for_no_dialogs(window);
    EXPECT_EQ(window.frame().at("changed"), true);
    window.key("ctrl+q");
    answer(window, "save-changes", "Save");
    choose_file(window, folder.path("new.toml"));
    EXPECT_EQ(window.wait_for_end().status, 0);
    EXPECT_TRUE(contains(folder.read("new.toml"), "sphere"));
}

}  // namespace sphereview::test
