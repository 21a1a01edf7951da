// Files: opened, saved, read slowly, changed by other programs; and what closing the window asks.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "support/eventually.hpp"
#include "support/text_match.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

constexpr const char* broken = "1\n255 0 0\n0 0 three\n60\n";
constexpr const char* dirty = "save-changes";  // the question about changes that are not saved

void expect_scene(ViewerWindow& window, const std::string& path, int spheres, bool changed) {
    EXPECT_EQ(window.at("path"), path);
    EXPECT_EQ(window.at("spheres"), spheres);
    EXPECT_EQ(window.at("changed"), changed);
}

void dismiss_error(ViewerWindow& window) {
    answer(window, "error", "OK");
    wait_for_no_dialogs(window);
}

void open_by_browser(ViewerWindow& window, const std::string& path) {
    window.key("ctrl+o");
    choose_file(window, path);
}

bool reads(const Json& f) { return !f.at("loading").is_null() && f.at("widgets").contains("cancel work"); }

}  // namespace

TEST(Files, AreOpenedSavedAndClosedAndNothingIsLost) {
    const TemporaryFolder folder;
    const std::string first = folder.write("first.txt", one_sphere);
    const std::string spaced = folder.write("with spaces/\xC3\xBC\xE2\x82\xAC scene.txt", two_spheres);
    folder.write("broken.txt", broken);
    folder.write("other.txt", "mine\n");
    ViewerWindow window(folder, {first});
    EXPECT_EQ(window.at("title"), "first.txt - sphereview");

    window.step("a drop, the browser and the recent files open");
    ASSERT_TRUE(window.drop({spaced}));
    window.wait_for("path", spaced);
    EXPECT_EQ(window.at("spheres"), 2);
    EXPECT_EQ(window.at("title"), "\xC3\xBC\xE2\x82\xAC scene.txt - sphereview");
    open_by_browser(window, first);
    window.wait_for("path", first);
    EXPECT_EQ(window.at("spheres"), 1);
    window.click_widget("menu File");
    window.click_widget("menu Open recent");
    window.click_widget("recent 1");
    window.wait_for("path", spaced);

    window.step("what cannot be opened says why, and the scene stays");
    for (const char* name : {"broken.txt", "missing.txt"}) {
        ASSERT_TRUE(window.drop({folder.path(name)}));
        dismiss_error(window);
        expect_scene(window, spaced, 2, false);
    }

    window.step("what was opened is remembered at once");
    const std::string settings = folder.path("home/config/sphereview/viewer.json");
    ASSERT_TRUE(eventually([&] {
        return std::filesystem::exists(settings) &&
               Json::parse(folder.read("home/config/sphereview/viewer.json")).value("recent", Json())[0] == spaced;
    }));

    window.step("another scene only when nothing is lost");
    edit(window);
    EXPECT_EQ(window.at("title"), "\xC3\xBC\xE2\x82\xAC scene.txt * - sphereview");
    ASSERT_TRUE(window.drop({first}));
    answer(window, dirty, "Cancel");
    wait_for_no_dialogs(window);
    expect_scene(window, spaced, 3, true);
    window.choose("File", "New");
    answer(window, dirty, "Save");
    window.wait_for("path", "");
    expect_scene(window, "", 0, false);
    EXPECT_EQ(window.at("title"), "untitled - sphereview");
    EXPECT_EQ(lines(folder.read("with spaces/\xC3\xBC\xE2\x82\xAC scene.txt")).front(), "3");
    edit(window);
    ASSERT_TRUE(window.drop({first}));
    answer(window, dirty, "Don't save");
    window.wait_for("path", first);
    expect_scene(window, first, 1, false);

    window.step("a text file that would lose the camera asks");
    window.drag(window.pixel(60, 60), window.pixel(160, 90));
    window.choose("View", "Use this view as the scene's camera");
    window.wait_for("changed", true);
    window.key("ctrl+s");
    answer(window, "text-loses", "Cancel");
    wait_for_no_dialogs(window);
    // A browser that is left without an answer does not make the text file another's format.
    window.key("ctrl+s");
    answer(window, "text-loses", "Save as TOML...");
    window.click_widget("browser cancel");
    wait_for_no_dialogs(window);
    window.key("ctrl+s");
    answer(window, "text-loses", "Save as TOML...");
    window.click_widget("browser ok");
    window.wait_for("path", folder.path("first.toml"));
    EXPECT_EQ(window.at("changed"), false);
    EXPECT_TRUE(contains(folder.read("first.toml"), "camera"));
    EXPECT_EQ(folder.read("first.txt"), one_sphere);
    window.key("ctrl+shift+s");
    choose_file(window, "flat.txt");
    answer(window, "text-loses", "Save all the same");
    window.wait_for("path", folder.path("flat.txt"));
    EXPECT_EQ(lines(folder.read("flat.txt")).size(), lines(one_sphere).size());

    window.step("under its name");
    ASSERT_TRUE(window.drop({first}));
    window.wait_for("path", first);
    edit(window);
    window.key("ctrl+s");
    announced(window, "Saved " + first);
    EXPECT_EQ(window.at("changed"), false);
    EXPECT_EQ(window.at("title"), "first.txt - sphereview");
    EXPECT_EQ(lines(folder.read("first.txt")).front(), "2");

    window.step("another file is replaced only when the person agrees");
    window.key("ctrl+shift+s");
    choose_file(window, "other.txt");
    answer(window, "replace", "Cancel");
    window.wait_for("dialogs", {"browser"});
    EXPECT_EQ(folder.read("other.txt"), "mine\n");
    window.click_widget("browser ok");
    answer(window, "replace", "Replace");
    window.wait_for("path", folder.path("other.txt"));
    EXPECT_EQ(folder.read("other.txt"), folder.read("first.txt"));

    window.step("a folder that is gone: nothing is lost, and it says so");
    window.key("ctrl+shift+s");
    choose_file(window, folder.write("gone/scene.toml", ""));
    answer(window, "replace", "Replace");
    window.wait_for("path", folder.path("gone/scene.toml"));
    edit(window);
    std::filesystem::remove_all(folder.path("gone"));
    window.key("ctrl+s");
    dismiss_error(window);
    EXPECT_EQ(window.at("changed"), true);

    window.step("closing asks once, and may be cancelled");
    window.press_close_button();
    answer(window, dirty, "Cancel");
    wait_for_no_dialogs(window);
    window.press_close_button();
    window.wait_for("dialogs", {dirty});
    const Json asked = window.at("redraw");
    window.press_close_button();
    window.wait_for_other("redraw", asked);
    EXPECT_EQ(window.at("dialogs"), Json::array({dirty}));
    window.key("Escape");
    wait_for_no_dialogs(window);
    window.key("ctrl+q");
    answer(window, dirty, "Don't save");
    EXPECT_EQ(window.wait_for_end().status, 0);
    EXPECT_FALSE(folder.has("gone"));
}

