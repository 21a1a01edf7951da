// The window's light: lit and fine without being asked, edited in its panel, and at rest the very bytes of `render`.
#include <gtest/gtest.h>

#include "support/text_match.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

constexpr ScreenOptions small_screen{.width = 700, .height = 800};  // light takes long for each pixel

// Whether a draft was shown of a picture that was then finished.
bool grew(const TemporaryFolder& folder) {
    bool draft = false;
    for (const Json& redraw : logged_redraws(folder)) {
        if (draft && redraw.at("exact") == true) return true;
        draft = draft || !redraw.at("draft").is_null();
    }
    return false;
}

}  // namespace

// Nobody has chosen anything yet; the command line has a sun.
TEST(Light, StudioWith16SamplesIsTheDefaultAndGrowsToTheExport) {
    const TemporaryFolder folder;
    folder.write("home/config/sphereview/viewer.json", R"({"axes": false})");
    const std::string scene = folder.write("scene.txt", two_spheres);
    ViewerWindow window(folder, {scene, "--sun", "1,2,-3", "--sky", "0.5", "--lights", "64", "--size", "100x100"}, small_screen);
    window.key("m");
    window.wait_until("the default",
                      [](const Json& f) { return f.at("shading") == "studio" && f.at("samples") == 16 && f.at("exact") == true; });
    expect_rendered(window, folder, scene, {"--sun", "1,2,-3", "--sky", "0.5", "--lights", "64"});
    EXPECT_TRUE(grew(folder));
    window.step("F12 shows what the window shows");
    window.key("F12");
    announced(window, "scene.png (100 x 100, 16 samples a pixel)");
    EXPECT_EQ(folder.read("scene.png"), render_bytes(folder, scene,
                                                     {"-s", "100x100", "--shade", "studio", "--samples", "16", "--sun", "1,2,-3",
                                                      "--sky", "0.5", "--lights", "64"}));
    window.step("the sun's ray in the inspector");
    window.key("i");
    window.wait_until("the inspector", [](const Json& f) { return f.at("shown").at("inspector") == true; });
    window.move_to(window.on_screen(33, 0));  // the green sphere
    window.wait_until("the ray", [](const Json& f) { return f.at("widgets").contains("light ray"); });
}

TEST(Light, WithoutASunTheInspectorFollowsTheRayToTheSkysStrongestLight) {
    const TemporaryFolder folder;
    folder.write("home/config/sphereview/viewer.json", R"({"axes": false})");
    ViewerWindow window(folder, {folder.write("scene.txt", two_spheres), "--lights", "16", "--size", "100x100"}, small_screen);
    window.key("i");
    window.wait_until("the inspector", [](const Json& f) { return f.at("shown").at("inspector") == true; });
    window.move_to(window.on_screen(33, 0));  // the green sphere
    window.wait_until("the ray", [](const Json& f) { return f.at("widgets").contains("light ray"); });
}

class LightPanel : public Editing {
protected:
    LightPanel() : Editing("scene.toml", small_screen) {}
};

TEST_F(LightPanel, MovesTheSunInOneStepThatIsSaved) {
    window_.key("ctrl+6");
    window_.wait_for("shading", "studio");
    window_.click_widget("light");
    window_.click_widget("lights");  // few first: each step waits for its picture
    window_.click_widget("lights 16");
    window_.wait_for("undo", "Change the number of lights");
    window_.click_widget("sun");
    window_.wait_for("undo", "Switch the sun on");
    const Place middle = window_.widget("sun ball");
    window_.drag(middle, {middle.x - 20, middle.y + 10});
    window_.wait_for("undo", "Move the sun");
    expect_rendered();
    const std::string saved = folder_.read(name_);
    EXPECT_TRUE(contains(saved, "[light]\nlights = 16\nsun = [")) << saved;
    window_.step("another strength, of lights that were decided before");
    window_.drag(window_.widget("slider sky", 0.3), window_.widget("slider sky", 0.8));
    window_.wait_for("undo", "Change the sky");
    expect_rendered();
    window_.key("ctrl+z");
    window_.wait_for("undo", "Move the sun");
    expect_rendered();
    for (const char* step : {"Switch the sun on", "Change the number of lights", ""}) {
        window_.key("ctrl+z");
        window_.wait_for("undo", step);
    }
    window_.key("ctrl+1");
    window_.wait_for("shading", "flat");
    expect_rendered();
    EXPECT_FALSE(contains(folder_.read(name_), "[light]"));
}

}  // namespace sphereview::test
