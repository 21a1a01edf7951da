// What hands do: the list, the buttons, the keys and the menus; the mouse in the picture; many spheres at once.
#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <thread>

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
    // Each of so many inputs, faster than redraws, is a step that is undone alone.
    void expect_steps(int count, const std::function<void()>& act) {
        const double before = window_.at("revision").get<double>();
        act();
        window_.wait_for("revision", before + count);
        window_.key_many("ctrl+z", count);
        window_.wait_for("undo", "");
        EXPECT_EQ(window_.at("revision"), before + 2 * count);
        EXPECT_EQ(window_.at("changed"), false);
    }
    void wait_for_shown(const std::string& what, bool is) {
        window_.wait_until(what, [&](const Json& f) { return f.at("shown").at(what) == is; });
    }
};

class Pointer : public Editing {
protected:
    std::string saved() {
        window_.key("ctrl+s");
        window_.wait_for("changed", false);
        return folder_.read(name_);
    }
    std::vector<double> saved_numbers() {
        std::istringstream text(saved());
        std::vector<double> numbers;
        for (double number = 0.0; text >> number;) numbers.push_back(number);
        return numbers;
    }
    Place at(double x, double y) { return window_.on_screen(x, y); }
    void wait_for_shown_inspector(bool is) {
        window_.wait_until("the inspector", [&](const Json& f) { return f.at("shown").at("inspector") == is; });
    }
    void click_with_ctrl(const Place& place) {
        window_.key_down("ctrl");
        window_.click(place);
        window_.key_up("ctrl");
    }
};

}  // namespace

TEST_F(Panels, DoWhatButtonsMenusAndKeysSay) {
    // One way each: tests/panels has every button, key and menu item.
    const std::vector<std::tuple<std::string, int, std::function<void()>>> commands = {
        {"Duplicate sphere 0", 3, [&] { window_.click_widget("duplicate"); }},
        {"Delete sphere 0", 1, [&] { window_.key("Delete"); }},
        {"Hide sphere 0", 2, [&] { window_.click_widget("row 0 eye"); }},
        {"Move sphere 0 down", 2, [&] { window_.choose("Edit", "Move down"); }},
    };
    for (const auto& [undo, spheres, act] : commands) {
        window_.step(undo);
        SCOPED_TRACE(undo);
        select(0);
        act();
        window_.wait_for("undo", undo);
        EXPECT_EQ(window_.at("spheres"), spheres);
        expect_undone();
    }

    window_.step("windows open and close by key and menu");
    for (const std::string key : {"F1", "question"}) {
        window_.key(key);
        wait_for_shown("help", true);
        window_.key(key);
        wait_for_shown("help", false);
    }
    window_.key("i");
    wait_for_shown("inspector", true);
    window_.move_to(red(40, 25));
    window_.widget("hit 0");
    const double explanations = window_.at("explanations").get<double>();
    EXPECT_GT(explanations, 0);
    const double drawn = window_.at("redraw").get<double>();
    window_.key("Shift_L");
    window_.wait_until("a redraw in which nothing is new", [&](const Json& f) { return f.at("redraw").get<double>() > drawn; });
    EXPECT_EQ(window_.at("explanations").get<double>(), explanations);
    window_.choose("View", "Pixel inspector");
    wait_for_shown("inspector", false);
    const double wide = window_.at("picture_size")[0].get<double>();
    window_.key("Tab");
    wait_for_shown("panel", false);
    EXPECT_GT(window_.at("picture_size")[0].get<double>(), wide);
    window_.key("Tab");
    wait_for_shown("panel", true);
    EXPECT_EQ(window_.at("picture_size")[0], wide);

    window_.step("the panel's width and the text's size");
    const Place edge = window_.widget("splitter");
    window_.drag(edge, {edge.x - 100, edge.y});
    window_.wait_until("a wider panel", [&](const Json& f) { return f.at("picture_size")[0] == wide - 100; });
    const auto height = [&] { return window_.rectangle("add")[3] - window_.rectangle("add")[1]; };
    const double usual = height();
    window_.key("ctrl+plus");
    window_.wait_until("larger text", [&](const Json&) { return height() > usual; });
    window_.key("ctrl+minus");
    window_.wait_until("usual text", [&](const Json&) { return height() == usual; });
    expect_rendered();

    window_.step("quick clicks and keys");
    const Place eye = window_.widget("row 0 eye");
    expect_steps(11, [&] { window_.click_many(eye, 11); });
    expect_steps(12, [&] { window_.key_many("Insert", 12); });

    window_.step("a row that is dragged");
    const Place first = window_.widget("row 0");
    const Place second = window_.widget("row 1");
    window_.drag(first, {second.x, second.y + 0.4 * (second.y - first.y)});
    window_.wait_for("undo", "Reorder sphere 0");
    window_.wait_for("selection", {1});
    window_.key("ctrl+s");
    window_.wait_for("changed", false);
    const std::string saved = folder_.read(name_);
    EXPECT_LT(saved.find("[0, 255, 0]"), saved.find("[255, 0, 0]")) << saved;
    expect_undone();

    window_.step("a name is typed, and its letters are no shortcuts");
    select(0);
    window_.key("F2");
    window_.widget("rename");
    window_.type("him?");  // hide, inspector, mark of the export, help
    window_.key("Return");
    window_.wait_for("undo", "Rename sphere 0");
    EXPECT_EQ(window_.at("shown").at("inspector"), false);
    EXPECT_EQ(window_.at("shown").at("help"), false);
    expect_rendered();
    EXPECT_TRUE(contains(folder_.read(name_), "\"him?\""));

    window_.step("what a button does is in the picture");
    window_.click_widget("add");
    window_.wait_for("spheres", 3);
    select(1);
    window_.click_widget("hide");
    window_.wait_for("undo", "Hide sphere 1");
    select(0);
    window_.click_widget("delete");
    window_.wait_for("spheres", 2);
    expect_rendered();

    window_.key("alt+6");
    window_.wait_for("samples", 16);
    // An idle window draws nothing. Nothing to wait for: what is to happen is nothing, for a second. The server may still
    // have had something to say before.
    window_.move_to(red());
    Json last;
    double before = 0.0;
    for (int i = 0; i < 10 && last != window_.at("redraw"); ++i) {
        last = window_.at("redraw");
        before = window_.processor_seconds();
        std::this_thread::sleep_for(std::chrono::seconds(1));
    }
    EXPECT_EQ(window_.at("redraw"), last);
    EXPECT_LT(window_.processor_seconds() - before, 0.04);  // two ticks of the clock in which it is counted, and some
}

