#include <gtest/gtest.h>

#include <vector>

#include "panels/start_page.hpp"
#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

struct StartHarness {
    StartPage page{{{"/share/planets.toml", "Planets"}, {"/share/helix.xyz", "Helix"}}};
    std::vector<std::string> recent{"/home/a/mine.txt"};
    Rectangle area{0.0F, 30.0F, 700.0F, 560.0F};
    bool has_keys = true;
    float room = 0.0F;
    PanelHarness panels{[this](const PanelContext& context) {
        room = start_page_room(context);
        draw_start_page(context, page, recent, area, has_keys);
    }};

    std::vector<std::string> opened() {
        std::vector<std::string> paths;
        for (const OpenFile& file : panels.taken<OpenFile>()) paths.push_back(file.path);
        return paths;
    }
    std::vector<CommandId> run() { return panels.commands_taken(); }
};

using Paths = std::vector<std::string>;
using Commands = std::vector<CommandId>;

}  // namespace

TEST(StartPage, OpensFilesAndRunsCommandsThatAreClicked) {
    StartHarness start;
    start.panels.redraws(3);
    start.panels.click("start recent 0");
    EXPECT_EQ(start.opened(), Paths{"/home/a/mine.txt"});
    start.panels.click("start example 1");
    EXPECT_EQ(start.opened(), Paths{"/share/helix.xyz"});
    start.panels.click("start open");
    EXPECT_EQ(start.run(), Commands{CommandId::file_open});
    start.panels.click("start command 1");
    EXPECT_EQ(start.run(), Commands{CommandId::toggle_inspector});
}

TEST(StartPage, IsReachedWithTheArrowKeysAndEnter) {
    StartHarness start;
    start.panels.redraws(3);
    start.panels.tap(ImGuiKey_Enter);  // nothing is chosen yet
    EXPECT_TRUE(start.panels.take_actions().empty());
    for (int i = 0; i < 3; ++i) start.panels.tap(ImGuiKey_DownArrow);
    start.panels.tap(ImGuiKey_Enter);
    EXPECT_EQ(start.opened(), Paths{"/share/planets.toml"});
    start.panels.tap(ImGuiKey_UpArrow);
    start.panels.tap(ImGuiKey_Enter);
    EXPECT_EQ(start.opened(), Paths{"/home/a/mine.txt"});
    for (int i = 0; i < 20; ++i) start.panels.tap(ImGuiKey_DownArrow);  // the last row is the end
    start.panels.tap(ImGuiKey_Enter);
    EXPECT_EQ(start.run(), Commands{CommandId::help});
    start.has_keys = false;  // a dialog's keys are no choice here
    start.panels.tap(ImGuiKey_Enter);
    EXPECT_TRUE(start.panels.take_actions().empty());
}

TEST(StartPage, StaysInsideThePictureAndGoesWhereNothingCouldBeRead) {
    StartHarness start;
    for (const float width : {700.0F, 300.0F}) {
        start.area.width = width;
        start.panels.redraws(4);
        const WidgetRectangle page = start.panels.rectangles.at("start page");
        EXPECT_GE(page.left, 0.0F);
        EXPECT_LE(page.right, width);
        EXPECT_GE(page.top, start.area.y);
        EXPECT_LE(page.bottom, start.area.y + start.area.height);
    }
    start.area.width = start.room;
    start.panels.redraws(4);
    const WidgetRectangle wide = start.panels.rectangles.at("start command 1");
    start.area.width = 200.0F;
    start.panels.redraws(4);
    const WidgetRectangle narrow = start.panels.rectangles.at("start command 1");
    EXPECT_GE(narrow.bottom - narrow.top, wide.bottom - wide.top + ImGui::GetTextLineHeight()) << "words go on in another line";
    start.area.width = 100.0F;
    start.panels.redraws(2);
    EXPECT_FALSE(start.panels.has("start page"));
}

}  // namespace sphereview
