// What the parts of the window leave each other.
#include <gtest/gtest.h>

#include <string>

#include "panels/start_page.hpp"
#include "support/panel_harness.hpp"
#include "support/spheres.hpp"
#include "viewer/layout.hpp"
#include "viewer/view_marks.hpp"

namespace sphereview {

namespace {

class WindowLayout : public testing::Test {
protected:
    ViewerState state{{}, {}};
    float page_room = 0.0F;  // of an empty window's page
    Rectangle picture;
    PanelHarness window{[this](const PanelContext& context) {
                            page_room = start_page_room(context);
                            picture = draw_panels(state, context, {});
                            state.picture_size = {static_cast<int>(picture.width), static_cast<int>(picture.height)};
                            state.rays.size = state.picture_size;
                            draw_view_marks(state, context, picture, 1.0);
                        },
                        {},
                        1400.0F,
                        900.0F};

    // A window that has a scene: else the page of an empty one asks for room.
    void give_scene() {
        state.document = Document(scene_of_alike(1));
        window.redraws(2);
    }

    void resize(float width, float height, float scale = 1.0F) {
        ImGui::GetIO().DisplaySize = {width, height};
        window.scale = scale;
        window.redraws(4);
    }
};

TEST_F(WindowLayout, ThePanelYieldsToThePageOfAnEmptyWindow) {
    resize(800.0F, 600.0F);
    EXPECT_TRUE(state.panel_drawn);
    EXPECT_GE(picture.width, page_room - 1.0F);
    resize(600.0F, 600.0F);
    EXPECT_FALSE(state.panel_drawn);
    EXPECT_EQ(picture.width, 600.0F);
    give_scene();
    EXPECT_TRUE(state.panel_drawn);
}

TEST_F(WindowLayout, ThePanelGetsItsWidthBackWhenThereIsRoom) {
    state.settings.panel_width = 700.0;
    give_scene();
    const float before = picture.width;
    EXPECT_LT(before, 700.0F);
    ImGui::GetIO().DisplaySize.x = 500.0F;
    window.click("splitter");  // moves nothing
    EXPECT_LT(picture.width, 200.0F);
    EXPECT_EQ(state.settings.panel_width, 700.0);
    ImGui::GetIO().DisplaySize.x = 1400.0F;
    window.redraws();
    EXPECT_EQ(picture.width, before);
    window.drag(window.place("splitter"), {window.place("splitter").x + 100.0F, 300.0F});
    EXPECT_NEAR(state.settings.panel_width, 600.0, 1.0);
}

TEST_F(WindowLayout, PanelsYieldToThePictureInASmallWindow) {
    state.inspector_shown = true;
    window.redraws(2);
    EXPECT_TRUE(state.panel_drawn);
    EXPECT_TRUE(window.has("splitter") && window.has("inspector splitter"));
    resize(200.0F, 150.0F);
    EXPECT_FALSE(state.panel_drawn);
    EXPECT_TRUE(state.panel_shown) << "as soon as there is room";
    EXPECT_EQ(picture.width, 200.0F);
    EXPECT_GT(picture.height, 100.0F);
    for (const char* menu : {"menu File", "menu Edit", "menu View", "menu Help"}) {
        EXPECT_LT(window.rectangles.at(menu).right, 200.0F) << menu;
    }
    resize(1400.0F, 600.0F);
    EXPECT_TRUE(window.has("splitter") && window.has("inspector splitter"));
}

TEST_F(WindowLayout, TheSidePanelYieldsToToolsThatAreOpen) {
    give_scene();
    state.inspector_shown = true;
    resize(800.0F, 600.0F);
    EXPECT_TRUE(state.panel_drawn);
    EXPECT_GE(window.rectangles.at("inspector splitter").left, 260.0F);
    EXPECT_GE(picture.width, 220.0F);
    resize(1400.0F, 900.0F, 2.0F);
    EXPECT_TRUE(state.panel_drawn);
    EXPECT_GE(window.rectangles.at("inspector splitter").left, 500.0F);
    EXPECT_GE(picture.width, 400.0F);
    resize(800.0F, 600.0F, 2.0F);
    EXPECT_FALSE(state.panel_drawn) << "no room for all three";
    EXPECT_GE(window.rectangles.at("inspector splitter").left, 400.0F);
    state.inspector_shown = false;
    window.redraws(2);
    EXPECT_TRUE(state.panel_drawn);
    state.measuring.on = true;
    window.redraws(2);
    EXPECT_GT(picture.width, 700.0F);
    EXPECT_EQ(state.settings.panel_width, ViewerSettings{}.panel_width) << "what the person chose is kept";
}

TEST_F(WindowLayout, TheRaysPanelAndTheAxesCoverNothingOfEachOther) {
    state.rays.on = true;
    state.rays.choice.shown = RaysShown::all;
    state.settings.scale_bar_shown = true;
    state.pivot = {0.0, 0.0, 300.0};
    give_scene();
    for (const float text_scale : {1.0F, 2.0F}) {
        ImGui::GetIO().FontGlobalScale = text_scale;
        for (const ImVec2 size : {ImVec2{1400.0F, 900.0F}, {1400.0F, 760.0F}, {800.0F, 600.0F}, {1000.0F, 500.0F}}) {
            SCOPED_TRACE(std::to_string(size.x) + " x " + std::to_string(size.y));
            resize(size.x, size.y, text_scale);
            ASSERT_TRUE(window.has("axes"));
            const WidgetRectangle rays = window.rectangles.at("rays");
            const WidgetRectangle axes = window.rectangles.at("axes");
            EXPECT_TRUE(rays.bottom <= axes.top || rays.right <= axes.left);
            // Nor does the scale bar.
            const ImVec2 bar = state.marks_in_corners.right;
            EXPECT_GT(bar.x, 0.0F);
            EXPECT_TRUE(axes.right <= picture.x + picture.width - bar.x || axes.bottom <= picture.y + picture.height - bar.y);
        }
    }
}

TEST_F(WindowLayout, MeasuringBeginsBesideTheRaysPanel) {
    state.rays.on = true;
    give_scene();
    window.redraws(2);
    state.measuring.on = true;
    window.redraws(4);
    const WidgetRectangle rays = window.rectangles.at("rays");
    const WidgetRectangle measuring = window.rectangles.at("measuring");
    EXPECT_TRUE(measuring.left >= rays.right || measuring.top >= rays.bottom);
    EXPECT_LT(measuring.right, window.rectangles.at("splitter").left);
}

}  // namespace

}  // namespace sphereview
