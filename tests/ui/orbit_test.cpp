// A million spheres turn under the mouse coarsely, and stand still exactly.
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

}  // namespace sphereview::test
