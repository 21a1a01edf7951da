// The panel of the scene's light: what its ball, sliders and switches ask for, in steps that can be undone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "panels/harness.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// Its ball is drawn once the header is open.
struct OpenLightPanel : OpenPartHarness {
    explicit OpenLightPanel(const Light& light = {}) : OpenPartHarness("light", [&](Scene& scene) { scene.light = light; }) {}

    const Light& light() const { return document.scene().light; }
    // On the ball, in radii from its middle.
    ImVec2 ball(float x, float y) const {
        constexpr float in_widget = 0.5F / 1.45F;
        return place("sun ball", 0.5F + in_widget * x, 0.5F - in_widget * y);
    }
};

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::acos(std::clamp(dot(unit(a), unit(b)), -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

}  // namespace

TEST(LightPanel, TheSunIsWhereItIsDraggedInOneStep) {
    OpenLightPanel panel({.lights = 64, .sky = 0.5, .key = 0.25, .sun = Sun{{1.0, 0.0, 0.0}, 2.0}});
    const Light before = panel.light();
    // The camera looks along z, with x to the right: toward the eye is -z.
    panel.drag(panel.ball(0.0F, 0.0F), panel.ball(0.6F, 0.5F));
    EXPECT_GE(panel.edits_of_one_gesture().size(), 5U);
    const glm::dvec3 expected{0.6, 0.5, -std::sqrt(1.0 - 0.36 - 0.25)};
    EXPECT_LT(angle_between(panel.light().sun->direction, expected), 4.0);
    EXPECT_EQ(panel.light().sun->strength, 2.0);
    EXPECT_EQ(panel.light().lights, 64);
    EXPECT_EQ(panel.document.undo_name(), "Move the sun");
    panel.undo();
    EXPECT_EQ(panel.light(), before);
    EXPECT_FALSE(panel.document.can_undo());

    // In the ring it shines from behind, and beyond it from straight behind.
    panel.drag(panel.ball(0.0F, 0.0F), panel.ball(-1.225F, 0.0F));
    EXPECT_LT(angle_between(panel.light().sun->direction, {-1.0, 0.0, 1.0}), 6.0);
    panel.drag(panel.ball(0.0F, 0.0F), panel.ball(0.0F, 3.0F));
    EXPECT_LT(angle_between(panel.light().sun->direction, {0.0, 0.0, 1.0}), 0.1);
}

// Whoever holds the sun where it is changes nothing.
TEST(LightPanel, NothingIsAskedForWhileTheHeldSunRests) {
    OpenLightPanel panel({.sun = Sun{}});
    panel.expect_nothing_while_held(panel.ball(0.3F, 0.3F));
}

TEST(LightPanel, EscapeEndsADragOfTheSun) {
    for (const bool has_sun : {true, false}) {
        OpenLightPanel panel({.sun = has_sun ? std::optional(Sun{{1.0, 0.0, 0.0}, 2.0}) : std::nullopt});
        const Light before = panel.light();
        panel.move(panel.ball(0.0F, 0.0F));
        panel.press();
        panel.move(panel.ball(0.3F, 0.3F));
        EXPECT_NE(panel.light(), before);
        panel.tap(ImGuiKey_Escape);
        EXPECT_EQ(panel.light(), before);
        panel.move(panel.ball(-0.3F, 0.3F));
        panel.release();
        panel.redraws(2);
        EXPECT_EQ(panel.light(), before);
        // The next drag is one again; a sun that was taken back is not remembered.
        if (!has_sun) {
            panel.click("sun");
            EXPECT_GT(angle_between(panel.light().sun->direction, {0.3, 0.3, -0.9}), 5.0);
        }
        panel.drag(panel.ball(0.0F, 0.0F), panel.ball(0.6F, 0.5F));
        EXPECT_NE(panel.light(), before);
    }
}

TEST(LightPanel, ShowsHowStrongASunWouldBeThatIsOff) {
    OpenLightPanel panel;
    EXPECT_NE(panel.text().find("0.7"), std::string::npos) << panel.text();
    panel.click("sun");
    EXPECT_EQ(sun_strength_of(panel.light()), 0.7);
}

TEST(LightPanel, SwitchesTheSunOffAndOnAgainAsItWas) {
    OpenLightPanel panel;
    panel.click("sun");
    ASSERT_TRUE(panel.light().sun);
    EXPECT_EQ(panel.document.undo_name(), "Switch the sun on");
    EXPECT_EQ(sky_of(panel.light()), sky_beside_sun);
    EXPECT_EQ(sun_strength_of(panel.light()), sun_beside_sky);
    panel.drag(panel.place("slider strength", 0.2F), panel.place("slider strength", 0.9F));
    EXPECT_GT(panel.light().sun->strength, 1.2 * sun_beside_sky);
    const Light with_sun = panel.light();
    panel.click("sun");
    EXPECT_FALSE(panel.light().sun);
    EXPECT_EQ(sky_of(panel.light()), most_sky);
    panel.click("sun");
    EXPECT_EQ(panel.light(), with_sun);
    for (int i = 0; i < 4; ++i) panel.undo();
    EXPECT_EQ(panel.light(), Light{});
    EXPECT_FALSE(panel.document.can_undo());
    // A click on the ball puts one there.
    panel.click(panel.ball(0.0F, 0.0F));
    ASSERT_TRUE(panel.light().sun);
    EXPECT_LT(angle_between(panel.light().sun->direction, {0.0, 0.0, -1.0}), 3.0);
}

TEST(LightPanel, TheSunLeavesASkyThatIsSaid) {
    OpenLightPanel panel({.sky = most_sky});
    panel.click("sun");
    EXPECT_EQ(panel.light().sky, most_sky);
    EXPECT_EQ(sun_strength_of(panel.light()), 1.0);
    panel.click("sun");
    EXPECT_EQ(panel.light(), Light{.sky = most_sky});
}

TEST(LightPanel, AChangeOfTheSkyLeavesTheSun) {
    OpenLightPanel panel;
    panel.click("sun");
    panel.drag_by("sky", -13.0F);
    EXPECT_LT(sky_of(panel.light()), sky_beside_sun);
    EXPECT_EQ(sun_strength_of(panel.light()), sun_beside_sky);
}

TEST(LightPanel, AzimuthAndElevationTurnTheSun) {
    OpenLightPanel panel({.sun = Sun{{0.0, 0.0, -1.0}, 1.0}});
    panel.enter("azimuth", "90");
    EXPECT_LT(angle_between(panel.light().sun->direction, {1.0, 0.0, 0.0}), 1e-6);
    panel.enter("elevation", "45");
    EXPECT_LT(angle_between(panel.light().sun->direction, {1.0, 1.0, 0.0}), 1e-6);
    const Light before = panel.light();
    panel.enter("elevation", "1000");
    EXPECT_EQ(panel.light(), before);
    EXPECT_NE(panel.text().find("'1000': a number from -90 to 90 is expected."), std::string::npos);
    panel.enter("azimuth", "-450");  // round and round
    EXPECT_LT(angle_between(panel.light().sun->direction, {-1.0, 1.0, 0.0}), 1e-6);
    EXPECT_FALSE(panel.has("refusal elevation")) << "another number was typed";
}

TEST(LightPanel, SkyKeyAndLightsAreEdits) {
    OpenLightPanel panel;
    panel.drag_by("sky", -53.0F);  // 3 of them are a click's
    EXPECT_EQ(panel.light().sky, 0.5);
    panel.drag_by("sky", 500.0F);
    EXPECT_EQ(panel.light().sky, 1.0) << "no further";
    panel.drag_by("sky", -53.0F);
    panel.drag_by("key", -500.0F);
    EXPECT_EQ(panel.light().key, 0.0);
    EXPECT_EQ(panel.document.undo_name(), "Change the key light");
    panel.click("lights");
    panel.redraws(3);
    panel.click("lights 128");
    EXPECT_EQ(panel.light().lights, 128);
    panel.click("lights");
    panel.redraws(3);
    panel.click("lights automatic");
    EXPECT_EQ(panel.light().lights, std::nullopt);
    for (int i = 0; i < 6; ++i) panel.undo();
    EXPECT_EQ(panel.light(), Light{});
    EXPECT_FALSE(panel.document.can_undo());
}

// Only the shading Studio shows light: the panel offers it where another one is chosen.
TEST(LightPanel, OffersTheShadingThatShowsLight) {
    OpenLightPanel panel;
    panel.click("studio");
    const std::vector<CommandId> commands = panel.commands_taken();
    ASSERT_EQ(commands.size(), 1U);
    for (CommandInfo& info : panel.commands) info.checked = info.id == commands[0];
    panel.redraws(2);
    EXPECT_EQ(info_of(panel.commands, commands[0]).label, "Studio");
    EXPECT_FALSE(panel.has("studio"));
}

}  // namespace sphereview
