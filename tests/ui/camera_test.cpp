// Orbit, pan, zoom and home: the view is what `render` makes of the scene saved with it.
#include <gtest/gtest.h>

#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

class CameraByHand : public Editing {
protected:
    CameraByHand() : Editing("scene.toml"), home_(window_.frame().at("camera")) {}

    // The view has changed; saved as the scene's camera, it is rendered as it is shown; Home and undo lead back.
    void expect_view_rendered() {
        window_.wait_until("another view", [&](const Json& f) { return f.at("camera") != home_; });
        window_.key("ctrl+Home");
        window_.wait_for("undo", "Use of this view as the camera");
        expect_rendered();
        window_.key("ctrl+z");
        window_.wait_for("undo", "");
        window_.key("Home");
        window_.wait_for("camera", home_);
        expect_rendered();
    }

    Json home_;
};

}  // namespace

TEST_F(CameraByHand, ADragOrbitsPansAndZooms) {
    window_.drag(window_.pixel(50, 50), window_.pixel(150, 90));
    expect_view_rendered();
    window_.drag(red(), red(70, 33), 2);
    expect_view_rendered();
    window_.key_down("shift");
    window_.drag(red(), red(-70, 33));
    window_.key_up("shift");
    expect_view_rendered();
    window_.drag(red(), red(0, -80), 3);
    expect_view_rendered();
}

TEST_F(CameraByHand, TheWheelZoomsAtThePointer) {
    // The sphere's edge at the pointer: a zoom keeps what is there, and so both sides of the edge.
    window_.move_to(red(50, 20));
    window_.wheel(3);
    expect_view_rendered();
    window_.move_to(red(50, 20));
    window_.wheel(-3);
    expect_view_rendered();
}

TEST_F(CameraByHand, ADoubleClickCentres) {
    const Json& size = window_.frame().at("picture_size");
    const double side = std::min(size[0].get<double>(), size[1].get<double>());
    // The green sphere's centre is at a third of the screen's half width.
    window_.double_click(red(side / 2 * 100 / 300 / 0.5, 0));
    window_.wait_for("selection", {1});
    window_.wait_until("the green sphere in the middle", [&](const Json& f) { return f.at("camera") != home_; });
    window_.move_to(red());
    window_.wait_for("hovered", 1);
    expect_view_rendered();
}

TEST_F(CameraByHand, EverySizeOfTheWindowShowsSquarePixels) {
    for (const auto& [width, height] : {std::pair{1001, 701}, std::pair{700, 951}, std::pair{1399, 555}}) {
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
        const Json before = window_.frame().at("picture_size");
        window_.resize(width, height);
        window_.wait_until("another size", [&](const Json& f) { return f.at("picture_size") != before; });
        expect_rendered();
    }
}

TEST_F(CameraByHand, TheFrameOfTheExportIsMarked) {
    window_.resize(1300, 701);
    take_marks_away();
    const Picture plain = window_.picture();
    window_.key("m");
    window_.wait_until("a frame", [&](const Json&) { return !same_picture(window_.picture(), plain); });
    window_.key("m");
    window_.wait_until("no frame", [&](const Json&) { return static_cast<bool>(same_picture(window_.picture(), plain)); });
}

}  // namespace sphereview::test
