#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "panels/commands.hpp"
#include "panels/menus.hpp"
#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

// Every key that a shortcut may name, as KeyChanged spells it.
std::vector<std::string> all_keys() {
    std::vector<std::string> keys{"delete", "backspace", "enter", "escape",    "tab", "space", "home", "end",
                                  "insert", "page up",   "left",  "page down", "up",  "down",  "right"};
    for (char c = '!'; c <= '~'; ++c) {
        if (c < 'A' || c > 'Z') keys.emplace_back(1, c);
    }
    for (int i = 1; i <= 12; ++i) keys.push_back("f" + std::to_string(i));
    return keys;
}

TEST(Commands, AreEachDescribedOnce) {
    std::set<CommandId> seen;
    std::set<std::string_view> menus;
    std::string_view menu;
    const std::vector<CommandInfo> commands = all_commands();
    for (const CommandInfo& info : commands) {
        EXPECT_TRUE(seen.insert(info.id).second) << info.label;
        EXPECT_EQ(&info_of(commands, info.id), &info);
        EXPECT_FALSE(info.label.empty());
        EXPECT_TRUE(info.help.ends_with('.')) << info.label;
        const bool begins = info.menu != menu;
        EXPECT_EQ(menus.insert(info.menu).second, begins) << info.menu << " is in two parts";
        menu = info.menu;
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(CommandId::about) + 1);
    EXPECT_EQ(menus, (std::set<std::string_view>{"File", "Edit", "View", "Help"}));
}

TEST(Commands, HaveKeysThatNoOtherHas) {
    const std::vector<CommandInfo> commands = all_commands();
    std::set<CommandId> reached;
    for (const std::string& key : all_keys()) {
        for (int held = 0; held < 8; ++held) {
            std::vector<std::string_view> meant;
            for (const CommandInfo& info : commands) {
                if (matches(info.shortcut, key, held & 1, held & 2, held & 4)) meant.push_back(info.label);
            }
            if (key == "space" && held == 0) {  // there need not be both a pixel and frames
                EXPECT_EQ(meant, (std::vector<std::string_view>{"Pin the pixel", "Play"}));
                meant.pop_back();
            }
            EXPECT_LE(meant.size(), 1U) << key << " with " << held << ": " << meant[0] << ", " << meant[1];
            if (const auto command = command_for_key(commands, key, held & 1, held & 2, held & 4)) reached.insert(*command);
        }
        const auto typed = key.size() == 1 ? command_for_character(commands, static_cast<char32_t>(key[0])) : std::nullopt;
        if (typed) reached.insert(*typed);
    }
    for (const CommandInfo& info : commands) EXPECT_TRUE(reached.contains(info.id)) << info.label;
}

TEST(Commands, OfTwoWithOneKeyTheOneIsMeantThatHasSomethingToDo) {
    std::vector<CommandInfo> commands = all_commands();
    const auto meant = [&](bool pins, bool plays) {
        for (CommandInfo& info : commands) {
            if (info.id == CommandId::pin_pixel) info.enabled = pins;
            if (info.id == CommandId::play) info.enabled = plays;
        }
        return command_for_key(commands, "space", false, false, false);
    };
    EXPECT_EQ(meant(true, true), CommandId::pin_pixel);
    EXPECT_EQ(meant(true, false), CommandId::pin_pixel);
    EXPECT_EQ(meant(false, true), CommandId::play);
    EXPECT_EQ(meant(false, false), CommandId::pin_pixel) << "which does nothing then";
}

// All that can be pressed for a shortcut: C(trl), S(hift) and A(lt) before the key.
std::string pressed(std::string_view shortcut) {
    std::string all;
    for (const std::string& key : all_keys()) {
        for (int held = 0; held < 8; ++held) {
            if (!matches(shortcut, key, held & 1, held & 2, held & 4)) continue;
            all += std::string(all.empty() ? "" : ", ") + (held & 1 ? "C" : "") + (held & 2 ? "S" : "") + (held & 4 ? "A" : "") +
                   " " + key;
        }
    }
    return all;
}

TEST(Shortcuts, MatchTheirKeysWithWhatMustBeHeld) {
    for (const auto& [shortcut, expected] : {std::pair{"Ctrl+S", "C s"},
                                             {"Ctrl+Shift+S", "CS s"},
                                             {"Ctrl+Shift+Alt+Page up", "CSA page up"},
                                             {"Page up", " page up"},
                                             {"Delete", " delete"},
                                             {"Ctrl+Shift+Z|Ctrl+Y", "C y, CS z"},
                                             {"", ""},
                                             // Shift does not matter for symbols; a digit is none.
                                             {"F1|?", " ?, S ?,  f1"},
                                             {"Ctrl++|Ctrl+=", "C +, CS +, C =, CS ="},
                                             {"Shift+/", "S /"},
                                             {"7", " 7"}}) {
        EXPECT_EQ(pressed(shortcut), expected) << shortcut;
    }
    EXPECT_FALSE(matches("", "", false, false, false));
    EXPECT_EQ(first_shortcut("Ctrl+Shift+Z|Ctrl+Y"), "Ctrl+Shift+Z");
    EXPECT_EQ(every_shortcut("Ctrl+Shift+Z|Ctrl+Y"), "Ctrl+Shift+Z or Ctrl+Y");
    EXPECT_EQ(every_shortcut("Home"), "Home");
    EXPECT_EQ(first_shortcut(""), "");
}