TEST(Closing, SavesAndTheNextStartBringsTheWindowBack) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scenes/scene.txt", one_sphere);
    Json picture;
    {
        ViewerWindow window(folder, {scene});
        const double before = window.at("picture")[2].get<double>();
        const Place edge = window.widget("splitter");
        window.drag(edge, {edge.x - 120, edge.y});
        const auto wider = [&](const Json& f) { return f.at("picture")[2].get<double>() < before - 100; };
        picture = window.wait_until("a wider panel", wider).at("picture");
        edit(window);
        window.press_close_button();
        answer(window, dirty, "Save");
        EXPECT_EQ(window.wait_for_end().status, 0);
        EXPECT_EQ(lines(folder.read("scenes/scene.txt")).front(), "2");
    }
    // All that was written lies in the home folder.
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"home", "redraws.log", "scenes"}));
    EXPECT_TRUE(folder.has("home/config/sphereview"));
    ViewerWindow window(folder, {});
    EXPECT_EQ(window.at("picture"), picture);

    window.step("an untitled scene is saved under a name first");
    edit(window);
    window.key("ctrl+q");
    answer(window, dirty, "Save");
    window.click_widget("browser cancel");
    wait_for_no_dialogs(window);
    EXPECT_EQ(window.at("changed"), true);
    window.key("ctrl+z");
    window.wait_for("changed", false);

    window.step("the recent files are those of the last run");
    window.click_widget("menu File");
    window.click_widget("menu Open recent");
    window.click_widget("recent 0");
    window.wait_for("path", scene);
    EXPECT_EQ(window.at("camera")[0], Json({0.0, 0.0, 0.0}));
    window.choose("File", "New");
    window.wait_for("path", "");
    edit(window);
    window.key("ctrl+q");
    answer(window, dirty, "Save");
    choose_file(window, folder.path("new.toml"));
    EXPECT_EQ(window.wait_for_end().status, 0);
    EXPECT_TRUE(contains(folder.read("new.toml"), "sphere"));
}

