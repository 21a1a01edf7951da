// The list, the buttons, the keys and the menus.
#include <gtest/gtest.h>

#include "support/text_match.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

class Panels : public Editing {
protected:
    Panels() : Editing("scene.toml") {}

    void expect_undone() {
        window_.key("ctrl+z");
        window_.wait_for("undo", "");
        window_.wait_for("spheres", 2);
    }
    bool draws(const std::string& widget) { return window_.frame().at("widgets").contains(widget); }
};

}  // namespace

TEST_F(Panels, ButtonsMenuAndKeysDoTheSame) {
    const auto by_button = [&](const std::string& name) { return [&, name] { window_.click_widget(name); }; };
    const auto by_key = [&](const std::string& name) { return [&, name] { window_.key(name); }; };
    const auto by_menu = [&](const std::string& item) { return [&, item] { window_.choose("Edit", item); }; };
    struct Ways {
        std::string undo;
        int spheres;
        std::vector<std::function<void()>> ways;
    };
    const std::vector<Ways> commands = {
        {"Add sphere 2", 3, {by_button("add"), by_key("Insert"), by_menu("Add sphere")}},
        {"Duplicate sphere 0", 3, {by_button("duplicate"), by_key("ctrl+d"), by_menu("Duplicate")}},
        {"Delete sphere 0", 1, {by_button("delete"), by_key("Delete"), by_menu("Delete")}},
        {"Hide sphere 0", 2, {by_button("hide"), by_key("h"), by_menu("Hide or show"), by_button("row 0 eye")}},
        {"Move sphere 0 down", 2, {by_key("ctrl+Down"), by_menu("Move down")}},
    };
    for (const Ways& command : commands) {
        for (const auto& way : command.ways) {
            SCOPED_TRACE(command.undo);
            window_.click_widget("row 0");
            window_.wait_for("selection", {0});
            way();
            window_.wait_for("undo", command.undo);
            EXPECT_EQ(window_.frame().at("spheres"), command.spheres);
            expect_undone();
        }
    }
}

TEST_F(Panels, WhatAButtonDoesIsInThePicture) {
    window_.click_widget("add");
    window_.wait_for("spheres", 3);
    expect_rendered();
    window_.click_widget("row 1");
    window_.click_widget("hide");
    window_.wait_for("undo", "Hide sphere 1");
    expect_rendered();
    window_.click_widget("row 0");
    window_.click_widget("delete");
    window_.wait_for("spheres", 2);
    expect_rendered();
}

TEST_F(Panels, ANameIsTypedAndItsLettersAreNoShortcuts) {
    window_.click_widget("row 0");
    window_.key("F2");
    window_.widget("rename");
    window_.type("him?");  // hide, inspector, frame of the export, help
    window_.key("Return");
    window_.wait_for("undo", "Rename sphere 0");
    EXPECT_EQ(window_.frame().at("shown").at("inspector"), false);
    EXPECT_EQ(window_.frame().at("shown").at("help"), false);
    expect_rendered();
    EXPECT_TRUE(contains(folder_.read(name_), "\"him?\""));
}

TEST_F(Panels, WindowsOpenAndCloseByKeyAndMenu) {
    const auto shown = [&](const std::string& what, bool is) {
        window_.wait_until(what, [&](const Json& f) { return f.at("shown").at(what) == is; });
    };
    for (const std::string key : {"F1", "question"}) {
        window_.key(key);
        shown("help", true);
        window_.key(key);
        shown("help", false);
    }
    window_.choose("Help", "Keys and mouse");
    shown("help", true);
    window_.key("F1");
    shown("help", false);
    window_.key("i");
    shown("inspector", true);
    window_.move_to(red(0, 60));
    window_.widget("hit 0");
    window_.choose("View", "Pixel inspector");
    shown("inspector", false);

    const Json wide = window_.frame().at("picture_size")[0];
    window_.key("Tab");
    shown("panel", false);
    EXPECT_GT(window_.frame().at("picture_size")[0], wide);
    window_.key("Tab");
    shown("panel", true);
    EXPECT_EQ(window_.frame().at("picture_size")[0], wide);
}

TEST_F(Panels, WidthAndTextSizeCanBeChanged) {
    const int wide = window_.frame().at("picture_size")[0];
    const Place edge = window_.widget("splitter");
    window_.drag(edge, {edge.x - 100, edge.y});
    window_.wait_until("a wider panel", [&](const Json& f) { return f.at("picture_size")[0] == wide - 100; });
    const auto height = [&](const Json& f) {
        const Json& r = f.at("widgets").at("add");
        return r[3].get<double>() - r[1].get<double>();
    };
    const double usual = height(window_.frame());
    window_.key("ctrl+plus");
    window_.wait_until("larger text", [&](const Json& f) { return height(f) > usual; });
    window_.key("ctrl+minus");
    window_.wait_until("usual text", [&](const Json& f) { return height(f) == usual; });
    expect_rendered();
}

TEST(LongList, IsFilteredScrolledAndSelected) {
    const TemporaryFolder folder;
    std::string text = "1000\n";
    for (int i = 0; i < 1000; ++i) {
        text += "255 " + std::to_string(i % 256) + " 0\n" + std::to_string(i % 40 * 5 - 100) + " " +
                std::to_string(i / 40 * 8 - 100) + " 300\n2\n";
    }
    ViewerWindow window(folder, {folder.write("many.txt", text)});
    const Json& widgets = window.frame().at("widgets");
    EXPECT_TRUE(widgets.contains("row 0"));
    EXPECT_FALSE(widgets.contains("row 900")) << "rows out of sight are drawn";
    window.click_widget("filter");
    window.type("sphere 987");
    window.click_widget("row 987");
    window.wait_for("selection", {987});
    window.click_widget("clear filter");
    window.widget("row 0");
    window.click_widget("row 0");
    window.wait_for("selection", {0});
    window.wheel(-20);
    window.wait_until("later rows", [](const Json& frame) { return !frame.at("widgets").contains("row 0"); });
}

TEST_F(Panels, QuickClicksAndKeysAllCount) {
    window_.click_widget("row 0");
    window_.wait_for("selection", {0});
    window_.click_many(window_.widget("hidden"), 11);
    window_.wait_for("undo", "Hide sphere 0");
    for (int i = 0; i < 11; ++i) {
        EXPECT_EQ(window_.frame().at("undo"), i % 2 == 0 ? "Hide sphere 0" : "Show sphere 0");
        const Json revision = window_.frame().at("revision");
        window_.key("ctrl+z");
        window_.wait_until("an undo", [&](const Json& f) { return f.at("revision") != revision; });
    }
    EXPECT_EQ(window_.frame().at("undo"), "");
    window_.key_many("Insert", 20);
    window_.wait_for("spheres", 22);
}

TEST_F(Panels, ARowThatIsDraggedGivesItsSphereAnotherPlace) {
    const Place first = window_.widget("row 0");
    const Place second = window_.widget("row 1");
    window_.drag(first, {second.x, second.y + 0.4 * (second.y - first.y)});
    window_.wait_for("undo", "Reorder sphere 0");
    window_.wait_for("selection", {1});
    window_.key("ctrl+s");
    window_.wait_for("changed", false);
    const std::string saved = folder_.read("scene.toml");
    EXPECT_LT(saved.find("[0, 255, 0]"), saved.find("[255, 0, 0]")) << saved;
    expect_undone();
}

}  // namespace sphereview::test
