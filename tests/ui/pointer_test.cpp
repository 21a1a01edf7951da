// What the mouse does in the picture.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <thread>

#include "ui/viewer_window.hpp"

namespace sphereview::test {

namespace {

// One sphere straight ahead whose picture is a third of the screen wide, a small one beside it.
constexpr const char* two_spheres = "2\n255 0 0\n0 0 300\n60\n0 255 0\n120 0 300\n20\n";

class Pointer : public testing::Test {
protected:
    Pointer() : scene_(folder_.write("scene.txt", two_spheres)), window_(folder_, {scene_}) {
        const Json& size = window_.frame().at("picture_size");
        middle_ = {size[0].get<double>() / 2, size[1].get<double>() / 2};
        unit_ = std::min(size[0].get<double>(), size[1].get<double>()) / 100.0;
    }

    // A place in the picture by its coordinates on the default screen: (0, 0) is the middle, 50 a half of the shorter side.
    Place on_screen(double x, double y) { return window_.pixel(middle_.x + unit_ * x, middle_.y - unit_ * y); }

    void select_red() {
        window_.click(on_screen(0, 0));
        window_.wait_for("selection", {0});
    }

    Place camera_eye() { return {window_.frame().at("camera")[0][0], window_.frame().at("camera")[0][2]}; }

    // The scene's spheres as saved.
    std::vector<double> saved() {
        window_.key("ctrl+s");
        window_.wait_for("changed", false);
        std::istringstream text(folder_.read("scene.txt"));
        std::vector<double> numbers;
        for (double number = 0.0; text >> number;) numbers.push_back(number);
        return numbers;
    }

    TemporaryFolder folder_;
    std::string scene_;
    ViewerWindow window_;
    Place middle_;
    double unit_ = 1.0;
};

}  // namespace

TEST_F(Pointer, MovesASelectedSphereUnderItAndWithShiftInDepth) {
    select_red();
    window_.drag(on_screen(0, 0), on_screen(-20, 10));
    window_.wait_for("undo", "Move sphere 0");
    std::vector<double> numbers = saved();
    // What was grabbed, at z = 240, follows the pointer: 20 on the screen, at z = 100, is 48 there.
    EXPECT_NEAR(numbers[4], -48.0, 1.5);
    EXPECT_NEAR(numbers[5], 24.0, 1.5);
    EXPECT_EQ(numbers[6], 300.0);

    window_.key("ctrl+z");
    window_.wait_for("undo", "");
    window_.key_down("shift");
    window_.drag(on_screen(0, 0), on_screen(0, 15));
    window_.key_up("shift");
    window_.wait_for("undo", "Move sphere 0");
    numbers = saved();
    EXPECT_EQ(numbers[4], 0.0);
    EXPECT_GT(numbers[6], 400.0);  // up is away
}

TEST_F(Pointer, EscapeTakesADragBack) {
    select_red();
    window_.move_to(on_screen(0, 0));
    window_.press();
    window_.move_to(on_screen(-10, 0));
    window_.move_to(on_screen(-20, 0));
    window_.wait_for("undo", "Move sphere 0");
    window_.key("Escape");
    window_.wait_for("undo", "");
    window_.move_to(on_screen(10, 0));
    window_.release();
    window_.wait_for("selection", {0});
    EXPECT_EQ(window_.frame().at("changed"), false);
}

TEST_F(Pointer, TurnsOfTheWheelWithControlChangeTheRadiusInOneStep) {
    select_red();
    window_.key_down("ctrl");
    window_.wheel(3);
    window_.key_up("ctrl");
    window_.wait_for("undo", "Change the radius of sphere 0");
    const std::vector<double> numbers = saved();
    EXPECT_NEAR(numbers[7], 60.0 * std::pow(1.06, 3), 1e-9);
    window_.key("ctrl+z");
    window_.wait_for("undo", "");
}

TEST_F(Pointer, OrbitsPansZoomsCentresAndGoesHome) {
    const Json home = window_.frame().at("camera");
    const auto another = [&](const Json& before) {
        return window_.wait_until("another view", [&](const Json& frame) { return frame.at("camera") != before; }).at("camera");
    };
    Json camera = home;
    window_.drag(on_screen(-40, -40), on_screen(-20, -40));  // orbit
    camera = another(camera);
    EXPECT_LT(camera[0][0].get<double>(), -10.0);               // the scene turns with the pointer
    window_.drag(on_screen(-40, -40), on_screen(-30, -40), 2);  // pan
    camera = another(camera);
    window_.key_down("shift");
    window_.drag(on_screen(-40, -40), on_screen(-40, -30));
    window_.key_up("shift");
    camera = another(camera);
    window_.drag(on_screen(-40, -40), on_screen(-40, -45), 3);  // zoom
    camera = another(camera);
    window_.key("Home");
    window_.wait_for("camera", home);

    window_.move_to(on_screen(40, 0));  // the green sphere keeps its place under the pointer
    window_.wait_for("hovered", 1);
    window_.wheel(4);
    camera = another(home);
    window_.move_to(on_screen(40, 1));
    window_.move_to(on_screen(40, 0));
    window_.wait_for("hovered", 1);
    window_.double_click(on_screen(40, 0));
    window_.wait_until("the green sphere in the middle", [](const Json& frame) {
        const double eye = frame.at("camera")[0][0];
        return std::abs(eye - 120.0) < 1.0;
    });
    EXPECT_EQ(window_.frame().at("changed"), false);  // views are no edits
    EXPECT_EQ(window_.frame().at("undo"), "");
}

// 20 clicks that come faster than frames: each of them counts.
TEST_F(Pointer, QuickClicksAndKeysAreNotLost) {
    const Place eye = window_.widget("row 0 eye");
    const std::int64_t before = window_.frame().at("revision");
    window_.click_many(eye, 20);
    window_.wait_until("20 changes", [&](const Json& frame) { return frame.at("revision") == before + 20; });
    for (int i = 0; i < 4; ++i) window_.keys({"ctrl+z", "ctrl+z", "ctrl+z", "ctrl+z", "ctrl+z"});
    window_.wait_for("undo", "");
    EXPECT_EQ(window_.frame().at("revision"), before + 40);
    EXPECT_EQ(window_.frame().at("changed"), false);
}

TEST_F(Pointer, AnIdleWindowDrawsNothing) {
    window_.move_to(on_screen(0, 0));
    window_.wait_for("hovered", 0);
    // Nothing to wait for: what is to happen is nothing, for three seconds. The server may still have had something to say before.
    std::int64_t frames = -1;
    double before = 0.0;
    for (int i = 0; i < 5 && frames != window_.frame().at("frame").get<std::int64_t>(); ++i) {
        frames = window_.frame().at("frame");
        before = window_.processor_seconds();
        std::this_thread::sleep_for(std::chrono::seconds(3));
    }
    EXPECT_EQ(window_.frame().at("frame"), frames);
    EXPECT_LT(window_.processor_seconds() - before, 0.06);  // two ticks of the clock in which it is counted, and some
}

}  // namespace sphereview::test