TEST(Loading, LeavesTheWindowAliveAndTheSceneAsItWas) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", one_sphere);
    const std::string fifo = folder.path("slow.txt");  // read until its writer goes
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    {
        ViewerWindow window(folder, {fifo});
        EXPECT_TRUE(reads(window.redraw()));
        window.step("alive meanwhile");
        window.key("F1");
        window.wait_meanwhile("the help", [](const Json& f) { return f.at("shown").at("help") == true; });
        window.key("F1");
        window.wait_meanwhile("no help", [](const Json& f) { return f.at("shown").at("help") == false; });

        window.step("cancelled by its button");
        const std::vector<double> sides = window.rectangle("cancel work");
        window.click({(sides[0] + sides[2]) / 2, (sides[1] + sides[3]) / 2});
        window.wait_for("loading", nullptr);
        EXPECT_EQ(window.at("spheres"), 0);

        window.step("another open replaces the one that runs");
        open_by_browser(window, fifo);
        window.wait_meanwhile("reading", reads);
        ASSERT_TRUE(window.drop({scene}));
        window.wait_for("path", scene);
        expect_scene(window, scene, 1, false);
        EXPECT_EQ(window.at("loading"), nullptr);

        window.step("edits that were made meanwhile are asked about");
        open_by_browser(window, fifo);
        window.wait_meanwhile("reading", reads);
        EXPECT_EQ(window.at("spheres"), 1);
        window.key("Insert");
        window.wait_meanwhile("an edit", [](const Json& f) { return f.at("spheres") == 2; });
        std::ofstream(fifo) << two_spheres;
        answer(window, dirty, "Cancel");
        wait_for_no_dialogs(window);
        expect_scene(window, scene, 2, true);

        window.step("Escape ends a reading, and leaves the selection alone");
        window.key("ctrl+z");
        window.wait_for("changed", false);
        window.key("ctrl+a");
        window.wait_for("selection", {0});
        open_by_browser(window, fifo);
        window.wait_meanwhile("reading", reads);
        window.key("Escape");
        window.wait_for("loading", nullptr);
        EXPECT_EQ(window.at("selection"), Json::array({0}));

        window.step("the window's end is a reading's");
        open_by_browser(window, fifo);
        window.wait_meanwhile("reading", reads);
        window.press_close_button();
        EXPECT_EQ(window.wait_for_end().status, 0);
    }
    ViewerWindow window(folder, {fifo});
    EXPECT_TRUE(reads(window.redraw()));
    window.step("what is wrong is said late");
    std::ofstream(fifo) << broken;
    dismiss_error(window);
    EXPECT_EQ(window.at("spheres"), 0);
    window.step("the scene is taken when it is there");
    open_by_browser(window, fifo);
    window.wait_meanwhile("reading", reads);
    std::ofstream(fifo) << two_spheres;
    window.wait_for("spheres", 2);
    EXPECT_EQ(window.at("loading"), nullptr);
    EXPECT_EQ(window.at("changed"), false);
    window.step("a signal ends a reading");
    open_by_browser(window, fifo);
    window.wait_meanwhile("reading", reads);
    window.send(SIGTERM);
    EXPECT_EQ(window.wait_for_end().status, 128 + SIGTERM);
}

