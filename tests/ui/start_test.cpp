// Starts: without a display, with a bad scene, with what the last run kept.
#include <gtest/gtest.h>

#include "support/text_match.hpp"
#include "ui/file_steps.hpp"

namespace sphereview::test {

namespace {

Outcome start(const TemporaryFolder& folder, const std::vector<std::string>& arguments, const std::optional<std::string>& display) {
    Command command;
    command.arguments = arguments;
    command.folder = folder.path();
    command.environment = {{"DISPLAY", display}, {"WAYLAND_DISPLAY", std::nullopt}, {"HOME", folder.path("home")}};
    return run(command);
}

}  // namespace

TEST(Starting, WithoutADisplayIsRefusedInOneLine) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", one_sphere);
    for (const std::optional<std::string>& display : {std::optional<std::string>(), std::optional<std::string>(":65000")}) {
        const Outcome outcome = start(folder, {scene}, display);
        EXPECT_EQ(outcome.status, 3) << outcome;
        EXPECT_EQ(lines(outcome.errors).size(), 1u) << outcome;
        EXPECT_TRUE(contains(outcome.errors, "sphereview render"));
        EXPECT_TRUE(contains(outcome.errors, "sphereview doctor"));
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.txt"});
}

TEST(Starting, WithASceneThatCannotBeReadIsRefusedInOneLine) {
    const TemporaryFolder folder;
    folder.write("broken.txt", "1\n255 0 0\n0 0 three\n60\n");
    Outcome outcome = start(folder, {"broken.txt"}, std::nullopt);
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_EQ(lines(outcome.errors).size(), 1u) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "broken.txt:3:5: "));
    outcome = start(folder, {"missing.txt"}, std::nullopt);
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_EQ(lines(outcome.errors).size(), 1u) << outcome;
}

TEST(Starting, BringsBackTheWindowAsItWas) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scenes/scene.txt", one_sphere);
    Json picture;
    {
        ViewerWindow window(folder, {scene});
        const Json before = window.frame().at("picture");
        const Place edge = window.widget("splitter");
        window.drag(edge, {edge.x - 120, edge.y});
        picture =
            window.wait_until("a wider panel", [&](const Json& f) { return f.at("picture")[2] < before[2].get<double>() - 100; })
                .at("picture");
        window.press_close_button();
        EXPECT_EQ(window.wait_for_end().status, 0);
    }
    // All that was written lies in the home folder.
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"frames.log", "home", "scenes"}));
    EXPECT_TRUE(folder.has("home/config/sphereview"));
    ViewerWindow window(folder, {});
    EXPECT_EQ(window.frame().at("picture"), picture);
    window.click_widget("menu File");
    window.click_widget("menu Open recent");
    window.click_widget("recent 0");
    window.wait_for("path", scene);
    EXPECT_EQ(window.frame().at("camera")[0], Json({0.0, 0.0, 0.0}));
}

}  // namespace sphereview::test
