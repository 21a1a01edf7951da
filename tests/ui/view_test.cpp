// The view: by hand, by keys, of data, on any screen. It is what `render` makes of the scene saved with it, or of a fit.
#include <gtest/gtest.h>

#include <cmath>

#include "support/eventually.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

class View : public Editing {
protected:
    View() : Editing("scene.toml"), home_(window_.at("camera")) {}

    // The view is another than home, which is no edit; Home leads back.
    Json expect_view(const std::string& step) {
        window_.step(step);
        SCOPED_TRACE(step);
        const Json view = window_.wait_for_other("camera", home_);
        EXPECT_EQ(window_.at("undo"), "");
        window_.key("Home");
        window_.wait_for("camera", home_);
        return view;
    }
    // Saved as the scene's camera, the view is rendered as it is shown.
    void expect_view_rendered() {
        window_.wait_for_other("camera", home_);
        window_.key("ctrl+Home");
        window_.wait_for("undo", "Use of this view as the camera");
        expect_rendered();
        window_.key("ctrl+z");
        window_.wait_for("undo", "");
    }

    Json home_;
};

}  // namespace

TEST_F(View, ByHandByKeysAndInEverySizeIsWhatRenderMakes) {
    // Drags that orbit, pan, pan by shift, and zoom.
    window_.drag(window_.pixel(50, 50), window_.pixel(150, 90));
    expect_view_rendered();
    EXPECT_LT(expect_view("orbit")[0][0].get<double>(), -10.0);  // the scene turns with the pointer
    window_.drag(red(), red(70, 33), 2);
    expect_view("pan");
    window_.drag(red(), red(-70, 33), 1, {"shift"});
    expect_view("pan by shift");
    window_.drag(red(), red(0, -80), 3);
    expect_view("zoom");

    // The wheel zooms at the pointer: what is there stays there, here the edge of a sphere and the small one's middle.
    window_.move_to(red(50, 20));
    window_.wheel(3);
    expect_view_rendered();
    expect_view("wheel in");
    window_.move_to(red(50, 20));
    window_.wheel(-3);
    expect_view("wheel out");
    const Place green = window_.on_screen(100.0 / 3, 0);
    window_.move_to(green);
    window_.wait_for("hovered", 1);
    window_.wheel(4);
    window_.wait_for_other("camera", home_);
    window_.move_to({green.x, green.y + 1});
    window_.move_to(green);
    window_.wait_for("hovered", 1);

    // A double click centres.
    window_.double_click(green);
    window_.wait_for("selection", {1});
    window_.wait_until("the green sphere in the middle",
                       [](const Json& f) { return std::abs(f.at("camera")[0][0].get<double>() - 100.0) < 1.0; });
    window_.move_to(red());
    window_.wait_for("hovered", 1);
    expect_view("double click");

    window_.step("sizes of the window");
    for (const auto& [width, height] : {std::pair{701, 751}, std::pair{991, 555}}) {
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
        const Json before = window_.at("picture_size");
        window_.resize(width, height);
        window_.wait_for_other("picture_size", before);
        expect_rendered();
    }

    window_.step("the mark of the area that is exported");
    const Picture plain = window_.picture();
    window_.key("m");
    window_.wait_until("a frame", [&](const Json&) { return !same_picture(window_.picture(), plain); });
    window_.key("m");
    window_.wait_until("no frame", [&](const Json&) { return static_cast<bool>(same_picture(window_.picture(), plain)); });

    window_.step("fits by keys");
    const auto expect_fitted = [&](const std::string& view) { test::expect_rendered(window_, folder_, scene_, {"--view", view}); };
    Json last = home_;
    for (const auto& [key, view] :
         {std::pair{"4", "iso"}, {"shift+1", "back"}, {"shift+2", "left"}, {"shift+3", "bottom"}, {"1", "front"}}) {
        window_.key(key);
        last = window_.wait_for_other("camera", last);
        expect_fitted(view);
    }
    window_.move_to(window_.pixel(20, 20));
    window_.wheel(-1);
    last = window_.wait_for_other("camera", last);
    window_.key("f");  // from where the view is
    window_.wait_for_other("camera", last);
    expect_fitted("front");
    EXPECT_EQ(window_.at("changed"), false);
    window_.key("Home");
    window_.wait_for("camera", home_);

    window_.step("parallel rays by the key");
    window_.key("o");
    window_.wait_for("projection", "orthographic");
    expect_view_rendered();
    window_.key("o");
    window_.wait_for("projection", "perspective");
    window_.key("Home");
    window_.wait_for("camera", home_);

    // A flight ends when anything else is done.
    window_.keys({"4", "Home", "ctrl+a"});
    EXPECT_EQ(window_.wait_for("selection", {0, 1}).at("camera"), home_);
    expect_rendered();
}

