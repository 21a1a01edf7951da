#include "panels/comparison.hpp"

#include <gtest/gtest.h>

#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

struct ComparisonHarness {
    Comparison comparison{"mine.png",
                          {200, 100},
                          "12 of 20,000 pixels differ from the right picture.",
                          {"likeliest mistake: y points down", "explains 12 of the pixels that differ"},
                          {{"y points down", 12, {255, 255, 255}}},
                          {{{3, 4}, "pixel 3,4: found 1 2 3"}, {{5, 6}, "pixel 5,6: found 1 2 3"}}};
    bool open = true;
    ImTextureID difference{};
    std::optional<ImVec2> free{};
    Rectangle area{0.0F, 0.0F, 700.0F, 590.0F};
    PanelHarness panels{[this](const PanelContext& context) {
        if (open) draw_comparison(context, comparison, &difference, area, free, open);
    }};
};

}  // namespace

TEST(ComparisonPanel, NamesTheMistakeAndLeadsToItsPixels) {
    ComparisonHarness shown;
    PanelHarness& panels = shown.panels;
    const std::string text = panels.text();
    for (const char* words : {"12 of 20,000", "y points down", "explains 12", "pixel 5,6"}) {
        EXPECT_NE(text.find(words), std::string::npos) << text;
    }
    panels.click("example 1");
    const std::vector<Action> actions = panels.take_actions();
    ASSERT_EQ(actions.size(), 2U);
    EXPECT_EQ(std::get<RunCommand>(actions[0]).command, CommandId::go_home) << "the camera that pictures are compared by";
    EXPECT_EQ(std::get<PinPixel>(actions[1]).pixel, (Pixel{5, 6}));
    EXPECT_EQ(std::get<PinPixel>(actions[1]).size, (PictureSize{200, 100}));
    panels.click(panels.place("difference", 0.251F, 0.502F));
    EXPECT_EQ(panels.taken<PinPixel>().at(0).pixel, (Pixel{50, 50}));
}

TEST(ComparisonPanel, GoesAsideFromThePixelThatIsExplained) {
    ComparisonHarness shown;
    PanelHarness& panels = shown.panels;
    const ImVec2 middle = panels.place("comparison");
    shown.free = middle;
    panels.frames(3);
    const WidgetRectangle window = panels.rectangles.at("comparison");
    EXPECT_TRUE(middle.x < window.left || middle.x > window.right);
}

// The list of spheres is beside the picture, and so is the inspector.
TEST(ComparisonPanel, StaysInThePictureWhereThatIsSmall) {
    for (const ImVec2 free : {ImVec2{240.0F, 200.0F}, ImVec2{130.0F, 60.0F}, ImVec2{400.0F, 300.0F}, ImVec2{250.0F, 380.0F}}) {
        for (const float width : {420.0F, 200.0F}) {
            SCOPED_TRACE(std::to_string(free.x) + ", " + std::to_string(free.y) + " in " + std::to_string(width));
            ComparisonHarness shown;
            shown.open = false;
            shown.panels.frames(2);
            shown.open = true;
            shown.area = {100.0F, 30.0F, width, 400.0F};
            shown.panels.frames(2);
            shown.free = ImVec2(std::min(free.x, 90.0F + width), free.y);
            shown.panels.frames(4);
            const WidgetRectangle window = shown.panels.rectangles.at("comparison");
            EXPECT_GE(window.left, 100.0F);
            EXPECT_LE(window.right, 100.0F + width);
            const bool covers = shown.free->x > window.left && shown.free->x < window.right && shown.free->y > window.top &&
                                shown.free->y < window.bottom;
            EXPECT_FALSE(covers);
        }
    }
}

}  // namespace sphereview
