#include <gtest/gtest.h>

#include "panels/inspector.hpp"
#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

constexpr PictureSize size{101, 101};  // pixel (50, 50) looks along +z

// A base, so that it is there when PanelHarness draws for the first time.
struct HeldPixel {
    std::optional<InspectedPixel> pixel;
};

class InspectorHarness : private HeldPixel, public PanelHarness {
public:
    explicit InspectorHarness(const Scene& scene)
        : HeldPixel{InspectedPixel{{{50, 50}, size, scene.camera, 0},
                                   explain_pixel(scene, drawn_spheres(scene), scene.camera, size, {50, 50})}},
          PanelHarness(drawn(), scene) {}
    InspectorHarness() : PanelHarness(drawn()) {}
    using HeldPixel::pixel;

private:
    Draw drawn() {
        return in_window([this](const PanelContext& context) { draw_inspector(context, pixel); }, 460.0F, 600.0F);
    }
};

Scene of(std::vector<Sphere> spheres) {
    Scene scene;
    scene.spheres = std::move(spheres);
    return scene;
}

void expect_in_order(const std::string& text, const std::vector<std::string>& parts) {
    std::size_t place = 0;
    for (const std::string& part : parts) {
        const std::size_t found = text.find(part, place);
        ASSERT_NE(found, std::string::npos) << "\"" << part << "\" is missing, or too early, in:\n" << text;
        place = found + part.size();
    }
}

TEST(Inspector, ShowsTheFormulaeAndTheHitsInOrder) {
    Scene scene =
        of({{{0.0, 0.0, 400.0}, 20.0}, {{0.0, 0.0, 200.0}, 20.0}, {{0.0, 90.0, 200.0}, 20.0}, {{0.0, 0.0, -200.0}, 20.0}});
    scene.spheres.push_back({{0.0, 0.0, 100.0}, 5.0, {}, true});
    scene.names[1] = "sun";
    InspectorHarness panel(scene);
    expect_in_order(panel.text(), {"pixel 50, 50 of 101 x 101",
                                   "P = O + t D",
                                   "O = (0, 0, 0)",
                                   "D = (0, 0, 100)",
                                   "D.D t^2 + 2 D.(O - C) t + (O - C).(O - C) - r^2 = 0",
                                   "'sun'",
                                   "seen",
                                   "a = 10000",
                                   "b = -40000",
                                   "c = 39600",
                                   "discriminant = 1.6e+07  > 0: two roots",
                                   "t1 = 1.8",
                                   "t2 = 2.2",
                                   "t1, counts",
                                   "t = 1.8",
                                   "point = (0, 0, 180)",
                                   "normal = (0, 0, -1)",
                                   "sphere 0",
                                   "t1 = 3.8",
                                   "1 missed: discriminant < 0",
                                   "1 behind the eye",
                                   "1 hidden",
                                   "Decided: "});
    EXPECT_TRUE(panel.has("hit 1"));
    EXPECT_LT(panel.place("hit 1").y, panel.place("hit 0").y);
    EXPECT_TRUE(panel.take_actions().empty());
}

TEST(Inspector, ShowsWhatIsSpecialAboutARay) {
    Scene white = of({{{0.0, 90.0, 200.0}, 20.0}});
    white.background = {{255, 255, 255}, false};
    const std::vector<std::pair<Scene, std::vector<std::string>>> cases = {
        {of({{{20.0, 0.0, 200.0}, 20.0}}),
         {"discriminant = 0  = 0 exactly: tangent, one root", "the ray is tangent", "t = 2", "only exact"}},
        {of({{{0.0, 0.0, 10.0}, 50.0}}), {"seen", "t1 = -0.4", "t2 = 0.6", "the eye is inside the sphere", "t = 0.6"}},
        {white, {"No hit: the pixel shows the background, white.", "1 missed"}},
        {of({{{0.0, 0.0, 200.0}, 20.0}, {{0.0, 0.0, 210.0}, 30.0}}), {"sphere 0", "seen", "sphere 1", "exactly as near"}}};
    for (const auto& [scene, words] : cases) expect_in_order(InspectorHarness(scene).text(), words);
}

TEST(Inspector, ShowsTheNearestOfManyHits) {
    Scene scene;
    for (int i = 0; i < 500; ++i) scene.spheres.push_back({{0.0, 0.0, 200.0 + i}, 50.0});
    InspectorHarness panel(scene);
    expect_in_order(panel.text(), {"sphere 0", "seen", "sphere 19", "and 480 more hits"});
    EXPECT_EQ(panel.text().find("sphere 20"), std::string::npos);
}

TEST(Inspector, CountsWhatWasNotTried) {
    InspectorHarness panel(of({{{0.0, 0.0, 200.0}, 20.0}}));
    EXPECT_EQ(panel.text().find("elsewhere"), std::string::npos);
    panel.pixel->explanation.elsewhere = 1000;
    EXPECT_NE(panel.text().find("elsewhere or behind the eye: not hit"), std::string::npos);
}

TEST(Inspector, SaysWhereParallelRaysDoNotGo) {
    Scene scene = of({{{0.0, 0.0, 200.0}, 20.0}, {{0.0, 0.0, -200.0}, 20.0}});
    scene.camera.projection = Projection::orthographic;
    InspectorHarness panel(scene);
    expect_in_order(panel.text(), {"sphere 0", "1 behind where the ray begins: no positive root"});
    panel.pixel->explanation.elsewhere = 1000;
    EXPECT_NE(panel.text().find("elsewhere or behind where the ray begins: not hit"), std::string::npos);
}

TEST(Inspector, AsksForAPixel) {
    InspectorHarness panel;
    EXPECT_NE(panel.text().find("Point at the picture"), std::string::npos);
}

TEST(Inspector, LeavesOutSpheresThatAreGone) {
    InspectorHarness panel(of({{{0.0, 0.0, 200.0}, 20.0}, {{0.0, 0.0, 300.0}, 20.0}}));
    panel.document.apply(RemoveSpheres{{1}}, "");
    EXPECT_EQ(panel.text().find("sphere 1"), std::string::npos);
}

TEST(Inspector, FollowsTheRayToTheSun) {
    InspectorHarness panel(of({{{0.0, 0.0, 200.0}, 20.0}}));
    EXPECT_EQ(panel.text().find("sun"), std::string::npos);
    panel.pixel->place.sun = Sun{{1.0, 2.0, -3.0}, 1.0};
    panel.pixel->sun = "does not shine: so it is";
    expect_in_order(panel.text(), {"normal = ", "sun: L = (1, 2, -3)", "The sun does not shine: so it is."});
}

}  // namespace

}  // namespace sphereview
