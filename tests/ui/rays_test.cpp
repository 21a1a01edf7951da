// The rays in space, in a real window.
#include <gtest/gtest.h>

#include <cmath>

#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

class RaysWindow : public Editing {
protected:
    RaysWindow() : eye_(window_.at("camera")) {
        window_.key("r");
        window_.wait_until("the rays from beside", [this](const Json& f) {
            return !f.at("rays").is_null() && f.at("rays").at("picture") == true && f.at("camera") != eye_;
        });
    }

    void wait_for_pin(const Json& pixel) {
        window_.wait_until("the pinned pixel", [&](const Json& f) {
            return !f.at("inspected").is_null() && f.at("inspected").at("pinned") == true && f.at("inspected").at("pixel") == pixel;
        });
    }

    Json eye_;
};

int distance(const std::vector<int>& a, const std::vector<int>& b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

// Whether the screen shows about that colour within some pixels of a place.
bool shows_near(const Picture& screen, const Place& place, const std::vector<int>& color, int reach = 4) {
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            if (distance(screen.at(static_cast<int>(place.x) + x, static_cast<int>(place.y) + y), color) < 60) return true;
        }
    }
    return false;
}

}  // namespace

TEST_F(RaysWindow, ShowTheEyesRaysFromBesideAndGoBack) {
    window_.step("the picture that the eye sees pins pixels");
    const Json size = window_.at("rays").at("size");
    window_.click(window_.widget("rays picture"));
    window_.wait_until("a pin on the red sphere", [](const Json& f) {
        return !f.at("inspected").is_null() && f.at("inspected").at("pinned") == true && f.at("inspected").at("visible") == 0;
    });
    EXPECT_EQ(window_.at("inspected").at("size"), size);
    EXPECT_EQ(window_.at("selection"), Json::array()) << "a panel's picture selects nothing";

    window_.step("the window shows the second view, as any renderer makes it, and the ray over it");
    const std::vector<int> ray_color{255, 220, 90};
    const auto ray_end = [&] { return window_.at("rays").at("end"); };
    ASSERT_FALSE(ray_end().is_null());
    window_.move_to({5, 5});
    window_.wait_for("hovered", nullptr);
    const Json first_end = ray_end();
    EXPECT_TRUE(
        shows_near(window_.server().screen(), window_.pixel(first_end[0].get<double>(), first_end[1].get<double>()), ray_color));

    window_.step("a drag orbits, and the ray's end moves with the sphere");
    const Json camera = window_.at("camera");
    const Json picture = window_.at("picture");
    const Place below{picture[0].get<double>() + 0.5 * picture[2].get<double>(),
                      picture[1].get<double>() + 0.95 * picture[3].get<double>()};
    window_.drag(below, {below.x - 90, below.y - 20});
    window_.wait_for_other("camera", camera);
    EXPECT_NE(ray_end(), first_end);
    EXPECT_EQ(window_.at("rays").at("eye"), eye_[0]) << "the eye stays";
    window_.move_to({5, 5});
    window_.wait_for("hovered", nullptr);
    const Json end = ray_end();
    EXPECT_TRUE(shows_near(window_.server().screen(), window_.pixel(end[0].get<double>(), end[1].get<double>()), ray_color));

    window_.step("every n-th ray of all");
    window_.click_widget("rays all");
    window_.wait_until("all rays", [](const Json& f) { return f.at("rays").at("rays").get<int>() > 100; });
    const int hits = window_.at("rays").at("hits").get<int>();
    EXPECT_GT(hits, 5);
    window_.key("Insert");
    window_.wait_for("spheres", 3);
    window_.wait_until("more hits", [&](const Json& f) { return f.at("rays").at("hits").get<int>() != hits; });
    window_.key("ctrl+z");
    window_.wait_until("as before", [&](const Json& f) { return f.at("rays").at("hits") == hits; });

    window_.step("Escape lets the pixel go, then goes back");
    window_.key("Escape");
    window_.wait_until("no pin", [](const Json& f) { return f.at("inspected").at("pinned") == false; });
    EXPECT_EQ(window_.at("shown").at("rays"), true);
    window_.key("Escape");
    window_.wait_until("the eye's view", [this](const Json& f) { return f.at("rays").is_null() && f.at("camera") == eye_; });
    take_marks_away(window_);
    expect_rendered();
}

}  // namespace sphereview::test
