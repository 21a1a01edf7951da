// The panel beside the rays in space.
#include "panels/rays_panel.hpp"

#include <gtest/gtest.h>

#include "panels/harness.hpp"

namespace sphereview {

namespace {

struct RaysPanelHarness {
    RaysPanelHarness() {
        facts.size = {300, 200};
        facts.meets = "Pixel 3, 4 shows sphere 1, hit at t = 2.4";
        facts.least_every = 8;
        facts.most_every = 32;
        panels.redraws(4);
    }

    Rectangle area{100.0F, 50.0F, 700.0F, 500.0F};
    RaysFacts facts;
    RayChoice choice{RaysShown::one, 16, 16};
    RaysAnswer answer;
    PanelHarness panels{[this](const PanelContext& context) {
                            const RaysAnswer now = draw_rays_panel(context, facts, choice, area);
                            answer.pointed = now.pointed;
                            answer.clicked = answer.clicked || now.clicked;
                        },
                        {},
                        800.0F,
                        600.0F};
};

}  // namespace

TEST(RaysPanel, PointsAtAndPinsPixelsOfWhatTheEyeSees) {
    RaysPanelHarness harness;
    harness.panels.move(harness.panels.place("rays picture", 0.5F, 0.25F));
    ASSERT_TRUE(harness.answer.pointed);
    EXPECT_NEAR(harness.answer.pointed->x, 150, 1);
    EXPECT_NEAR(harness.answer.pointed->y, 50, 1);
    EXPECT_FALSE(harness.answer.clicked);
    harness.panels.click(harness.panels.place("rays picture", 0.99F, 0.99F));
    EXPECT_TRUE(harness.answer.clicked);
    EXPECT_NEAR(harness.answer.pointed->x, 297, 2);
    EXPECT_NEAR(harness.answer.pointed->y, 198, 2);
    harness.panels.move({790.0F, 590.0F});
    EXPECT_FALSE(harness.answer.pointed);
    EXPECT_NE(harness.panels.text().find("shows sphere 1"), std::string::npos);
}

TEST(RaysPanel, ChoosesWhichRaysAndHowMany) {
    RaysPanelHarness harness;
    EXPECT_FALSE(harness.panels.has("rays finer"));
    harness.panels.click("rays row");
    EXPECT_EQ(harness.choice.shown, RaysShown::row);
    harness.panels.click("rays all");
    EXPECT_EQ(harness.choice, (RayChoice{RaysShown::all, 16, 16}));
    harness.panels.move({790.0F, 590.0F});
    EXPECT_NE(harness.panels.text().find("every 16th ray"), std::string::npos);
    harness.panels.click("rays finer");
    EXPECT_EQ(harness.choice.in_picture, 8);
    harness.panels.click("rays finer");
    EXPECT_EQ(harness.choice.in_picture, 8) << "no more than can be drawn";
    for (int i = 0; i < 3; ++i) harness.panels.click("rays coarser");
    EXPECT_EQ(harness.choice.in_picture, 32);
    harness.panels.move({790.0F, 590.0F});
    EXPECT_NE(harness.panels.text().find("every 32nd ray"), std::string::npos);
    EXPECT_EQ(harness.choice.in_row, 16) << "a row has a number of its own";
    harness.panels.click("rays one");
    EXPECT_EQ(harness.choice.shown, RaysShown::one);
}

TEST(RaysPanel, ShowsItsChoicesAlsoInALowWindow) {
    RaysPanelHarness harness;
    harness.facts.size = {200, 400};
    harness.area = {0.0F, 20.0F, 400.0F, 220.0F};
    harness.panels.redraws(3);
    harness.panels.click("rays row");
    harness.panels.redraws(3);
    const WidgetRectangle window = harness.panels.rectangles.at("rays");
    for (const char* widget : {"rays picture", "rays one", "rays row", "rays all", "rays finer", "rays coarser"}) {
        EXPECT_LT(harness.panels.rectangles.at(widget).bottom, window.bottom) << widget;
        EXPECT_LT(harness.panels.rectangles.at(widget).right, window.right) << widget;
    }
    EXPECT_LE(window.bottom, 240.0F);
    // And some words.
    harness.area.height = 270.0F;
    harness.panels.redraws(3);
    const float controls = harness.panels.rectangles.at("rays coarser").bottom;
    EXPECT_LT(controls + 3.0F * ImGui::GetTextLineHeight(), harness.panels.rectangles.at("rays").bottom);
}

TEST(RaysPanel, EndsByItsCloseButton) {
    RaysPanelHarness harness;
    harness.panels.take_actions();
    harness.panels.click("rays end");
    EXPECT_EQ(harness.panels.commands_taken(), std::vector{CommandId::toggle_rays});
}

}  // namespace sphereview
