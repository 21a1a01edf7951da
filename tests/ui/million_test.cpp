// A million spheres under the mouse.
#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "ui/viewer_window.hpp"

namespace sphereview::test {

namespace {

constexpr int sphere_count = 1'000'000;

// A cube of spheres that are a little out of line.
std::string cube() {
    std::string text = std::to_string(sphere_count) + "\n";
    for (int i = 0; i < sphere_count; ++i) {
        const auto off = [i](int prime) { return "." + std::to_string(100 + i % prime % 900); };
        text += std::to_string(i % 251) + " " + std::to_string(i % 241) + " 99 " + std::to_string(i % 100 * 2 - 99) + off(7919) +
                " " + std::to_string(i / 100 % 100 * 2 - 99) + off(6841) + " " + std::to_string(200 + i / 10'000 * 2) + off(5861) +
                " .7\n";
    }
    return text;
}

// The file as TOML, with the camera of a frame.
std::string seen_from(const TemporaryFolder& folder, const std::string& scene, const Json& camera) {
    const std::string file = folder.path("view.toml");
    const Outcome outcome = run({"convert", scene, file});
    EXPECT_EQ(outcome.status, 0) << outcome;
    const std::array<const char*, 4> names = {"eye", "center", "right", "up"};
    std::string text = folder.read("view.toml") + "\n[camera]\n";  // a text scene has none
    for (std::size_t i = 0; i < names.size(); ++i) text += std::string(names[i]) + " = " + camera.at(i).dump() + "\n";
    return folder.write("view.toml", text);
}

}  // namespace

TEST(Orbit, OfAMillionSpheresIsCoarseAndThenExact) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", cube());
    ViewerWindow window(folder, {scene});
    window.key("m");  // the frame of the export is drawn over the picture
    const Json before = window.wait_for("exact", true);
    const Place middle = window.pixel(200, 200);
    window.drag(middle, {middle.x + 90, middle.y + 40});
    window.move_to({2, 2});
    const Json after = window.wait_until("another view, at rest and exact", [&](const Json& frame) {
        return frame.at("camera") != before.at("camera") && frame.at("hovered").is_null() && frame.at("announcement") == "" &&
               frame.at("exact") == true;
    });
    EXPECT_EQ(after.at("step"), 1);

    int moving = 0;
    std::istringstream log(folder.read("frames.log"));
    for (std::string line; std::getline(log, line);) {
        const Json frame = Json::parse(line, nullptr, false);
        if (frame.is_discarded() || frame.at("camera") == before.at("camera") || frame.at("step") == 1) continue;
        ++moving;
    }
    EXPECT_GE(moving, 1);

    EXPECT_TRUE(same_picture(window.picture(), rendered(folder, seen_from(folder, scene, after.at("camera")), after)));
}

TEST(Drag, OfTwoOfAMillionSpheresBuildsNothingAnew) {
    const std::string moving = "Move 2 spheres";
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", cube());
    ViewerWindow window(folder, {scene});
    window.key("m");
    const auto at_rest = [&](const std::string& what, const Json& undo) {
        window.key("ctrl+shift+a");
        window.move_to({5, 5});
        return window.wait_until(what, [&](const Json& frame) {
            return frame.at("undo") == undo && frame.at("selected") == 0 && frame.at("hovered").is_null() &&
                   frame.at("announcement") == "" && frame.at("exact") == true;
        });
    };
    const Json before = at_rest("the scene, exact", "");
    const auto picture_before = window.picture();
    const Place place = window.pixel(400, 300);
    window.click(place);
    window.wait_for("selected", 1);
    window.key_down("ctrl");
    window.click(window.pixel(600, 500));  // and not the same place again, which would be a double click
    window.key_up("ctrl");
    window.wait_for("selected", 2);

    window.drag(place, {place.x + 60, place.y - 40});
    window.wait_for("undo", moving);
    window.key("Delete");
    window.wait_for("spheres", sphere_count - 2);
    window.key("ctrl+z");
    window.wait_for("spheres", sphere_count);
    const Json moved = at_rest("the spheres elsewhere, exact", moving);
    EXPECT_EQ(moved.at("builds"), before.at("builds"));
    EXPECT_FALSE(same_picture(window.picture(), picture_before));
    window.key("ctrl+s");
    window.wait_for("changed", false);
    const Json saved = at_rest("the saved scene", moving);
    EXPECT_TRUE(same_picture(window.picture(), rendered(folder, scene, saved)));

    window.key("ctrl+z");
    at_rest("the scene as it was", "");
    EXPECT_TRUE(same_picture(window.picture(), picture_before));
    EXPECT_EQ(window.frame().at("builds"), before.at("builds"));
}

}  // namespace sphereview::test
