// Ends that nobody asked for, and shaders that are edited while the program runs.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>

#include "support/folders.hpp"
#include "support/text_match.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

// Waits until the running window has kept its changes, or has forgotten them.
void wait_for_kept(ViewerWindow& window, const TemporaryFolder& folder, bool kept) {
    window.wait_until(kept ? "changes that are kept" : "no changes that are kept",
                      [&](const Json&) { return kept == !kept_changes(folder).empty(); });
}

void kill(ViewerWindow& window) {
    window.send(SIGKILL);
    window.wait_for_end();
}

}  // namespace

// The file of the unsaved changes becomes a pipe that nobody reads: whoever writes there waits for good.
TEST(Recovery, OnADiskThatHangsDoesNotKeepASignalFromEndingTheWindow) {
    const TemporaryFolder folder;
    ViewerWindow window(folder, {folder.write("scene.txt", one_sphere)});
    edit(window);
    wait_for_kept(window, folder, true);
    const std::string kept = folder.path(kept_file(folder));
    std::filesystem::remove(kept);
    ASSERT_EQ(mkfifo(kept.c_str(), 0600), 0);
    edit(window);
    window.send(SIGTERM);
    const Outcome outcome = window.wait_for_end();
    EXPECT_EQ(outcome.status, 128 + SIGTERM) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "the folder of unsaved changes does not answer")) << outcome;
}

// Each start offers what the last end has kept.
TEST(Recovery, OffersChangesUntilTheyAreSavedOrDiscarded) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", one_sphere);
    {
        ViewerWindow window(folder, {scene});
        window.step("a display that is lost");
        edit(window);
        window.server().kill();
        const Outcome outcome = window.wait_for_end();
        EXPECT_EQ(outcome.status, 3) << outcome;
        ASSERT_EQ(lines(outcome.errors).size(), 1U) << outcome;
        EXPECT_TRUE(contains(outcome.errors, "sphereview render"));
        EXPECT_TRUE(contains(outcome.errors, "doctor"));
        EXPECT_TRUE(contains(outcome.errors, "unsaved changes of scene.txt are kept"));
        EXPECT_EQ(folder.read("scene.txt"), one_sphere);
    }
    {
        ViewerWindow window(folder, {});
        window.step("later");
        answer(window, "recover", "Later");
        wait_for_no_dialogs(window);
        window.send(SIGTERM);  // nothing new to keep
        EXPECT_EQ(window.wait_for_end().errors, "");
    }
    for (const bool saved : {false, true}) {  // what was recovered is not lost either
        ViewerWindow window(folder, {});
        window.step("recovered");
        answer(window, "recover", "Recover");
        window.wait_for("spheres", 2);
        EXPECT_EQ(window.at("path"), scene);
        EXPECT_EQ(window.at("changed"), true);
        if (saved) {
            window.key("ctrl+s");
            announced(window, "Saved " + scene);
            EXPECT_EQ(lines(folder.read("scene.txt")).front(), "2");
            wait_for_kept(window, folder, false);
        }
        kill(window);
    }
    {
        ViewerWindow window(folder, {scene});
        window.step("a killed window");
        EXPECT_EQ(window.at("dialogs"), Json::array());
        edit(window);
        wait_for_kept(window, folder, true);
        kill(window);
    }
    {
        ViewerWindow window(folder, {});
        window.step("a terminated window");
        answer(window, "recover", "Recover");
        window.wait_for("spheres", 3);
        window.choose("File", "New");
        answer(window, "save-changes", "Don't save");
        window.wait_for("spheres", 0);
        edit(window);
        window.send(SIGTERM);
        EXPECT_EQ(window.wait_for_end().status, 128 + SIGTERM);
    }
    {
        ViewerWindow window(folder, {});
        window.step("a window that hangs");
        answer(window, "recover", "Recover");
        window.wait_for("spheres", 1);
        edit(window);
        window.server().hang();
        window.send(SIGTERM);
        const Outcome outcome = window.wait_for_end();
        EXPECT_EQ(outcome.status, 128 + SIGTERM);
        EXPECT_TRUE(contains(outcome.errors, "unsaved changes of untitled are kept")) << outcome;
    }
    {
        ViewerWindow window(folder, {});
        window.step("discarded");
        answer(window, "recover", "Discard");
        wait_for_no_dialogs(window);
        EXPECT_EQ(window.at("spheres"), 0);
        window.press_close_button();
        EXPECT_EQ(window.wait_for_end().status, 0);
    }
    ViewerWindow window(folder, {});
    EXPECT_EQ(window.at("dialogs"), Json::array());
}