TEST_F(Pointer, DragsSlidersAndTypesValues) {
    take_marks_away(window_);
    const Picture before = window_.picture();
    const auto changed = [](const Json& f) { return f.at("undo") != ""; };
    for (const std::string slider : {"slider z", "slider radius"}) {
        window_.step(slider);
        SCOPED_TRACE(slider);
        select(0);
        const Place from = window_.widget(slider);
        window_.drag(from, {from.x - 25, from.y});
        window_.wait_until("a step", changed);
        take_marks_away(window_);
        EXPECT_FALSE(same_picture(window_.picture(), before));
        window_.key("ctrl+z");  // one step
        window_.wait_for("undo", "");
        take_marks_away(window_);
        EXPECT_TRUE(same_picture(window_.picture(), before));
        window_.key("ctrl+shift+z");
        window_.wait_for("redo", "");
        expect_rendered();
        window_.key("ctrl+z");
        window_.wait_for("undo", "");
    }
    EXPECT_EQ(saved(), two_spheres);
    window_.step("a typed value");
    select(1);
    click_with_ctrl(window_.widget("slider x"));
    window_.widget("slider x");
    window_.key("ctrl+a");
    window_.type("-40.125");
    window_.key("Return");
    window_.wait_until("a step", changed);
    expect_rendered();
    EXPECT_TRUE(contains(folder_.read(name_), "-40.125 0 300"));
    window_.step("a value that is typed at once, and saved before it is entered");
    select(1);
    window_.click_widget("slider x");
    window_.key("ctrl+a");
    window_.type("12.5");
    window_.key("ctrl+s");
    window_.wait_until("what was typed is saved", [&](const Json& f) {
        return f.at("changed") == false && folder_.read(name_).find("12.5 0 300") != std::string::npos;
    });
    EXPECT_EQ(window_.at("spheres"), 2);
}

