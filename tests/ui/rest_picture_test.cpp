// The picture at rest is what `render` writes, byte for byte, in every shading mode and with any samples; while something moves,
// the live one is shown.
#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <thread>

#include "support/text_match.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

class PictureAtRest : public Editing {
protected:
    // The window at rest shows the file's scene so, as `render` writes it.
    void expect_rest(int samples, const std::string& shading = "flat") {
        window_.key("ctrl+s");
        window_.wait_for("changed", false);
        take_marks_away();
        const Json frame = window_.wait_until("such a picture", [&](const Json& f) {
            return f.at("samples") == samples && f.at("shading") == shading && f.at("exact") == true;
        });
        const std::string size =
            std::to_string(frame.at("picture_size")[0].get<int>()) + "x" + std::to_string(frame.at("picture_size")[1].get<int>());
        EXPECT_TRUE(same_picture(window_.picture(), decode_png(rendered_so(size, samples, shading)))) << shading << samples;
    }

    // What `render` writes.
    std::string rendered_so(const std::string& size, int samples, const std::string& shading) {
        const Outcome outcome = run({"render", scene_, "--backend", "cpu", "--shade", shading, "-s", size, "--samples",
                                     std::to_string(samples), "-o", folder_.path("expected.png")});
        EXPECT_EQ(outcome.status, 0) << outcome;
        return folder_.read("expected.png");
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

TEST_F(PictureAtRest, IsWhatRenderWritesInEveryMode) {
    window_.choose("View", "4 samples a pixel");
    expect_rest(4);
    window_.click_widget("menu View");
    window_.click_widget("menu Shading");
    window_.click_widget("item Headlight");
    window_.wait_for("shading", "headlight");
    expect_rest(4, "headlight");
    window_.key("F12");
    announced(window_, "scene.png");
    EXPECT_EQ(folder_.read("scene.png"), rendered_so("1000x1000", 4, "headlight"));
    for (const auto& [key, samples] : {std::pair{"alt+1", 1}, {"alt+6", 16}}) {
        window_.key(key);
        for (const auto& [mode_key, mode] :
             {std::pair{"ctrl+2", "headlight"}, {"ctrl+3", "normal"}, {"ctrl+4", "depth"}, {"ctrl+5", "id"}, {"ctrl+1", "flat"}}) {
            window_.key(mode_key);
            expect_rest(samples, mode);
        }
    }
}

TEST_F(PictureAtRest, GivesWayToTheLivePictureAndComesBack) {
    window_.key("alt+4");
    expect_rest(4);
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
    expect_rest(4);
    window_.key("ctrl+z");
    expect_rest(4);
}

TEST_F(PictureAtRest, DrawsNothingOnceItIsThere) {
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
