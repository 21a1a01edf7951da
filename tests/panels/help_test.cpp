#include "panels/help.hpp"

#include <gtest/gtest.h>

#include "support/panel_harness.hpp"

namespace sphereview {

TEST(Help, ListsEveryShortcutAndTheMouse) {
    bool open = true;
    // High enough for all of it: what is clipped is still in the text, but so a test of the layout too.
    PanelHarness harness([&](const PanelContext& context) { draw_help(context, open); }, {}, 1000.0F, 1600.0F);
    const std::string text = harness.text();
    for (const CommandInfo& info : all_commands()) {
        EXPECT_NE(text.find(every_shortcut(info.shortcut)), std::string::npos) << info.label;
        EXPECT_NE(text.find(info.label), std::string::npos) << info.label;
    }
    EXPECT_GE(mouse_help().size(), 9U);
    for (const MouseHelp& line : mouse_help()) {
        EXPECT_NE(text.find(line.mouse), std::string::npos) << line.mouse;
        EXPECT_NE(text.find(line.help), std::string::npos) << line.help;
    }
}

TEST(Help, ClosesByItsButton) {
    bool open = true;
    PanelHarness harness([&](const PanelContext& context) { draw_help(context, open); }, {}, 1000.0F, 1000.0F);
    // The title bar's right end: the window is 860 x 640 in the middle.
    harness.click(ImVec2(500.0F + 430.0F - 11.0F, 500.0F - 320.0F + 10.0F));
    EXPECT_FALSE(open);
    harness.frames(2);
    EXPECT_EQ(harness.vertices(), 0);
}

TEST(Help, FitsASmallWindow) {
    bool open = true;
    PanelHarness harness([&](const PanelContext& context) { draw_help(context, open); }, {}, 200.0F, 100.0F);
    EXPECT_GT(harness.vertices(), 0);
    EXPECT_TRUE(open);
}

}  // namespace sphereview
