// The pixel inspector in a real window: beside the picture, pinned, compared, copied; and pictures that are compared.
#include <gtest/gtest.h>

#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

class InspectorWindow : public Editing {
protected:
    InspectorWindow() {
        window_.key("i");
        window_.wait_until("the inspector", [](const Json& f) { return f.at("shown").at("inspector") == true; });
    }
    Json inspected() { return window_.at("inspected"); }
    void wait_for_inspected(const std::string& what, const std::function<bool(const Json&)>& holds) {
        window_.wait_until(what, [&](const Json& f) { return !f.at("inspected").is_null() && holds(f.at("inspected")); });
    }
};

}  // namespace

TEST_F(InspectorWindow, IsBesideThePictureAndHoldsWhatIsPinned) {
    window_.step("it follows the pointer, and stays when that comes to read");
    const double left = window_.at("picture")[0].get<double>();
    EXPECT_GT(left, 200.0);
    window_.move_to(red(20, 10));
    const Json size = window_.at("picture_size");
    const Json pixel = {size[0].get<int>() / 2 + 20, size[1].get<int>() / 2 + 10};
    wait_for_inspected("the red sphere", [&](const Json& i) { return i.at("visible") == 0 && i.at("pixel") == pixel; });
    EXPECT_EQ(inspected().at("pinned"), false);
    window_.move_to(window_.widget("hit 0"));
    window_.wait_until("the pointer has left the picture", [](const Json& f) { return f.at("hovered").is_null(); });
    EXPECT_EQ(inspected().at("pixel"), pixel);
    EXPECT_LT(window_.rectangle("ray drawing")[2], left);

    window_.step("the wheel scrolls it");
    const double top = window_.rectangle("hit 0")[1];
    window_.wheel(-2);
    window_.wait_until("it scrolled", [&](const Json& f) { return f.at("widgets").at("hit 0")[1].get<double>() < top - 10.0; });

    window_.step("a click pins, with a mark; the pointer is free");
    window_.click(red(20, 10));
    wait_for_inspected("a pin", [](const Json& i) { return i.at("pinned") == true; });
    const Json pinned = inspected().at("pixel");
    window_.move_to(red(90, 0));
    window_.wait_for("hovered", 1);
    EXPECT_EQ(inspected().at("pixel"), pinned);
    const Place mark = window_.pixel(pinned[0].get<double>() + 8, pinned[1].get<double>());
    const Picture screen = window_.server().screen();
    EXPECT_EQ(screen.at(static_cast<int>(mark.x), static_cast<int>(mark.y)), (std::vector{255, 220, 90}));

    window_.step("a second pixel");
    window_.key_down("shift");
    window_.click(red(90, 0));
    window_.key_up("shift");
    wait_for_inspected("a second", [](const Json& i) { return !i.at("second").is_null(); });
    EXPECT_TRUE(window_.draws("compared"));
    window_.click_widget("copy explanation");
    announced(window_, "Copied the arithmetic of pixel " + std::to_string(pinned[0].get<int>()));

    window_.step("it moves live with the sphere");
    const double explanations = window_.at("explanations").get<double>();
    window_.key("Insert");
    window_.wait_for("spheres", 3);
    window_.wait_until("other numbers", [&](const Json& f) { return f.at("explanations").get<double>() > explanations; });
    window_.key("ctrl+z");
    window_.wait_for("spheres", 2);

    window_.step("Escape lets go, one after the other, and Space pins");
    window_.key("Escape");
    wait_for_inspected("one pixel", [](const Json& i) { return i.at("second").is_null() && i.at("pinned") == true; });
    window_.key("Escape");
    wait_for_inspected("none", [](const Json& i) { return i.at("pinned") == false; });
    window_.move_to(red(0, 30));
    window_.key("space");
    wait_for_inspected("the pixel under the pointer",
                       [&](const Json& i) { return i.at("pinned") == true && i.at("pixel") != pinned; });

    window_.step("its edge is dragged");
    const Place edge = window_.widget("inspector splitter");
    window_.drag(edge, {edge.x - 60, edge.y});
    window_.wait_until("a narrower inspector", [&](const Json& f) { return f.at("picture")[0].get<double>() == left - 60.0; });
    window_.click_widget("close inspector");
    window_.wait_until("no inspector", [](const Json& f) { return f.at("shown").at("inspector") == false; });
    window_.key("ctrl+s");
    window_.wait_for("changed", false);
    expect_rendered();
}

// The eye is in all of them: every ray hits every one, and they are compared exactly.
TEST(InspectorOfManyHits, ExplainsBesideTheLoop) {
    constexpr int many = 1'500;
    std::string text = std::to_string(many) + "\n";
    for (int i = 0; i < many; ++i) text += "99 9 0  0 0 0 " + std::to_string(1000 + many - i) + "\n";
    const TemporaryFolder folder;
    ViewerWindow window(folder, {folder.write("scene.txt", text)});
    window.key("i");
    window.wait_until("the inspector", [](const Json& f) { return f.at("shown").at("inspector") == true; });
    for (const double x : {100.0, 150.0}) {
        window.move_to(window.pixel(x, 100));
        window.wait_until("the last sphere is the nearest", [&](const Json& f) {
            const Json& inspected = f.at("inspected");
            return !inspected.is_null() && inspected.at("pixel")[0] == x && inspected.at("visible") == many - 1;
        });
    }
    EXPECT_TRUE(window.draws("hit " + std::to_string(many - 1)));
    bool meanwhile = false;  // a redraw of a pixel that is not explained yet
    for (const Json& redraw : logged_redraws(folder)) {
        meanwhile = meanwhile || (redraw.at("shown").at("inspector") == true && !redraw.at("hovered").is_null() &&
                                  redraw.at("inspected").is_null());
    }
    EXPECT_TRUE(meanwhile);
}

TEST_F(Editing, APictureIsComparedInTheWindow) {
    const Picture right = decode_png(render_bytes(folder_, scene_, {"-s", "90x60"}));
    std::string bytes = "P6\n90 60\n255\n";
    for (int row = 0; row < 60; ++row) {
        for (int column = 90; column-- > 0;) bytes += right.bytes.substr(static_cast<std::size_t>(row * 90 + column) * 3, 3);
    }
    const std::string mine = folder_.write("mine.ppm", bytes);
    window_.choose("File", "Compare with picture...");
    choose_file(window_, mine);
    window_.wait_until("the comparison", [](const Json& f) { return f.at("widgets").contains("difference"); });
    EXPECT_TRUE(contains(window_.at("comparison").get<std::string>(), "x is mirrored"));
    window_.drag(red(0, 100), red(60, 120));
    window_.wait_for("selection", Json::array());
    window_.click_widget("example 0");
    window_.wait_until("the example", [](const Json& f) {
        return !f.at("inspected").is_null() && f.at("inspected").at("size") == Json({90, 60}) &&
               f.at("inspected").at("pinned") == true;
    });
    EXPECT_EQ(window_.at("shown").at("inspector"), true);
    // The scene's own camera, which the picture was compared by.
    EXPECT_EQ(window_.at("camera")[0], Json({0.0, 0.0, 0.0}));
}

}  // namespace sphereview::test
