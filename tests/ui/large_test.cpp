// A hundred thousand spheres, and a million, under the mouse.
#include <gtest/gtest.h>

#include <csignal>

#include "support/text_match.hpp"
#include "support/trials.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

// A wall of spheres that fills the picture; of so many, in rows of 400.
std::string wall(int count, const std::string& depth = "300") {
    std::string text = std::to_string(count) + "\n";
    for (int i = 0; i < count; ++i) {
        text += "200 " + std::to_string(i % 256) + " 0\n" + std::to_string(i % 400 - 200) + " " + std::to_string(i / 400 - 125) +
                " " + depth + "\n0.4\n";
    }
    return text;
}

// A sanitised program is as slow with a part of them.
constexpr int million = is_sanitized ? 200'000 : 1'000'000;

// A cube of spheres that are a little out of line.
std::string cube() {
    std::string text = std::to_string(million) + "\n";
    for (int i = 0; i < million; ++i) {
        const auto off = [i](int prime) { return "." + std::to_string(100 + i % prime % 900); };
        text += std::to_string(i % 251) + " " + std::to_string(i % 241) + " 99 " + std::to_string(i % 100 * 2 - 99) + off(7919) +
                " " + std::to_string(i / 100 % 100 * 2 - 99) + off(6841) + " " + std::to_string(200 + i / 10'000 * 2) + off(5861) +
                " .7\n";
    }
    return text;
}

}  // namespace

TEST(HundredThousandSpheres, AreListedMovedReloadedAndSaved) {
    constexpr int many = 100'000;  // some megabytes: read and written beside the loop
    const TemporaryFolder folder;
    const std::string text = wall(many);
    ViewerWindow window(folder, {folder.write("wall.txt", text)});

    window.step("all move together, and one undo brings the bytes back");
    window.key("ctrl+a");
    window.wait_for("selected", many);
    const Place from = window.on_screen(0, 0);
    window.drag(from, {from.x + 30, from.y + 20});
    window.wait_for("undo", "Move 100,000 spheres");
    window.key("ctrl+z");
    window.wait_for("undo", "");
    EXPECT_EQ(window.at("changed"), false);
    window.key("ctrl+i");
    window.wait_for("selected", 0);
    window.key("ctrl+shift+s");
    choose_file(window, "back.txt");
    window.wait_for("path", folder.path("back.txt"));
    EXPECT_TRUE(folder.read("back.txt") == text);

    window.step("a file that changes is reloaded");
    replace_by_rename(folder, "back.txt", wall(many + 1));
    window.wait_for("spheres", many + 1);
    replace_by_rename(folder, "back.txt", wall(many + 1) + "x");  // broken at its end: the scene stays
    window.wait_for_other("scene_error", "");
    EXPECT_EQ(window.at("spheres"), many + 1);
    replace_by_rename(folder, "back.txt", wall(many, "400"));
    window.wait_for("spheres", many);

    window.step("the end waits for a save");
    edit(window);
    window.key("ctrl+s");
    window.press_close_button();
    EXPECT_EQ(window.wait_for_end().status, 0);
    EXPECT_EQ(lines(folder.read("back.txt")).front(), std::to_string(many + 1));
    EXPECT_EQ(lines(folder.read("back.txt")).size(), lines(wall(many + 1)).size());
}

// Each covers the whole picture and the one behind it: to trace every pixel takes a processor half a minute.
TEST(OverlappingSpheres, AreCoarseAtFirstAndTheWindowAnswersMeanwhile) {
    constexpr int many = 5'000;
    std::string text = std::to_string(many) + "\n";
    for (int i = 0; i < many; ++i) text += "99 " + std::to_string(i % 256) + " 0  0 0 " + std::to_string(1000 + i) + "e-3 2000\n";
    const TemporaryFolder folder;
    ViewerWindow window(folder, {});
    EXPECT_TRUE(window.drop({folder.write("scene.txt", text)}));
    const auto coarse = [](const Json& redraw) { return redraw.at("step").get<int>() > 1; };
    window.wait_meanwhile("the first picture is coarse",
                          [&](const Json& redraw) { return redraw.at("spheres") == many && coarse(redraw); });
    window.key("ctrl+a");
    window.wait_meanwhile("an answer before it is fine",
                          [&](const Json& redraw) { return redraw.at("selected") == many && coarse(redraw); });
    window.send(SIGTERM);
    EXPECT_EQ(window.wait_for_end().status, 128 + SIGTERM);
    for (const Json& redraw : logged_redraws(folder)) {
        EXPECT_TRUE(redraw.at("spheres") != many || coarse(redraw)) << redraw.dump();
    }
}

TEST(MillionSpheres, AreCoarseWhileTheyTurnThenExactAndDraggedWithoutBuilding) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", cube());
    ViewerWindow window(folder, {scene});
    window.wait_for("spheres", million);
    window.key("m");  // the mark of the export is drawn over the picture
    const Json home = window.wait_for("exact", true).at("camera");

    window.step("an orbit");
    const Place middle = window.pixel(200, 200);
    window.drag(middle, {middle.x + 90, middle.y + 40});
    window.wait_for_other("camera", home);
    const Json turned = take_marks_away(window);
    EXPECT_EQ(turned.at("step"), 1);
    // After a redraw that took long, what still moves is coarse. How many redraws the drag has is the machine's affair.
    constexpr double long_time = 0.1;  // seconds
    bool was_slow = false;
    Json camera = home;
    for (const Json& redraw : logged_redraws(folder)) {
        const bool moves = redraw.at("camera") != camera;
        EXPECT_FALSE(moves && was_slow && redraw.at("step") == 1) << redraw.dump();
        was_slow = moves && redraw.at("step") == 1 && redraw.at("seconds") > long_time;
        camera = redraw.at("camera");
    }
    window.key("Home");
    window.wait_for("camera", home);

    window.step("a drag of two builds nothing anew");
    const std::string move = "Move 2 spheres";
    const auto at_rest = [&](const std::string& undo) {
        window.wait_for("undo", undo);
        return take_marks_away(window);
    };
    const Json before = at_rest("");
    const Picture picture_before = window.picture();
    const Place place = window.pixel(400, 300);
    window.click(place);
    window.wait_for("selected", 1);
    window.key_down("ctrl");
    window.click(window.pixel(600, 500));  // and not the same place again, which would be a double click
    window.key_up("ctrl");
    window.wait_for("selected", 2);
    window.drag(place, {place.x + 60, place.y - 40});
    window.wait_for("undo", move);
    window.key("Delete");
    window.wait_for("spheres", million - 2);
    window.key("ctrl+z");
    window.wait_for("spheres", million);
    const Json moved = at_rest(move);
    EXPECT_EQ(moved.at("builds"), before.at("builds"));
    EXPECT_FALSE(same_picture(window.picture(), picture_before));
    window.key("ctrl+s");
    window.wait_for("changed", false);
    expect_rendered(window, folder, scene);
    window.key("ctrl+z");
    const Json undone = at_rest("");
    EXPECT_TRUE(same_picture(window.picture(), picture_before));
    EXPECT_EQ(undone.at("builds"), before.at("builds"));
}

}  // namespace sphereview::test