TEST(Reloading, ShowsWhatAnotherProgramWrites) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", two_spheres);
    ViewerWindow window(folder, {scene});
    window.key("m");  // the mark of the export is drawn over the picture

    window.step("the view and the selection stay");
    window.key("ctrl+a");
    window.wait_for("selection", {0, 1});
    const Json home = window.at("camera");
    window.drag(window.pixel(60, 60), window.pixel(160, 90));
    const Json view = window.wait_for_other("camera", home);
    replace_by_rename(folder, "scene.txt", std::string("3") + (two_spheres + 1) + "0 0 255\n-100 0 300\n30\n");
    window.wait_for("spheres", 3);
    EXPECT_EQ(window.at("camera"), view);
    EXPECT_EQ(window.at("selection"), Json({0, 1}));
    EXPECT_EQ(window.at("changed"), false);
    folder.write("scene.txt", one_sphere);  // in place
    window.wait_for("spheres", 1);
    EXPECT_EQ(window.at("camera"), view);
    EXPECT_EQ(window.at("selection"), Json::array({0}));

    // A reload is a step like any other; what was there before it is not what the file holds.
    window.key("ctrl+z");
    window.wait_for("spheres", 3);
    EXPECT_EQ(window.at("changed"), true);
    window.key("ctrl+y");
    window.wait_for("spheres", 1);
    EXPECT_EQ(window.at("changed"), false);

    window.step("the last good scene stays while the file is broken");
    folder.write("scene.txt", broken);
    announced(window, "scene.txt:3:5: ", "scene_error");
    EXPECT_TRUE(window.draws("message scene error"));
    EXPECT_EQ(window.at("spheres"), 1);
    // However long the word is that cannot be read, the message has its end in the window.
    replace_by_rename(folder, "scene.txt", "1\n255 0 " + std::string(100'000, 'x'));
    announced(window, "scene.txt:2:7: ", "scene_error");
    window.widget("message scene error");
    EXPECT_LT(window.rectangle("message scene error")[3], window.at("picture")[3].get<double>());
    replace_by_rename(folder, "scene.txt", two_spheres);
    window.wait_for("spheres", 2);
    EXPECT_EQ(window.at("scene_error"), "");
    EXPECT_FALSE(window.draws("message scene error"));
    window.key("Home");
    window.wait_for("camera", home);
    expect_rendered(window, folder, scene);

    window.step("a file that is gone is said, and that it is back");
    std::filesystem::remove(scene);
    window.wait_for("changed", true);
    EXPECT_TRUE(window.draws("message scene gone"));
    folder.write("scene.txt", two_spheres);
    announced(window, "is there again");
    EXPECT_FALSE(window.draws("message scene gone"));
    EXPECT_EQ(window.at("changed"), false);
    window.key("Escape");
    window.wait_for("announcement", "");

    window.step("changes here are asked about");
    edit(window);
    replace_by_rename(folder, "scene.txt", one_sphere);
    answer(window, "reload", "Keep mine");
    wait_for_no_dialogs(window);
    EXPECT_EQ(window.at("spheres"), 3);
    EXPECT_EQ(window.at("changed"), true);
    // Broken and then good again: the complaint goes although the changes stay.
    folder.write("scene.txt", "1\n");
    window.wait_for_other("scene_error", "");
    folder.write("scene.txt", one_sphere);
    window.wait_for("dialogs", {"reload"});
    EXPECT_EQ(window.at("scene_error"), "");
    // Changed once more before the answer: asked once, of what the file holds now.
    replace_by_rename(folder, "scene.txt", "0\n");
    window.wait_for_other("redraw", window.at("redraw"));
    answer(window, "reload", "Reload the file");
    window.wait_for("spheres", 0);
    wait_for_no_dialogs(window);
    EXPECT_EQ(window.at("changed"), false);
    window.key("ctrl+z");
    window.wait_for("spheres", 3);

    window.step("the window's own save is no change");
    window.key("ctrl+s");
    announced(window, "Saved ");
    edit(window);
    // The next change from outside comes after whatever the save could have caused.
    folder.write("scene.txt", "broken");
    window.wait_for_other("scene_error", "");
    EXPECT_EQ(window.at("dialogs"), Json::array());
    EXPECT_EQ(window.at("spheres"), 4);
    EXPECT_EQ(window.at("undo"), "Add sphere 3");
}

}  // namespace sphereview::test
