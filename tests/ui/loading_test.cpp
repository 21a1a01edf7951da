// Scenes that take their time, while the window goes on.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/text_match.hpp"
#include "ui/file_steps.hpp"

namespace sphereview::test {

namespace {

constexpr int many = 100'000;  // some megabytes: read and written beside the loop

std::string large_scene(int count, int depth = 300) {
    std::string text = std::to_string(count) + "\n";
    for (int i = 0; i < count; ++i) {
        text += "255 0 0\n" + std::to_string(i % 300 - 150) + " " + std::to_string(i / 300 - 150) + " " + std::to_string(depth) +
                "\n0.5\n";
    }
    return text;
}

// A file that is read until its writer goes.
std::string make_fifo(const TemporaryFolder& folder, const std::string& name) {
    const std::string path = folder.path(name);
    EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
    return path;
}

bool reads(const Json& frame) { return !frame.at("loading").is_null() && frame.at("widgets").contains("cancel work"); }

}  // namespace

TEST(Loading, ShowsThatItWaitsAndCanBeCancelled) {
    const TemporaryFolder folder;
    const std::string fifo = make_fifo(folder, "slow.txt");
    ViewerWindow window(folder, {fifo});
    EXPECT_TRUE(reads(window.frame()));
    // The window is alive meanwhile.
    window.key("F1");
    window.wait_meanwhile("the help", [](const Json& f) { return f.at("shown").at("help") == true; });
    window.key("F1");
    window.wait_meanwhile("no help", [](const Json& f) { return f.at("shown").at("help") == false; });
    const Json box = window.frame().at("widgets").at("cancel work");
    window.click({(box[0].get<double>() + box[2].get<double>()) / 2, (box[1].get<double>() + box[3].get<double>()) / 2});
    window.wait_for("loading", nullptr);
    EXPECT_EQ(window.frame().at("spheres"), 0);
    window.press_close_button();
    EXPECT_EQ(window.wait_for_end().status, 0);
}

TEST(Loading, TakesTheSceneWhenItIsThere) {
    const TemporaryFolder folder;
    const std::string fifo = make_fifo(folder, "slow.txt");
    ViewerWindow window(folder, {fifo});
    EXPECT_TRUE(reads(window.frame()));
    std::ofstream(fifo) << two_spheres;
    window.wait_for("spheres", 2);
    EXPECT_EQ(window.frame().at("loading"), nullptr);
    EXPECT_EQ(window.frame().at("changed"), false);
}

TEST(Loading, SaysLateWhatIsWrongWithTheScene) {
    const TemporaryFolder folder;
    const std::string fifo = make_fifo(folder, "slow.txt");
    ViewerWindow window(folder, {fifo});
    std::ofstream(fifo) << "1\n255 0 0\n0 0 three\n60\n";
    answer(window, "error", "OK");
    wait_for_no_dialogs(window);
    EXPECT_EQ(window.frame().at("spheres"), 0);
}

TEST(Loading, EndsWithItsWindowAndWithASignal) {
    for (const bool by_signal : {false, true}) {
        const TemporaryFolder folder;
        ViewerWindow window(folder, {make_fifo(folder, "slow.txt")});
        if (by_signal) {
            window.send(SIGTERM);
        } else {
            window.press_close_button();
        }
        EXPECT_EQ(window.wait_for_end().status, by_signal ? 128 + SIGTERM : 0);
    }
}

TEST(Loading, KeepsTheOldSceneAndAsksAboutEditsMadeMeanwhile) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", one_sphere);
    const std::string fifo = make_fifo(folder, "slow.txt");
    ViewerWindow window(folder, {scene});
    window.key("ctrl+o");
    choose_file(window, fifo);
    window.wait_meanwhile("reading", reads);
    EXPECT_EQ(window.frame().at("spheres"), 1);
    window.key("Insert");
    window.wait_meanwhile("an edit", [](const Json& f) { return f.at("spheres") == 2; });
    std::ofstream(fifo) << two_spheres;
    answer(window, "save-changes", "Cancel");
    wait_for_no_dialogs(window);
    EXPECT_EQ(window.frame().at("path"), scene);
    EXPECT_EQ(window.frame().at("changed"), true);
    // Escape ends a reading, and leaves the selection alone.
    window.key("ctrl+z");
    window.wait_for("changed", false);
    window.key("ctrl+a");
    window.wait_for("selection", {0});
    window.key("ctrl+o");
    choose_file(window, fifo);
    window.wait_meanwhile("reading", reads);
    window.key("Escape");
    window.wait_for("loading", nullptr);
    EXPECT_EQ(window.frame().at("selection"), Json({0}));
}

TEST(Loading, AnotherOpenReplacesTheOneThatRuns) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", one_sphere);
    ViewerWindow window(folder, {make_fifo(folder, "slow.txt")});
    ASSERT_TRUE(window.drop({scene}));
    window.wait_for("path", scene);
    EXPECT_EQ(window.frame().at("spheres"), 1);
    EXPECT_EQ(window.frame().at("loading"), nullptr);
}

TEST(Loading, ReloadsALargeFileAndCloseWaitsForALargeSave) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", large_scene(many));
    ViewerWindow window(folder, {scene});
    window.wait_for("spheres", many);
    replace_by_rename(folder, "scene.txt", large_scene(many + 1));
    window.wait_for("spheres", many + 1);
    // Broken at its end: the scene stays.
    replace_by_rename(folder, "scene.txt", large_scene(many + 1) + "x");
    window.wait_until("an error", [](const Json& f) { return f.at("scene_error") != ""; });
    EXPECT_EQ(window.frame().at("spheres"), many + 1);
    replace_by_rename(folder, "scene.txt", large_scene(many, 400));
    window.wait_for("spheres", many);
    edit(window);
    window.key("ctrl+s");
    window.press_close_button();
    EXPECT_EQ(window.wait_for_end().status, 0);
    EXPECT_EQ(lines(folder.read("scene.txt")).front(), std::to_string(many + 1));
    EXPECT_EQ(lines(folder.read("scene.txt")).size(), lines(large_scene(many + 1)).size());
}

TEST(Loading, AMillionSpheres) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", large_scene(1'000'000));
    ViewerWindow window(folder, {scene});
    window.wait_for("spheres", 1'000'000);
}

}  // namespace sphereview::test
