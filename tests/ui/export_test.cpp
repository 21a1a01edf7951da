// Pictures written from the window: the very bytes of `render`.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/text_match.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

// What `render` writes of a scene file.
std::string render_bytes(const TemporaryFolder& folder, const std::string& scene, const std::string& size) {
    const Outcome outcome = run({"render", scene, "-s", size, "-o", folder.path("expected.png")});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return folder.read("expected.png");
}

}  // namespace

TEST(Exporting, WritesTheBytesOfRenderAndReplacesNothing) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", two_spheres);
    folder.write("scene.png", "mine");
    ViewerWindow window(folder, {scene});
    window.drag(window.pixel(60, 60), window.pixel(160, 90));
    window.key("F12");
    EXPECT_TRUE(contains(announced(window, "Exported"), folder.path("scene-1.png") + " (1000 x 1000)"));
    EXPECT_EQ(folder.read("scene.png"), "mine");
    // Again, with everything marked, under the next name.
    window.key("ctrl+a");
    window.wait_for("selection", {0, 1});
    window.key("F12");
    announced(window, folder.path("scene-2.png"));
    EXPECT_EQ(folder.read("scene-2.png"), folder.read("scene-1.png"));

    window.choose("View", "Use this view as the scene's camera");
    window.wait_for("changed", true);
    window.key("ctrl+shift+s");
    choose_file(window, "viewed.toml");
    window.wait_for("path", folder.path("viewed.toml"));
    EXPECT_EQ(folder.read("scene-1.png"), render_bytes(folder, folder.path("viewed.toml"), "1000x1000"));
    EXPECT_NE(folder.read("scene-1.png"), render_bytes(folder, scene, "1000x1000"));

    // By name and size; a name that is taken asks.
    window.key("ctrl+e");
    window.wait_for("dialogs", Json::array({"export"}));
    window.click_widget("export path");
    window.key("ctrl+a");
    window.type("scene.png");
    window.click_widget("export 1920 x 1080");
    window.click_widget("export ok");
    answer(window, "replace", "Cancel");
    window.wait_for("dialogs", Json::array({"export"}));
    EXPECT_EQ(folder.read("scene.png"), "mine");
    window.click_widget("export ok");
    answer(window, "replace", "Replace");
    announced(window, "1920 x 1080");
    EXPECT_EQ(folder.read("scene.png"), render_bytes(folder, folder.path("viewed.toml"), "1920x1080"));
}

// So large that nobody need hurry to meet it at work.
TEST(Exporting, LeavesTheWindowAliveAndCanBeCancelled) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", two_spheres);
    ViewerWindow window(folder, {scene, "--size", "12000x12000", "--samples", "16"});
    window.key("F12");
    const auto exports = [](const Json& f) { return !f.at("exporting").is_null() && f.at("widgets").contains("cancel work"); };
    window.wait_meanwhile("an export", exports);
    window.key("Insert");
    window.wait_meanwhile("an edit", [&](const Json& f) { return f.at("spheres") == 3 && exports(f); });
    window.key("ctrl+z");
    window.wait_meanwhile("an undo", [&](const Json& f) { return f.at("spheres") == 2 && exports(f); });
    window.key("Escape");
    window.wait_for("exporting", nullptr);
    window.wait_for("exact", true);
    EXPECT_FALSE(std::filesystem::exists(folder.path("scene.png")));

    // The window closes when the file is whole, or the export is given up.
    window.key("F12");
    window.wait_meanwhile("another export", exports);
    window.key("ctrl+q");
    window.key("Escape");
    window.wait_for("exporting", nullptr);
    window.key("ctrl+q");
    EXPECT_EQ(window.wait_for_end().status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder.path("scene.png")));
}

TEST(Exporting, EndsBeforeTheWindowDoes) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", two_spheres);
    ViewerWindow window(folder, {scene, "--size", "2000x2000"});
    window.keys({"F12", "ctrl+q"});
    EXPECT_EQ(window.wait_for_end().status, 0);
    EXPECT_EQ(folder.read("scene.png"), render_bytes(folder, scene, "2000x2000"));
}

TEST(Exporting, SaysWhyItCannotWriteAndLeavesNothing) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("gone/scene.txt", two_spheres);
    ViewerWindow window(folder, {scene});
    std::filesystem::remove_all(folder.path("gone"));
    const std::vector<std::string> before = folder.names();
    window.key("F12");
    answer(window, "error", "OK");
    wait_for_no_dialogs(window);
    EXPECT_EQ(window.frame().at("announcement"), "");
    EXPECT_EQ(folder.names(), before);
}

TEST(Exporting, PutsAnUntitledPictureIntoThePicturesFolder) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path("home/Pictures"));
    ViewerWindow window(folder, {"-", "--size", "64x48", "--background", "white"}, {}, two_spheres);
    EXPECT_EQ(window.frame().at("title"), "untitled - sphereview");
    EXPECT_EQ(window.frame().at("spheres"), 2);
    window.key("F12");
    announced(window, folder.path("home/Pictures/untitled.png") + " (64 x 48)");
    folder.write("scene.txt", two_spheres);
    const Outcome outcome =
        run({"render", folder.path("scene.txt"), "-s", "64x48", "--background", "white", "-o", folder.path("expected.png")});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(folder.read("home/Pictures/untitled.png"), folder.read("expected.png"));
}

}  // namespace sphereview::test