TEST(Shortcuts, AreFoundForKeysAndCharacters) {
    const std::vector<CommandInfo> commands = all_commands();
    EXPECT_EQ(command_for_key(commands, "z", true, false, false), CommandId::undo);
    EXPECT_EQ(command_for_key(commands, "f12", false, false, false), CommandId::export_now);
    EXPECT_EQ(command_for_key(commands, "+", true, true, false), CommandId::larger_text);
    EXPECT_EQ(command_for_key(commands, "f11", false, false, false), std::nullopt);
    // One press tells of a key and of a character; only one of them may count.
    EXPECT_EQ(command_for_key(commands, "?", false, true, false), std::nullopt);
    EXPECT_EQ(command_for_character(commands, U'?'), CommandId::help);
    EXPECT_EQ(command_for_key(commands, "h", false, false, false), CommandId::hide);
    EXPECT_EQ(command_for_character(commands, U'h'), std::nullopt);
    EXPECT_EQ(command_for_character(commands, U'ä'), std::nullopt);
    EXPECT_EQ(command_for_character(commands, 0), std::nullopt);
}

class MenuBar : public testing::Test {
protected:
    std::vector<std::string> recent;
    float height = 0.0F;
    MenuKeys keys;
    PanelHarness harness{
        [this](const PanelContext& context) { height = draw_menu_bar(context, recent, keys); }, {}, 800.0F, 700.0F};

    // The commands that clicking through the menu asks for.
    std::vector<CommandId> choose(const std::string& menu, const std::string& item) {
        harness.take_actions();
        harness.click("menu " + menu);
        for (const CommandInfo& info : all_commands()) {
            if (info.label == item && !info.submenu.empty()) harness.click("menu " + std::string(info.submenu));
        }
        harness.click("item " + item);
        return harness.commands_taken();
    }
};

TEST_F(MenuBar, RunsEveryCommand) {
    for (const CommandInfo& info : all_commands()) {
        EXPECT_EQ(choose(std::string(info.menu), std::string(info.label)), std::vector{info.id}) << info.label;
    }
    EXPECT_GT(height, 10.0F);
    EXPECT_LT(height, 60.0F);
}

TEST_F(MenuBar, KeysOpenOneMenuAfterTheOther) {
    const auto open_after = [this](bool begins, int step) {
        keys.begins = begins;
        keys.step = step;
        harness.redraws(3);
        return keys.open;
    };
    EXPECT_EQ(open_after(false, 1), "") << "none was open";
    EXPECT_EQ(open_after(true, 0), "File");
    EXPECT_EQ(open_after(false, 1), "Edit");
    EXPECT_EQ(open_after(false, 1), "View");
    harness.click("menu Shading");
    EXPECT_TRUE(keys.in_submenu);
    EXPECT_EQ(open_after(false, 1), "View") << "the submenu's key";
    harness.click(ImVec2(700.0F, 500.0F));
    EXPECT_EQ(open_after(false, 0), "");
    EXPECT_EQ(open_after(true, 0), "File");
    EXPECT_EQ(open_after(false, -1), "Help");
}

TEST_F(MenuBar, DisabledItemsDoNothing) {
    for (CommandInfo& info : harness.commands) info.enabled = info.id != CommandId::undo;
    EXPECT_EQ(choose("Edit", "Undo"), std::vector<CommandId>{});
    harness.click(ImVec2(700.0F, 500.0F));
    EXPECT_EQ(choose("Edit", "Redo"), std::vector{CommandId::redo});
}

TEST_F(MenuBar, NamesTheStepsToUndoAndRedo) {
    harness.document.apply(InsertSpheres{{0}, {{}}}, "Add sphere ##0", 0);
    harness.click("menu Edit");
    // The second "#" is set apart, for ImGui shows nothing from "##" on.
    EXPECT_NE(harness.text().find("Undo Add sphere # #0"), std::string::npos) << harness.text();
    EXPECT_NE(harness.text().find("History: 0.0 of 64 MB"), std::string::npos) << harness.text();
    harness.document.undo();
    harness.redraws(2);
    EXPECT_NE(harness.text().find("Redo Add sphere # #0"), std::string::npos) << harness.text();
    EXPECT_EQ(harness.text().find("Undo Add"), std::string::npos);
}

TEST_F(MenuBar, OpensRecentFiles) {
    harness.click("menu File");
    harness.click("menu Open recent");
    EXPECT_FALSE(harness.has("recent 0"));
    harness.click(ImVec2(700.0F, 500.0F));
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

TEST(Help, ListsEveryShortcutAndTheMouse) {
    bool open = true;
    // High enough for all of it: what is clipped is still in the text, but so a test of the layout too.
    PanelHarness harness([&](const PanelContext& context) { draw_help(context, open); }, {}, 1000.0F, 1600.0F);
    const std::string text = harness.text();
    for (const CommandInfo& info : all_commands()) {
        EXPECT_NE(text.find(every_shortcut(info.shortcut)), std::string::npos) << info.label;
        EXPECT_NE(text.find(info.label), std::string::npos) << info.label;
    }
    for (const char* words : {"Left-drag elsewhere", "Pans.", "Ctrl+click on a sphere", "Opens the scene in it."})
        EXPECT_NE(text.find(words), std::string::npos) << words;
}

TEST(Help, ClosesByItsButton) {
    bool open = true;
    PanelHarness harness([&](const PanelContext& context) { draw_help(context, open); }, {}, 1000.0F, 1000.0F);
    // The title bar's right end: the window is 860 x 640 in the middle.
    harness.click(ImVec2(500.0F + 430.0F - 11.0F, 500.0F - 320.0F + 10.0F));
    EXPECT_FALSE(open);
    harness.redraws(2);
    EXPECT_EQ(harness.vertices(), 0);
    open = true;
    ImGui::GetIO().DisplaySize = {200.0F, 100.0F};
    harness.redraws(2);
    EXPECT_GT(harness.vertices(), 0) << "in a small window, too";
}

}  // namespace

}  // namespace sphereview
