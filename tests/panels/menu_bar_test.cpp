#include "panels/menu_bar.hpp"

#include <gtest/gtest.h>

#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

class MenuBar : public testing::Test {
protected:
    std::vector<std::string> recent;
    float height = 0.0F;
    PanelHarness harness{[this](const PanelContext& context) { height = draw_menu_bar(context, recent); }};

    // The commands that clicking through the menu asks for.
    std::vector<CommandId> choose(const std::string& menu, const std::string& item) {
        harness.take_actions();
        harness.click("menu " + menu);
        for (const CommandInfo& info : all_commands()) {
            if (info.label == item && !info.submenu.empty()) harness.click("menu " + std::string(info.submenu));
        }
        harness.click("item " + item);
        std::vector<CommandId> commands;
        for (const RunCommand& run : harness.taken<RunCommand>()) commands.push_back(run.command);
        return commands;
    }
};

}  // namespace

TEST_F(MenuBar, RunsEveryCommand) {
    for (const CommandInfo& info : all_commands()) {
        EXPECT_EQ(choose(std::string(info.menu), std::string(info.label)), std::vector{info.id}) << info.label;
    }
    EXPECT_GT(height, 10.0F);
    EXPECT_LT(height, 60.0F);
}

TEST_F(MenuBar, DisabledItemsDoNothing) {
    harness.enabled = [](CommandId id) { return id != CommandId::undo; };
    EXPECT_EQ(choose("Edit", "Undo"), std::vector<CommandId>{});
    harness.click(ImVec2(700.0F, 500.0F));
    EXPECT_EQ(choose("Edit", "Redo"), std::vector{CommandId::redo});
}

TEST_F(MenuBar, NamesTheStepsToUndoAndRedo) {
    harness.document.apply(InsertSpheres{{0}, {{}}}, "Add sphere ##0", 0);
    harness.click("menu Edit");
    // The second "#" is set apart, for ImGui shows nothing from "##" on.
    EXPECT_NE(harness.text().find("Undo Add sphere # #0"), std::string::npos) << harness.text();
    harness.document.undo();
    harness.frames(2);
    EXPECT_NE(harness.text().find("Redo Add sphere # #0"), std::string::npos) << harness.text();
    EXPECT_EQ(harness.text().find("Undo Add"), std::string::npos);
}

TEST_F(MenuBar, OpensRecentFiles) {
    recent = {"/scenes/a/four.txt", "/scenes/b/four.txt", "/odd/##%s\n.toml"};
    for (std::size_t i = 0; i < recent.size(); ++i) {
        harness.take_actions();
        harness.click("menu File");
        harness.click("menu Open recent");
        harness.click("recent " + std::to_string(i));
        const std::vector<OpenFile> opened = harness.taken<OpenFile>();
        ASSERT_EQ(opened.size(), 1U);
        EXPECT_EQ(opened[0].path, recent[i]);
    }
}

TEST_F(MenuBar, HasNoRecentFilesAtFirst) {
    harness.click("menu File");
    harness.click("menu Open recent");
    EXPECT_FALSE(harness.has("recent 0"));
}

}  // namespace sphereview