TEST_F(View, NumbersOfTheCameraAndSavedViewsAreTheScenes) {
    const auto open_camera = [&] {
        window_.click_widget("camera");
        window_.wait_until("the camera's numbers", [](const Json& f) { return f.at("widgets").contains("slider field of view"); });
    };
    open_camera();
    window_.step("a field of view is typed");
    window_.click_widget("slider field of view");
    window_.widget("typed field of view");
    window_.type("2*(30+10)");
    window_.key("Return");
    window_.wait_for("undo", "Change the field of view");
    expect_rendered();
    window_.key("ctrl+z");
    window_.wait_for("camera", home_);

    window_.step("an eye is dragged");
    const Place from = window_.widget("slider eye x");
    window_.drag(from, {from.x - 25, from.y});
    window_.wait_for("undo", "Move the camera's eye");
    window_.wait_for_other("camera", home_);
    expect_rendered();
    const Json aside = window_.at("camera");

    window_.step("a view is saved, named, left and gone to");
    window_.key("v");
    window_.wait_until("a name's box", [](const Json& f) { return f.at("widgets").contains("view name"); });
    window_.widget("view name");
    window_.type("from aside");
    window_.key("Return");
    window_.wait_for("undo", "Rename view 'view 1'");
    window_.key("4");
    window_.wait_for_other("camera", aside);
    window_.click_widget("menu View");
    window_.click_widget("menu Saved views");
    window_.click_widget("item view 0");
    window_.wait_for("camera", aside);
    window_.key("ctrl+s");
    window_.wait_for("changed", false);
    test::expect_rendered(window_, folder_, scene_, {"--view", "from aside"});
}

TEST(ViewOfData, IsFittedStepsThroughFramesAndFillsALargeScreen) {
    const TemporaryFolder folder;
    const std::string first = "3\n\nO 100 100 100\nH 101 100 100\nH 100 101 100\n";
    const std::string second = "3\n\nN 100 100 100\nH 101 100 100\nH 100 101 100\n";
    const std::string third = "4\n\nN 100 100 100\nH 101 100 100\nH 100 101 100\nH 100 100 101\n";
    const auto height_of_add = [](ViewerWindow& window) {
        const std::vector<double> sides = window.rectangle("add");
        return sides[3] - sides[1];
    };
    double usual = 0.0;
    {
        ViewerWindow window(folder, {folder.write("atoms.xyz", first + second + third), "--frame", "1"});
        usual = height_of_add(window);
        window.step("fit");
        EXPECT_EQ(window.at("frame"), Json({1, 3}));
        const Json camera = window.at("camera");
        window.key("m");
        const std::string second_alone = folder.write("second.xyz", second);
        expect_rendered(window, folder, second_alone, {"--background", "#202430"});
        const Picture nitrogen = window.picture();
        window.key("3");
        window.wait_for_other("camera", camera);
        expect_rendered(window, folder, second_alone, {"--background", "#202430", "--view", "top"});
        window.key("Home");
        window.wait_for("camera", camera);

        window.step("frames by keys, menu and number");
        window.key("Page_Up");
        window.wait_for("frame", {0, 3});
        take_marks_away(window);
        EXPECT_FALSE(same_picture(window.picture(), nitrogen));
        window.key("Page_Up");  // there is none before
        window.click_widget("menu View");
        window.click_widget("menu Frames");
        window.click_widget("item Next frame");
        window.wait_for("frame", {1, 3});
        take_marks_away(window);
        EXPECT_TRUE(same_picture(window.picture(), nitrogen));
        window.key("Page_Down");
        window.wait_for("frame", {2, 3});
        EXPECT_EQ(window.at("spheres"), 4);
        EXPECT_EQ(window.at("camera"), camera);
        EXPECT_EQ(window.at("changed"), false);
        window.click_widget("slider frame");
        window.widget("typed frame");
        window.type("0");
        window.key("Return");
        window.wait_for("frame", {0, 3});
        edit(window);
        window.key("Page_Down");
        answer(window, "save-changes", "Don't save");
        window.wait_for("frame", {1, 3});
        EXPECT_EQ(window.at("spheres"), 3);
    }

    // A scene that has a camera is fitted as a view only, and text is as large as the screen wants it: no panel reaches into
    // the picture.
    const std::string scene = folder.write("scene.txt", two_spheres);
    ViewerWindow window(folder, {scene, "--view", "right"}, {1400, 1000, 192});
    EXPECT_NEAR(height_of_add(window) / usual, 2.0, 0.15);
    window.key("m");
    expect_rendered(window, folder, scene, {"--view", "right"});
    EXPECT_EQ(window.at("changed"), false);
    const Json fitted = window.at("camera");
    window.key("Home");
    window.wait_for_other("camera", fitted);
    expect_rendered(window, folder, scene);
}

