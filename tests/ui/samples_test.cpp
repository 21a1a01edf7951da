// Anti-aliasing: the picture at rest is what `render --samples` writes; while something moves, the live one is shown.
#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <thread>

#include "support/text_match.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

class AntiAliasing : public Editing {
protected:
    // The window at rest shows the file's scene with so many samples, and as `render` writes it.
    void expect_samples(int samples) {
        window_.key("ctrl+s");
        window_.wait_for("changed", false);
        take_marks_away();
        const Json& frame = window_.wait_for("samples", samples);
        const std::string size =
            std::to_string(frame.at("picture_size")[0].get<int>()) + "x" + std::to_string(frame.at("picture_size")[1].get<int>());
        const Outcome outcome = run({"render", scene_, "--backend", "cpu", "-s", size, "--samples", std::to_string(samples), "-o",
                                     folder_.path("expected.png")});
        ASSERT_EQ(outcome.status, 0) << outcome;
        EXPECT_TRUE(same_picture(window_.picture(), decode_png(folder_.read("expected.png"))));
    }
    // What the window drew first of the scene as it was then.
    Json first_frame_of(const Json& revision) const {
        std::istringstream log(folder_.read("frames.log"));
        for (std::string line; std::getline(log, line);) {
            const Json frame = Json::parse(line);
            if (frame.at("revision") == revision) return frame;
        }
        throw std::runtime_error("no such frame");
    }
};

}  // namespace

TEST_F(AntiAliasing, IsChosenInTheMenuAndIsInThePictureAtRest) {
    expect_samples(1);
    window_.choose("View", "4 samples a pixel");
    expect_samples(4);
    window_.choose("View", "16 samples a pixel");
    expect_samples(16);
    window_.key("alt+1");
    expect_samples(1);
    window_.key("alt+6");
    expect_samples(16);
}

TEST_F(AntiAliasing, GivesWayToTheLivePictureAndComesBack) {
    window_.key("alt+4");
    expect_samples(4);
    select_red();
    const Json before = window_.wait_for("samples", 4);
    const Place from = window_.widget("slider x");
    window_.move_to(from);
    window_.press();
    window_.move_to({from.x - 25, from.y});
    // It refines also while the button is held, when the hand rests.
    const Json moved = window_.wait_until("another picture", [&](const Json& frame) {
        return frame.at("revision") != before.at("revision") && frame.at("samples") == 4;
    });
    EXPECT_EQ(first_frame_of(moved.at("revision")).at("samples"), 1) << "at once, as without anti-aliasing";
    window_.move_to({from.x - 40, from.y});
    window_.wait_until("another picture",
                       [&](const Json& frame) { return frame.at("revision") != moved.at("revision") && frame.at("samples") == 4; });
    window_.release();
    expect_samples(4);
    window_.key("ctrl+z");
    expect_samples(4);
}

TEST_F(AntiAliasing, DrawsNothingOnceItIsThere) {
    window_.key("alt+6");
    take_marks_away();
    const Json last = window_.wait_for("samples", 16).at("frame");
    const double before = window_.processor_seconds();
    constexpr double seconds = 2.0;
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    EXPECT_EQ(window_.frame().at("frame"), last);
    EXPECT_LT(window_.processor_seconds() - before, 0.03 * seconds);
}

TEST(Samples, AreKeptOverriddenAndInExports) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", two_spheres);
    {
        ViewerWindow window(folder, {scene, "--size", "90x80"});
        EXPECT_EQ(window.frame().at("samples"), 1);
        window.key("alt+6");
        window.wait_for("samples", 16);
        window.key("F12");
        window.wait_until("an export", [](const Json& frame) { return frame.at("announcement") != ""; });
        EXPECT_TRUE(contains(window.frame().at("announcement").get<std::string>(), "scene.png (90 x 80, 16 samples a pixel)"));
        window.key("ctrl+q");
        EXPECT_EQ(window.wait_for_end().status, 0);
    }
    const Outcome outcome = run({"render", scene, "-s", "90x80", "--samples", "16", "-o", folder.path("expected.png")});
    ASSERT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(folder.read("scene.png"), folder.read("expected.png"));
    {
        ViewerWindow window(folder, {scene});
        window.wait_for("samples", 16);
        window.key("ctrl+q");
        EXPECT_EQ(window.wait_for_end().status, 0);
    }
    ViewerWindow window(folder, {scene, "--samples", "4"});
    window.wait_for("samples", 4);
}

}  // namespace sphereview::test
