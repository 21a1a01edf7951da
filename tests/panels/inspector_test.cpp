#include <gtest/gtest.h>

#include <algorithm>

#include "panels/inspector.hpp"
#include "support/panel_harness.hpp"
#include "support/spheres.hpp"

namespace sphereview {

namespace {

constexpr PictureSize size{101, 101};  // pixel (50, 50) looks along +z

InspectedPixel inspected(const Scene& scene, Pixel pixel = {50, 50}) {
    return {
        {pixel, size, scene.camera, 0},
        explain_pixel(scene, drawn_spheres(scene), scene.camera, size, pixel, nullptr, most_hits_explained, most_passed_explained)};
}

// A base, so that it is there when PanelHarness draws for the first time.
struct HeldPixel {
    Inspection inspection;
    InspectorState state;
};

class InspectorHarness : private HeldPixel, public PanelHarness {
public:
    explicit InspectorHarness(const Scene& scene)
        : HeldPixel{{.first = inspected(scene)}, {}}, PanelHarness(drawn(), scene, 800.0F, 1200.0F) {}
    InspectorHarness(const Scene& scene, float width)
        : HeldPixel{{.first = inspected(scene)}, {}}, PanelHarness(drawn(width), scene, 800.0F, 1200.0F) {}
    InspectorHarness() : PanelHarness(drawn()) {}
    using HeldPixel::inspection;
    using HeldPixel::state;
    InspectedPixel& pixel() { return *inspection.first; }

private:
    Draw drawn(float width = 460.0F) {
        return in_window([this](const PanelContext& context) { draw_inspector(context, inspection, state); }, width, 1150.0F);
    }
};

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
        scene_of({{{0.0, 0.0, 400.0}, 20.0}, {{0.0, 0.0, 200.0}, 20.0}, {{0.0, 90.0, 200.0}, 20.0}, {{0.0, 0.0, -200.0}, 20.0}});
    scene.spheres.push_back({{0.0, 0.0, 100.0}, 5.0, {}, true});
    scene.names[1] = "sun";
    InspectorHarness panel(scene);
    // In ASCII where the font, here ImGui's own, has no sign.
    expect_in_order(panel.text(), {"Pixel 50, 50 of 101 \u00D7 101",
                                   "shows sphere 1 'sun'",
                                   "The plane through the ray and the centre C of sphere 1 'sun'",
                                   "P = O + t D",
                                   "O = (0, 0, 0)",
                                   "D = (0, 0, 100)",
                                   "D\u00B7D t\u00B2 + 2 D\u00B7(O - C) t + (O - C)\u00B7(O - C) - r\u00B2 = 0",
                                   "sqrt(b\u00B2 - 4ac)",
                                   "'sun'",
                                   "seen",
                                   "a = D\u00B7D = 10000",
                                   "= -40000",
                                   "= 39600",
                                   "b\u00B2 - 4ac = 16000000  > 0: two roots",
                                   "t1 = 1.8",
                                   "t2 = 2.2",
                                   "t1,",
                                   "t = 1.8",
                                   "P = O + t D = (0, 0, 180)",
                                   "n = (P - C) / r = (0, 0, -1)",
                                   "sphere 0",
                                   "t1 = 3.8",
                                   "sphere 2",
                                   "missed",
                                   "< 0: no root",
                                   "at a distance of 90",
                                   "sphere 3",
                                   "behind the eye",
                                   "t1 = -2.2, t2 = -1.8",
                                   "1 missed: discriminant < 0",
                                   "1 behind the eye",
                                   "1 hidden",
                                   "Decided: "});
    EXPECT_TRUE(panel.has("hit 1"));
    EXPECT_LT(panel.place("hit 1").y, panel.place("hit 0").y);
    EXPECT_TRUE(panel.take_actions().empty());
}

TEST(Inspector, ShowsWhatIsSpecialAboutARay) {
    Scene white = scene_of({{{0.0, 90.0, 200.0}, 20.0}});
    white.background = {{255, 255, 255}, false};
    const std::vector<std::pair<Scene, std::vector<std::string>>> cases = {
        {scene_of({{{20.0, 0.0, 200.0}, 20.0}}), {"4ac = 0  = 0 exactly: tangent, one root", "tangent", "t = 2", "only exact"}},
        {scene_of({{{0.0, 0.0, 10.0}, 50.0}}), {"seen", "t1 = -0.4", "t2 = 0.6", "the eye is inside", "t = 0.6"}},
        {white, {"No hit: the pixel shows the background, white.", "missed", "1 missed"}},
        {scene_of({{{0.0, 0.0, 200.0}, 20.0}, {{0.0, 0.0, 210.0}, 30.0}}), {"sphere 0", "seen", "sphere 1", "exactly as", "near"}}};
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
    InspectorHarness panel(scene_of({{{0.0, 0.0, 200.0}, 20.0}}));
    EXPECT_EQ(panel.text().find("in all"), std::string::npos);
    panel.pixel().explanation.elsewhere = 1000;
    panel.pixel().explanation.missed = 7;
    EXPECT_NE(panel.text().find("in all 1,007 not hit: missed, or behind the eye"), std::string::npos) << panel.text();
}

TEST(Inspector, SaysWhereParallelRaysDoNotGo) {
    Scene scene = scene_of({{{0.0, 0.0, 200.0}, 20.0}, {{0.0, 0.0, -200.0}, 20.0}});
    scene.camera.projection = Projection::orthographic;
    InspectorHarness panel(scene);
    expect_in_order(panel.text(), {"sphere 0", "1 behind where the ray begins: no positive root"});
    panel.pixel().explanation.elsewhere = 1000;
    EXPECT_NE(panel.text().find("in all 1,001 not hit: missed, or behind where the ray begins"), std::string::npos);
}

TEST(Inspector, AsksForAPixel) {
    InspectorHarness panel;
    EXPECT_NE(panel.text().find("Point at the picture"), std::string::npos);
}

TEST(Inspector, LeavesOutSpheresThatAreGone) {
    InspectorHarness panel(scene_of({{{0.0, 0.0, 200.0}, 20.0}, {{0.0, 0.0, 300.0}, 20.0}}));
    panel.document.apply(RemoveSpheres{{1}}, "");
    EXPECT_EQ(panel.text().find("sphere 1"), std::string::npos);
}

TEST(Inspector, FollowsTheRayToTheSun) {
    InspectorHarness panel(scene_of({{{0.0, 0.0, 200.0}, 20.0}}));
    EXPECT_EQ(panel.text().find("sun"), std::string::npos);
    panel.pixel().light = InspectedLight{.number = 0, .direction = {1.0, 2.0, -3.0}, .why = "does not shine: so it is"};
    expect_in_order(panel.text(),
                    {"n = ", "from the point P to the sun", "sun: L = (1, 2, -3)", "The sun does not shine: so it is."});
    EXPECT_EQ(panel.text().find("sky"), std::string::npos);
}

TEST(Inspector, FollowsTheRayToALightOfTheSky) {
    InspectorHarness panel(scene_of({{{0.0, 0.0, 200.0}, 20.0}, {{90.0, 0.0, 200.0}, 20.0}}));
    panel.pixel().light = InspectedLight{.number = 17, .direction = {1.0, 2.0, -3.0}, .why = "is kept away", .blocker = 1};
    panel.pixel().sky = "3 of 5 lights shine";
    expect_in_order(panel.text(), {"from the point P to the light: sphere 1 is in the way.", "light 17: L = (1, 2, -3)",
                                   "the nearest to the key light", "It is kept away.", "sky: 3 of 5 lights shine."});
    EXPECT_EQ(panel.text().find("sun"), std::string::npos);
}

TEST(Inspector, ShowsHowTheColourOfALitPixelComesAbout) {
    InspectorHarness panel(scene_of({{{0.0, 0.0, 200.0}, 20.0, {200, 100, 50}}}));
    EXPECT_EQ(panel.text().find("B = "), std::string::npos);
    panel.pixel().light = InspectedLight{.number = 0, .direction = {0.0, 0.0, -1.0}, .shines = true, .why = "shines"};
    // Light of strength 0.8 from the eye: 1.8 * 0.8 / 1.6 = 0.9.
    const LightVector sum{0, 0, -static_cast<std::int32_t>(0.8 * light_one)};
    panel.pixel().color = explain_color(panel.document.scene(), Camera{}, size, {50, 50}, panel.pixel().explanation.hits.front(),
                                        {0.0, 0.0, 100.0}, sum);
    EXPECT_EQ(panel.pixel().color->shown, (Color{180, 90, 45}));
    expect_in_order(panel.text(), {"B = (0, 0, -0.8), the sum of the lights that shine", "E = n·B = 0.8",
                                   "s = 1.8 E / (0.8 + E) = 0.9", "colour = s times 200 100 50 = 180 90 45"});
    EXPECT_TRUE(panel.has("lit colour"));
    panel.pixel().color = ColorExplanation{};
    expect_in_order(panel.text(), {"B = (0, 0, 0)", "no light shines there: black"});
}

TEST(Inspector, IsAskedByItsButtons) {
    const Scene scene = scene_of({{{0.0, 0.0, 200.0}, 20.0}});
    InspectorHarness panel(scene);
    panel.click("unpin");
    EXPECT_EQ(panel.taken<InspectorWish>(), std::vector{InspectorWish::pin});
    panel.click("compare pixels");  // with nothing pinned there is nothing to compare with
    EXPECT_TRUE(panel.take_actions().empty());
    panel.inspection.pinned = true;
    for (const char* widget : {"unpin", "compare pixels", "copy explanation"}) panel.click(widget);
    EXPECT_EQ(panel.taken<InspectorWish>(), (std::vector{InspectorWish::unpin, InspectorWish::compare, InspectorWish::copy}));
    panel.click("close inspector");
    EXPECT_EQ(panel.taken<RunCommand>().at(0).command, CommandId::toggle_inspector);
}

TEST(Inspector, ComparesTwoPixels) {
    const Scene scene = scene_of({{{0.0, 0.0, 200.0}, 20.0}});
    InspectorHarness panel(scene);
    panel.inspection.pinned = true;
    panel.inspection.second = inspected(scene, {0, 0});
    expect_in_order(panel.text(), {"1: 50, 50", "2: 0, 0", "sphere 0", "the background", "40000", "Pixel 50, 50"});
    panel.click("detail 2");
    expect_in_order(panel.text(), {"1: 50, 50", "Pixel 0, 0", "No hit"});
    panel.click("copy explanation");
    EXPECT_EQ(panel.taken<InspectorWish>(), std::vector{InspectorWish::copy_second});
}

TEST(Inspector, DrawsTheSphereThatWasClicked) {
    InspectorHarness panel(scene_of({{{0.0, 0.0, 200.0}, 20.0}, {{0.0, 0.0, 300.0}, 20.0}}));
    EXPECT_NE(panel.text().find("centre C of sphere 0"), std::string::npos);
    panel.click("hit 1");
    EXPECT_NE(panel.text().find("centre C of sphere 1"), std::string::npos);
    // The first sphere, in the drawing: its circle is at the left of the other's.
    panel.click(panel.place("quadratic drawing", 0.5F, 0.98F));
    panel.inspection.first = inspected(scene_of({{{0.0, 0.0, 200.0}, 20.0}}));
    EXPECT_NE(panel.text().find("centre C of sphere 0"), std::string::npos) << "one that is not explained cannot be chosen";
}

// By how much a ray passes a sphere is written on the other side of the ray.
TEST(Inspector, AGapIsWrittenBesideTheSphere) {
    for (const double side : {-1.0, 1.0}) {
        InspectorHarness panel(scene_of({{{0.0, side * 90.0, 300.0}, 40.0}}), 460.0F);
        panel.redraws(2);
        ASSERT_TRUE(panel.has("ray drawing text C"));
        const WidgetRectangle center = panel.rectangles.at("ray drawing text C");
        const auto is_gap = [](const auto& named) { return named.first.starts_with("ray drawing text misses by"); };
        const auto gap = std::ranges::find_if(panel.rectangles, is_gap);
        ASSERT_NE(gap, panel.rectangles.end());
        const WidgetRectangle drawing = panel.rectangles.at("ray drawing");
        // The ray, the sphere's edge, its centre: one below the other.
        if (side < 0.0) {
            EXPECT_LT(gap->second.bottom, center.top - 0.2F * (drawing.bottom - drawing.top));
        } else {
            EXPECT_GT(gap->second.top, center.bottom + 0.2F * (drawing.bottom - drawing.top));
        }
    }
}

// Whatever the width and the text's size, what is written in the drawings stands apart, from points as well, and what matters most
// is there.
TEST(Inspector, NothingIsWrittenOverATextOrAPointOfADrawing) {
    Scene scene = scene_of({{{0.0, 0.0, 200.0}, 20.0}, {{0.0, 30.0, 300.0}, 20.0}, {{9e4, 0.0, 1e5}, 1.0}});
    for (const float text_scale : {1.0F, 2.0F, 3.0F}) {
        for (const float width : {90.0F, 160.0F, 240.0F, 460.0F, 700.0F}) {
            SCOPED_TRACE(std::to_string(width) + " pixels, text of size " + std::to_string(text_scale));
            InspectorHarness panel(scene, width);
            // The ray to a sun that nearly touches the sphere's edge, from where it leaves it.
            panel.pixel().light = InspectedLight{.number = 0, .direction = {1.0, 0.2, -0.3}, .shines = true, .why = "shines"};
            ImGui::GetIO().FontGlobalScale = text_scale;
            panel.redraws(3);
            EXPECT_TRUE(panel.has("light drawing mark 0"));
            std::vector<std::pair<std::string, WidgetRectangle>> drawn;  // marks come before texts
            for (const auto& [name, at] : panel.rectangles) {
                const bool is_text = name.find(" drawing text ") != std::string::npos;
                if (!is_text && name.find(" drawing mark ") == std::string::npos) continue;
                for (const auto& [other, there] : drawn) {
                    EXPECT_FALSE(is_text && at.left < there.right && there.left < at.right && at.top < there.bottom &&
                                 there.top < at.bottom)
                        << name << " and " << other;
                }
                drawn.emplace_back(name, at);
            }
            if (width < 200.0F || text_scale > 2.0F) continue;
            for (const char* name : {"ray drawing text eye", "ray drawing text t1"}) EXPECT_TRUE(panel.has(name)) << name;
        }
    }
}

}  // namespace

}  // namespace sphereview