// The axes in the corner: a click looks along one, a drag turns the view; the scale bar and the theme are remembered, too.
TEST_F(View, HasAxesThatAreClickedAndDragged) {
    EXPECT_FALSE(window_.draws("axes"));
    window_.key("a");
    window_.wait_until("the axes", [](const Json& f) { return f.at("widgets").contains("axes"); });
    window_.click_widget("axis +x");
    const auto looks_against_x = [](const Json& f) {
        const Json& camera = f.at("camera");
        return std::abs(camera[1][0].get<double>() - camera[0][0].get<double>() + 100.0) < 1e-6;
    };
    window_.wait_until("a view from +x", looks_against_x);
    expect_view("from x");
    const Place middle = window_.widget("axes");
    window_.drag(middle, {middle.x + 20, middle.y + 10});
    EXPECT_LT(expect_view("a drag")[0][0].get<double>(), -10.0) << "the scene turns with the pointer";

    window_.step("exports have them where that is asked for");
    window_.key("F12");
    announced(window_, "scene.png");
    EXPECT_EQ(folder_.read("scene.png"), render_bytes(folder_, scene_, {}));
    window_.key("b");
    window_.key("shift+a");
    window_.key("F12");
    announced(window_, "scene-1.png");
    EXPECT_EQ(folder_.read("scene-1.png"), render_bytes(folder_, scene_, {"--axes", "--scale-bar"}));

    window_.step("a light theme");
    const auto panel_brightness = [&] { return window_.server().screen().at(window_.server().screen().width - 3, 500)[1]; };
    EXPECT_LT(panel_brightness(), 60);
    window_.key("ctrl+t");
    ASSERT_TRUE(eventually([&] { return panel_brightness() > 200; }));
    window_.key("ctrl+q");
    EXPECT_EQ(window_.wait_for_end().status, 0);
    const Json settings = Json::parse(folder_.read("home/config/sphereview/viewer.json"));
    for (const char* on : {"axes", "scale_bar", "marks_in_exports", "light_theme"}) EXPECT_EQ(settings.at(on), true) << on;
}

TEST_F(View, MeasuresBetweenSpheresThatAreClicked) {
    window_.key("d");
    window_.wait_until("measuring", [](const Json& f) { return f.at("widgets").contains("measuring"); });
    window_.click(red());
    window_.wait_for("measured", Json::array({0}));
    window_.click(window_.on_screen(100.0 / 3, 0));
    window_.wait_for("measured", Json({0, 1}));
    EXPECT_EQ(window_.at("selection"), Json::array()) << "a click selects nothing here";
    // A drag orbits as ever.
    window_.drag(red(), red(40, 0));
    window_.wait_for_other("camera", home_);
    EXPECT_EQ(window_.at("measured"), Json({0, 1}));
    window_.key("Escape");
    window_.wait_for("measured", Json::array());
    EXPECT_FALSE(window_.draws("measuring"));
    window_.click(red());
    window_.wait_for("selection", Json::array({0}));
}

TEST_F(View, TheWindowHasAnIconAndTellsOfItself) {
    EXPECT_EQ(window_.server().icon_pixels(), 16U * 16U + 32U * 32U + 48U * 48U + 64U * 64U);
    window_.key("shift+F1");
    window_.wait_until("About", [](const Json& f) { return f.at("widgets").contains("about"); });
    window_.key("Escape");
    window_.wait_until("no About", [](const Json& f) { return !f.at("widgets").contains("about"); });
}

}  // namespace sphereview::test
