// Opening and saving scene files.
#include <gtest/gtest.h>

#include "support/text_match.hpp"
#include "ui/file_steps.hpp"

namespace sphereview::test {

TEST(Files, AreOpenedByTheBrowserTheRecentOnesAndADrop) {
    const TemporaryFolder folder;
    const std::string first = folder.write("first.txt", one_sphere);
    const std::string spaced = folder.write("with spaces/\xC3\xBC\xE2\x82\xAC scene.txt", two_spheres);
    const std::string broken = folder.write("broken.txt", "1\n255 0 0\n0 0 three\n60\n");
    ViewerWindow window(folder, {first});
    EXPECT_EQ(window.frame().at("title"), "first.txt - sphereview");
    ASSERT_TRUE(window.drop({spaced}));
    window.wait_for("path", spaced);
    EXPECT_EQ(window.frame().at("spheres"), 2);
    EXPECT_EQ(window.frame().at("title"), "\xC3\xBC\xE2\x82\xAC scene.txt - sphereview");

    window.key("ctrl+o");
    choose_file(window, first);
    window.wait_for("path", first);
    EXPECT_EQ(window.frame().at("spheres"), 1);

    window.click_widget("menu File");
    window.click_widget("menu Open recent");
    window.click_widget("recent 1");
    window.wait_for("path", spaced);

    // What cannot be opened says why, and the scene stays.
    ASSERT_TRUE(window.drop({broken}));
    answer(window, "error", "OK");
    wait_for_no_dialogs(window);
    ASSERT_TRUE(window.drop({folder.path("missing.txt")}));
    answer(window, "error", "OK");
    wait_for_no_dialogs(window);
    EXPECT_EQ(window.frame().at("path"), spaced);
    EXPECT_EQ(window.frame().at("spheres"), 2);
}

TEST(Files, OthersAreOpenedOnlyWhenNothingIsLost) {
    const TemporaryFolder folder;
    const std::string first = folder.write("first.txt", one_sphere);
    const std::string second = folder.write("second.txt", two_spheres);
    ViewerWindow window(folder, {first});
    edit(window);
    EXPECT_EQ(window.frame().at("title"), "first.txt * - sphereview");
    ASSERT_TRUE(window.drop({second}));
    answer(window, "save-changes", "Cancel");
    wait_for_no_dialogs(window);
    EXPECT_EQ(window.frame().at("path"), first);
    EXPECT_EQ(window.frame().at("changed"), true);

    window.choose("File", "New");
    answer(window, "save-changes", "Save");
    window.wait_for("path", "");
    EXPECT_EQ(window.frame().at("spheres"), 0);
    EXPECT_EQ(window.frame().at("title"), "untitled - sphereview");
    EXPECT_EQ(lines(folder.read("first.txt")).front(), "2");

    edit(window);
    ASSERT_TRUE(window.drop({second}));
    answer(window, "save-changes", "Don't save");
    window.wait_for("path", second);
    EXPECT_EQ(window.frame().at("changed"), false);
    EXPECT_EQ(folder.read("second.txt"), two_spheres);
}

TEST(Files, AreSavedUnderTheirNameAndAnother) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", one_sphere);
    folder.write("other.txt", "mine\n");
    ViewerWindow window(folder, {scene});
    edit(window);
    window.key("ctrl+s");
    announced(window, "Saved " + scene);
    EXPECT_EQ(window.frame().at("changed"), false);
    EXPECT_EQ(window.frame().at("title"), "scene.txt - sphereview");
    EXPECT_EQ(lines(folder.read("scene.txt")).front(), "2");

    // Another file is replaced only when the person agrees.
    window.key("ctrl+shift+s");
    choose_file(window, "other.txt");
    answer(window, "replace", "Cancel");
    window.wait_for("dialogs", Json::array({"browser"}));
    EXPECT_EQ(folder.read("other.txt"), "mine\n");
    window.click_widget("browser ok");
    answer(window, "replace", "Replace");
    window.wait_for("path", folder.path("other.txt"));
    EXPECT_EQ(folder.read("other.txt"), folder.read("scene.txt"));

    // A folder that is gone: nothing is lost, and it says so.
    window.key("ctrl+shift+s");
    choose_file(window, folder.write("gone/scene.toml", ""));
    answer(window, "replace", "Replace");
    window.wait_for("path", folder.path("gone/scene.toml"));
    edit(window);
    std::filesystem::remove_all(folder.path("gone"));
    window.key("ctrl+s");
    answer(window, "error", "OK");
    wait_for_no_dialogs(window);
    EXPECT_EQ(window.frame().at("changed"), true);
}

TEST(Files, ATextFileThatWouldLoseTheCameraAsks) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", one_sphere);
    ViewerWindow window(folder, {scene});
    window.drag(window.pixel(60, 60), window.pixel(160, 90));
    window.choose("View", "Use this view as the scene's camera");
    window.wait_for("changed", true);
    window.key("ctrl+s");
    answer(window, "text-loses", "Cancel");
    wait_for_no_dialogs(window);
    EXPECT_EQ(folder.read("scene.txt"), one_sphere);

    // A browser that is left without an answer does not make the text file another's format.
    window.key("ctrl+s");
    answer(window, "text-loses", "Save as TOML...");
    window.click_widget("browser cancel");
    wait_for_no_dialogs(window);
    window.key("ctrl+s");
    answer(window, "text-loses", "Save as TOML...");
    window.click_widget("browser ok");
    window.wait_for("path", folder.path("scene.toml"));
    EXPECT_EQ(window.frame().at("changed"), false);
    EXPECT_TRUE(contains(folder.read("scene.toml"), "camera"));
    EXPECT_EQ(folder.read("scene.txt"), one_sphere);

    window.key("ctrl+shift+s");
    choose_file(window, "flat.txt");
    answer(window, "text-loses", "Save all the same");
    window.wait_for("path", folder.path("flat.txt"));
    EXPECT_EQ(lines(folder.read("flat.txt")).size(), lines(folder.read("scene.txt")).size());
}

}  // namespace sphereview::test