TEST(Recovery, SaysWhatItCannotOffer) {
    const TemporaryFolder folder;
    const std::string name = "home/state/sphereview/recovery-1";
    folder.write(name + ".toml", "# sphereview recovery, milliseconds since 1970: 1\n# of: /a\n");
    std::filesystem::create_directory(folder.path(name + ".lock"));  // it cannot be asked, as where a file system cannot lock
    ViewerWindow window(folder, {});
    EXPECT_EQ(window.at("dialogs"), Json::array());
    window.press_close_button();
    const Outcome outcome = window.wait_for_end();
    EXPECT_EQ(outcome.status, 0);
    ASSERT_EQ(lines(outcome.errors).size(), 1U) << outcome;
    EXPECT_TRUE(contains(outcome.errors, folder.path(name + ".toml: these unsaved changes are not offered"))) << outcome;
}

TEST(Recovery, OfAForgedNameIsToldOnOneLine) {
    const TemporaryFolder folder;
    folder.write("home/state/sphereview/recovery-1.toml",
                 "# sphereview recovery, milliseconds since 1970: 1\n# of: /a%0AFORGED.toml\nbackground = 'white'\n");
    ViewerWindow window(folder, {});
    answer(window, "recover", "Recover");
    EXPECT_EQ(announced(window, "Recovered"), "Recovered the unsaved changes of a\\x0aFORGED.toml");
}

// Nobody reads what the window's end would write there.
TEST(Settings, ThatAreAFifoAreNotWaitedFor) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path("home/config/sphereview"));
    ASSERT_EQ(mkfifo(folder.path("home/config/sphereview/viewer.json").c_str(), 0600), 0);
    const std::string scene = folder.write("scene.txt", one_sphere);
    for (const bool by_signal : {false, true}) {
        // By no settings the picture is lit, with 16 samples a pixel, which takes a sanitized program minutes.
        ViewerWindow window(folder, {scene, "--shade", "flat", "--samples", "1"});
        by_signal ? window.send(SIGTERM) : window.key("ctrl+q");
        const Outcome outcome = window.wait_for_end();
        EXPECT_EQ(outcome.status, by_signal ? 128 + SIGTERM : 0) << outcome;
        EXPECT_EQ(outcome.errors, "");
    }
}

// A saved shader is in the picture at once, a broken one leaves the last good one.
TEST(LiveShaders, AreInThePictureWhenSaved) {
    const TemporaryFolder folder;
    const std::string shaders = folder.path("shaders");
    std::filesystem::copy(source_file("shaders"), shaders, std::filesystem::copy_options::recursive);
    const std::string good = folder.read("shaders/shade.frag");
    const std::string scene = folder.write("scene.txt", two_spheres);
    ViewerWindow window(folder, {scene, "--shader-dir", shaders});
    window.key("m");
    window.move_to({5, 5});
    const auto shows = [&](const Picture& picture, bool same) {
        window.wait_until("the picture", [&](const Json& f) {
            return f.at("hovered").is_null() && static_cast<bool>(same_picture(window.picture(), picture)) == same;
        });
    };
    window.wait_until("no marks", [](const Json& f) { return f.at("hovered").is_null(); });
    // The live picture by those shaders, not the export: doubtful pixels show a guess.
    const Picture first = window.picture();
    EXPECT_EQ(window.at("exact"), false);

    const std::size_t end = good.rfind('}');
    ASSERT_NE(end, std::string::npos);
    folder.write("shaders/shade.frag", good.substr(0, end) + "    color = vec4(0.25, 0.5, 0.75, 1.0);\n}\n");
    shows(first, false);
    EXPECT_EQ(window.at("shader_error"), "");
    const Picture changed = window.picture();

    folder.write("shaders/shade.frag", "#version 330 core\nnonsense\n");
    announced(window, "shade.frag:2", "shader_error");
    window.click_widget("close shader error");
    window.wait_for("shader_error", "");
    shows(changed, true);

    folder.write("shaders/shade.frag", good);
    shows(first, true);
    EXPECT_EQ(window.at("shader_error"), "");

    window.step("a double click counts however slow redraws are");
    for (int rounds = 500; window.at("seconds").get<double>() < 0.4; rounds *= 2) {
        const Json shown = window.at("redraw");
        folder.write("shaders/shade.frag",
                     good.substr(0, end) + "for (int i = 0; i < " + std::to_string(rounds) + "; ++i) color.r = sin(color.r);\n}\n");
        window.wait_for_other("redraw", shown);
    }
    const Json home = window.at("camera");
    window.double_click(window.on_screen(100.0 / 3, 0));
    window.wait_for_other("camera", home);
}

}  // namespace sphereview::test