TEST_F(Pointer, MovesSizesAndSelectsSpheres) {
    window_.step("a drag moves a sphere under the pointer");
    select_red();
    window_.drag(at(0, 0), at(-20, 10));
    window_.wait_for("undo", "Move sphere 0");
    std::vector<double> numbers = saved_numbers();
    // What was grabbed, at z = 240, follows the pointer: 20 on the screen, at z = 100, is 48 there.
    EXPECT_NEAR(numbers[4], -48.0, 1.5);
    EXPECT_NEAR(numbers[5], 24.0, 1.5);
    EXPECT_EQ(numbers[6], 300.0);
    expect_rendered();
    window_.key("ctrl+z");
    window_.wait_for("undo", "");
    expect_rendered();
    EXPECT_EQ(folder_.read(name_), two_spheres);

    window_.step("with shift in depth");
    select_red();
    window_.drag(at(0, 0), at(0, 15), 1, {"shift"});
    window_.wait_for("undo", "Move sphere 0");
    numbers = saved_numbers();
    EXPECT_EQ(numbers[4], 0.0);
    EXPECT_GT(numbers[6], 400.0);  // up is away
    window_.key("ctrl+z");
    window_.wait_for("undo", "");
    saved();

    window_.step("a panel that opens under a pointer that rests moves nothing");
    select_red();
    window_.move_to(at(0, 0));
    window_.press();
    window_.key("i");
    wait_for_shown_inspector(true);
    window_.release();
    window_.key("i");
    wait_for_shown_inspector(false);
    EXPECT_EQ(window_.at("undo"), "");
    EXPECT_EQ(window_.at("changed"), false);

    window_.step("Escape takes a drag back");
    window_.move_to(at(0, 0));
    window_.press();
    window_.move_to(at(-10, 0));
    window_.move_to(at(-20, 0));
    window_.wait_for("undo", "Move sphere 0");
    window_.key("Escape");
    window_.wait_for("undo", "");
    window_.move_to(at(10, 0));
    window_.release();
    window_.wait_for("selection", {0});
    EXPECT_EQ(window_.at("changed"), false);

    window_.step("Alt opens the menus, arrows move in them, and Escape closes what is on top alone");
    const auto shows = [](const std::string& item, bool shown = true) {
        return [item, shown](const Json& f) { return f.at("widgets").contains(item) == shown; };
    };
    window_.key("Alt_L");
    window_.wait_until("a menu", shows("item New"));
    window_.key("Right");
    window_.wait_until("the next menu", shows("item Undo"));
    window_.key("Escape");
    window_.wait_until("no menu", shows("item Undo", false));
    EXPECT_EQ(window_.at("selection"), Json::array({0}));
    window_.key("Alt_L");
    window_.wait_until("a menu", shows("item New"));
    for (const std::string item : {"item Undo", "item Go home", "item Keys and mouse"}) {
        window_.key("Right");
        window_.wait_until("the next menu", shows(item));
    }
    window_.keys({"Down", "Up", "Return"});
    window_.wait_until("the help", [](const Json& f) { return f.at("shown").at("help") == true; });
    window_.key("Escape");
    window_.wait_until("no help", [](const Json& f) { return f.at("shown").at("help") == false; });
    EXPECT_EQ(window_.at("selection"), Json::array({0}));

    window_.step("a sphere goes to the clipboard and back");
    window_.keys({"ctrl+c", "ctrl+v"});
    window_.wait_for("spheres", 3);
    EXPECT_EQ(window_.at("undo"), "Paste 1 sphere");
    window_.key("ctrl+z");
    window_.wait_for("spheres", 2);

    // In a row from left to right, the fourth behind the third; two of them blue.
    const std::string five_spheres =
        "5\n255 0 0\n-100 0 300\n25\n0 0 255\n-40 0 300\n25\n0 255 0\n20 0 300\n25\n255 255 0\n40 0 600\n20\n"
        "0 0 255\n100 0 300\n25\n";
    name_ = "five.txt";
    ASSERT_TRUE(window_.drop({folder_.write(name_, five_spheres)}));
    window_.wait_for("spheres", 5);

    window_.step("a box selects what is seen in it");
    const Json camera = window_.at("camera");
    window_.drag(at(-20, 20), at(12, -20), 1, {"ctrl"});
    window_.wait_for("selection", {1, 2});  // not the yellow one behind
    window_.drag(at(25, -20), at(48, 20), 1, {"ctrl", "shift"});
    window_.wait_for("selection", {1, 2, 4});
    window_.drag(at(4, 5), at(8, -5), 1, {"ctrl", "shift"});
    window_.wait_for("selection", {1, 4});
    click_with_ctrl(at(-33, 0));
    window_.wait_for("selection", {0, 1, 4});
    click_with_ctrl(at(-33, 0));
    window_.wait_for("selection", {1, 4});
    EXPECT_EQ(window_.at("camera"), camera);
    EXPECT_EQ(window_.at("changed"), false);
    window_.drag(at(-48, 45), at(48, 40), 1, {"ctrl"});
    window_.wait_for("selection", Json::array());

    window_.step("the background selects none");
    window_.click(at(-13, 0));
    window_.wait_for("selection", {1});
    window_.click(window_.pixel(20, 20));
    window_.wait_for("selection", Json::array());
}

}  // namespace sphereview::test
