#include "panels/comparison.hpp"

#include <gtest/gtest.h>

#include "support/panel_harness.hpp"
#include "viewer/layout.hpp"

namespace sphereview {

namespace {

struct ComparisonHarness {
    ComparisonWords comparison{"mine.png",
                               {200, 100},
                               "12 of 20,000 pixels differ from the right picture.",
                               {"likeliest mistake: y points down", "explains 12 of the pixels that differ"},
                               {{"y points down", 12, {255, 255, 255}}},
                               {{{3, 4}, "pixel 3,4: found 1 2 3"}, {{5, 6}, "pixel 5,6: found 1 2 3"}},
                               {}};
    ComparisonView view{};
    ImTextureID picture{};
    std::optional<Pixel> pinned{};
    Rectangle area{0.0F, 0.0F, 700.0F, 590.0F};
    PanelHarness panels{[this](const PanelContext& context) {
        if (view.open) draw_comparison(context, comparison, &picture, pinned, area, view);
    }};

    ComparisonHarness() {
        comparison.at = [](Pixel pixel) { return "what is at " + std::to_string(pixel.x) + "," + std::to_string(pixel.y); };
    }
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
    panels.click(panels.place("difference", 0.2525F, 0.505F));
    EXPECT_EQ(panels.taken<PinPixel>().at(0).pixel, (Pixel{50, 50}));
}

TEST(ComparisonPanel, ShowsAnyOfThePicturesAndWhatIsInAPinnedPixel) {
    ComparisonHarness shown;
    PanelHarness& panels = shown.panels;
    EXPECT_EQ(shown.view.picture, ComparedPicture::difference);
    panels.click("show found");
    EXPECT_EQ(shown.view.picture, ComparedPicture::found);
    panels.click("show right");
    EXPECT_EQ(shown.view.picture, ComparedPicture::right);
    panels.click("show difference");
    EXPECT_EQ(shown.view.picture, ComparedPicture::difference);
    EXPECT_EQ(panels.text().find("what is at"), std::string::npos);
    shown.pinned = Pixel{7, 8};
    EXPECT_NE(panels.text().find("what is at 7,8"), std::string::npos);
}

TEST(ComparisonPanel, TakesTheSidePanelsPlace) {
    ViewerState state({}, {});
    Rectangle picture;
    PanelHarness window([&](const PanelContext& context) { picture = draw_panels(state, context, {}); }, {}, 1400.0F, 900.0F);
    const Rectangle before = picture;
    EXPECT_TRUE(state.panel_drawn);
    state.comparison.emplace();
    for (const ImVec2 size : {ImVec2{1400.0F, 900.0F}, ImVec2{800.0F, 600.0F}}) {
        for (const bool inspector : {false, true}) {
            ImGui::GetIO().DisplaySize = size;
            state.inspector_shown = inspector;
            window.redraws(2);
            const WidgetRectangle shown = window.rectangles.at("comparison");
            EXPECT_GE(shown.left, picture.x + picture.width) << "covers nothing of the picture";
            EXPECT_LE(shown.right, size.x);
            EXPECT_GT(picture.width, 200.0F);
            EXPECT_FALSE(state.panel_drawn);
        }
    }
    state.inspector_shown = true;
    window.scale = 2.0F;
    window.redraws(2);
    EXPECT_GE(window.rectangles.at("comparison").left, 0.0F) << "over the others where there is no room beside them";
    EXPECT_LE(window.rectangles.at("comparison").right, 800.0F);
    window.scale = 1.0F;
    ImGui::GetIO().DisplaySize = {1400.0F, 900.0F};
    state.inspector_shown = false;
    state.comparison->view.open = false;
    window.redraws(2);
    EXPECT_TRUE(state.panel_drawn);
    EXPECT_EQ(picture.width, before.width);
}

}  // namespace sphereview
