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
    PanelHarness panels{[this](const PanelContext& context) {
        if (open) draw_comparison(context, comparison, &difference, {0.0F, 0.0F, 700.0F, 590.0F}, free, open);
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

}  // namespace sphereview
