// Fitting the view: it moves there, rests there, and shows what `render --fit` does.
#include <gtest/gtest.h>

#include "support/render.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

constexpr const char* molecule = "3\n\nO 100 100 100\nH 101 100 100\nH 100 101 100\n";

// The scene as `render` shows it, in the size of the window's picture.
Picture rendered_as(const std::string& scene, const Json& frame, std::vector<std::string> options) {
    const Json& size = frame.at("picture_size");
    options.insert(options.end(), {"-s", std::to_string(size[0].get<int>()) + "x" + std::to_string(size[1].get<int>())});
    return picture_of(scene, "cpu", options);
}

// The window's picture, nothing hovered and no frame marked.
Picture picture_alone(ViewerWindow& window) {
    window.key("m");
    window.move_to({5.0, 5.0});
    // Keys are taken in order: what came before has been done.
    window.key("ctrl+a");
    window.wait_until("a selection", [](const Json& f) { return !f.at("selection").empty(); });
    window.key("ctrl+shift+a");
    window.wait_until("no marks", [](const Json& f) { return f.at("selection").empty() && f.at("hovered").is_null(); });
    return window.picture();
}

class FitByKeys : public Editing {
protected:
    FitByKeys() : Editing("scene.toml"), home_(window_.frame().at("camera")) {}

    void expect_fitted(const std::string& view) {
        take_marks_away();
        EXPECT_TRUE(same_picture(window_.picture(), rendered_as(two_spheres, window_.frame(), {"--view", view}))) << view;
    }

    Json home_;
};

}  // namespace

TEST_F(FitByKeys, FitsEverythingFromEverySide) {
    Json last = home_;
    for (const auto& [key, view] : {std::pair{"4", "iso"}, {"2", "right"}, {"3", "top"}, {"1", "front"}}) {
        window_.key(key);
        last = window_.wait_until("another view", [&](const Json& f) { return f.at("camera") != last; }).at("camera");
        expect_fitted(view);
    }
    EXPECT_EQ(window_.frame().at("changed"), false);
    // From where the view is.
    window_.move_to(window_.pixel(20, 20));
    window_.wheel(-1);
    last = window_.wait_until("another view", [&](const Json& f) { return f.at("camera") != last; }).at("camera");
    window_.key("f");
    window_.wait_until("the view fitted", [&](const Json& f) { return f.at("camera") != last; });
    expect_fitted("front");
    window_.key("Home");
    window_.wait_for("camera", home_);
}

TEST_F(FitByKeys, EndsWhenAnythingElseIsDone) {
    window_.keys({"4", "Home", "ctrl+a"});
    EXPECT_EQ(window_.wait_for("selection", {0, 1}).at("camera"), home_);
    expect_rendered();
}

TEST(FramedWindow, OpensDataFitted) {
    const TemporaryFolder folder;
    ViewerWindow window(folder, {folder.write("water.xyz", molecule)});
    const Json home = window.frame().at("camera");
    EXPECT_TRUE(same_picture(picture_alone(window), rendered_as(molecule, window.frame(), {})));
    window.key("3");
    window.wait_until("the view from the top", [&](const Json& f) { return f.at("camera") != home; });
    EXPECT_TRUE(same_picture(window.picture(), rendered_as(molecule, window.frame(), {"--view", "top"})));
    window.key("Home");
    window.wait_for("camera", home);
}

TEST(FramedWindow, FitsOnlyTheViewOfASceneThatHasACamera) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", two_spheres);
    ViewerWindow window(folder, {scene, "--view", "right"});
    EXPECT_TRUE(same_picture(picture_alone(window), rendered_as(two_spheres, window.frame(), {"--view", "right"})));
    EXPECT_EQ(window.frame().at("changed"), false);
    const Json fitted = window.frame().at("camera");
    window.key("Home");
    window.wait_until("the scene's own camera", [&](const Json& f) { return f.at("camera") != fitted; });
    EXPECT_TRUE(same_picture(window.picture(), rendered_as(two_spheres, window.frame(), {})));
}

}  // namespace sphereview::test
