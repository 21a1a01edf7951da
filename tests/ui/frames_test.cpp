// Frames of a file in the window: played, paused and looked for.
#include <gtest/gtest.h>

#include "ui/editing.hpp"

namespace sphereview::test {

TEST(FramesInTheWindow, ArePlayedPausedAndLookedForByTheHandle) {
    const TemporaryFolder folder;
    constexpr int frames = 40;
    std::string text;
    for (int i = 0; i < frames; ++i) {
        // The corners stay, and so does the fitted camera.
        text += "4\n\nC 0 0 0\nC 30 20 4\nO " + std::to_string(8 + i % 10) + " 10 4\nN 20 " + std::to_string(5 + i % 7) + " 4\n";
    }
    const std::string path = folder.write("film.xyz", text);
    ViewerWindow window(folder, {path});
    window.key("m");
    const Json camera = window.at("camera");
    const auto frame_of = [](const Json& f) { return f.at("frame")[0].get<int>(); };
    const auto expect_exact = [&](int frame) {
        take_marks_away(window);
        expect_rendered(window, folder, path, {"--background", "#202430", "--frame", std::to_string(frame)});
    };

    window.step("played, and exact when it stops");
    window.key("space");
    window.wait_meanwhile("a frame that plays", [&](const Json& f) { return f.at("playing") == true && frame_of(f) >= 3; });
    window.key("space");
    const int paused = frame_of(window.wait_until("a pause", [](const Json& f) { return f.at("playing") == false; }));
    expect_exact(paused);
    EXPECT_EQ(window.at("camera"), camera);

    window.step("the handle");
    const Place from = window.widget("timeline", 0.5);
    window.drag(from, window.widget("timeline", 0.995));
    window.wait_for("frame", {frames - 1, frames});
    window.drag(window.widget("timeline", 0.995), window.widget("timeline", 0.005));
    window.wait_for("frame", {0, frames});

    window.step("what is changed and no place goes along, and a place is asked about");
    window.click(window.on_screen(0, 0));
    window.key("ctrl+a");
    window.wait_until("a selection", [](const Json& f) { return f.at("selected") == 4; });
    window.key("h");
    window.wait_for("changed", true);
    window.key("Page_Down");
    window.wait_for("frame", {1, frames});
    EXPECT_EQ(window.at("selected"), 4);
    EXPECT_EQ(window.at("undo"), "Changes of all frames");
    EXPECT_TRUE(window.draws("edits reach") || window.draws("edits mark"));  // words where there is room for them
    window.key("h");
    window.wait_for("undo", "Show 4 spheres");
    edit(window);
    window.key("k");
    answer(window, "save-changes", "Don't save");
    window.wait_meanwhile("a film that plays on", [&](const Json& f) { return f.at("playing") == true && frame_of(f) >= 4; });
    window.key("Page_Up");
    const int stepped = frame_of(window.wait_until("a step", [](const Json& f) { return f.at("playing") == false; }));
    EXPECT_EQ(window.at("spheres"), 4);
    expect_exact(stepped);

    window.step("Space pins a pixel, where there is one");
    window.key("i");
    window.wait_until("the inspector", [](const Json& f) { return f.at("shown").at("inspector") == true; });
    window.move_to(window.on_screen(0, 0));
    window.wait_until("a pixel", [](const Json& f) { return !f.at("inspected").is_null(); });
    window.key("space");
    window.wait_until("a pin", [](const Json& f) { return f.at("inspected").at("pinned") == true; });
    EXPECT_EQ(window.at("playing"), false);
}

}  // namespace sphereview::test
