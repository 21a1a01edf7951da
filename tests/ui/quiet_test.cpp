// Nothing is drawn when nothing changes; text is as large as the screen wants it.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <thread>

#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

using Quiet = Editing;

}  // namespace

TEST_F(Quiet, AnIdleWindowDrawsNothing) {
    const Json last = take_marks_away().at("frame");
    const double before = window_.processor_seconds();
    constexpr double seconds = 3.0;
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    EXPECT_EQ(window_.frame().at("frame"), last);
    EXPECT_LT(window_.processor_seconds() - before, 0.03 * seconds);
}

TEST(LargeScreen, HasLargeTextAroundTheWholePicture) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", two_spheres);
    const auto height_of_add = [&](ViewerWindow& window) {
        const Json r = window.frame().at("widgets").at("add");
        return r[3].get<double>() - r[1].get<double>();
    };
    double usual = 0.0;
    {
        ViewerWindow window(folder, {scene});
        usual = height_of_add(window);
    }
    ViewerWindow window(folder, {scene}, {2400, 1600, 192});
    EXPECT_NEAR(height_of_add(window) / usual, 2.0, 0.15);
    window.key("m");
    window.move_to({5, 5});
    window.wait_until("the picture alone", [](const Json& f) { return f.at("hovered").is_null() && f.at("exact") == true; });
    EXPECT_TRUE(same_picture(window.picture(), rendered(folder, scene, window.frame()))) << "no panel reaches into the picture";
}

}  // namespace sphereview::test
