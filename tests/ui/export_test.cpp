// Pictures written from the window and the picture at rest: the very bytes of `render`, in every shading mode and with any samples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "support/render.hpp"
#include "support/text_match.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

class PictureAtRest : public Editing {
protected:
    PictureAtRest() : Editing("scene.txt", {.width = 700, .height = 800}) {}

    // The window at rest shows the file's scene so.
    void expect_rest(int samples, const std::string& shading = "flat") {
        SCOPED_TRACE(shading + " with " + std::to_string(samples));
        window_.wait_until("such a picture", [&](const Json& f) {
            return f.at("samples") == samples && f.at("shading") == shading && f.at("exact") == true;
        });
        expect_rendered();
    }

    // Waits until the samples are those of another scene, and returns its first redraw.
    Json wait_for_another(const Json& revision) {
        const auto is_other = [&](const Json& f) { return f.at("revision") != revision && f.at("samples") == 4; };
        const Json found = window_.wait_until("another picture", is_other).at("revision");
        for (const Json& redraw : logged_redraws(folder_)) {
            if (redraw.at("revision") == found) return redraw;
        }
        throw std::runtime_error("no such redraw");
    }
};

}  // namespace

TEST(Exporting, WritesTheBytesOfRenderAndReplacesNothing) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", two_spheres);
    folder.write("scene.png", "mine");
    ViewerWindow window(folder, {scene});
    window.drag(window.pixel(60, 60), window.pixel(160, 90));
    window.key("F12");
    EXPECT_TRUE(contains(announced(window, "Exported"), folder.path("scene-1.png") + " (1000 x 1000)"));
    EXPECT_EQ(folder.read("scene.png"), "mine");
    // Again, with everything marked, under the next name.
    window.key("ctrl+a");
    window.wait_for("selection", {0, 1});
    window.key("F12");
    announced(window, folder.path("scene-2.png"));
    EXPECT_EQ(folder.read("scene-2.png"), folder.read("scene-1.png"));

    window.choose("View", "Use this view as the scene's camera");
    window.wait_for("changed", true);
    window.key("ctrl+shift+s");
    choose_file(window, "viewed.toml");
    window.wait_for("path", folder.path("viewed.toml"));
    for (const char* backend : {"cpu", "egl"}) {
        EXPECT_EQ(folder.read("scene-1.png"), render_bytes(folder, folder.path("viewed.toml"), {"--backend", backend}));
    }
    EXPECT_NE(folder.read("scene-1.png"), render_bytes(folder, scene, {}));

    // By name and size; a name that is taken asks.
    window.key("ctrl+e");
    window.wait_for("dialogs", Json::array({"export"}));
    window.click_widget("browser name");
    window.key("ctrl+a");
    window.type("scene.png");
    window.click_widget("export sizes");
    window.click_widget("export 1920 x 1080");
    window.click_widget("browser ok");
    answer(window, "replace", "Cancel");
    window.wait_for("dialogs", Json::array({"export"}));
    EXPECT_EQ(folder.read("scene.png"), "mine");
    window.click_widget("browser ok");
    answer(window, "replace", "Replace");
    announced(window, "1920 x 1080");
    EXPECT_EQ(folder.read("scene.png"), render_bytes(folder, folder.path("viewed.toml"), {"-s", "1920x1080"}));
}

// So large that nobody need hurry to meet it at work.
TEST(Exporting, LeavesTheWindowAliveAndCanBeCancelled) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", two_spheres);
    ViewerWindow window(folder, {scene, "--size", "12000x12000", "--samples", "16"});
    window.key("F12");
    const auto exports = [](const Json& f) { return !f.at("exporting").is_null() && f.at("widgets").contains("cancel work"); };
    window.wait_meanwhile("an export", exports);
    window.key("Insert");
    window.wait_meanwhile("an edit", [&](const Json& f) { return f.at("spheres") == 3 && exports(f); });
    window.key("ctrl+z");
    window.wait_meanwhile("an undo", [&](const Json& f) { return f.at("spheres") == 2 && exports(f); });
    window.key("Escape");
    window.wait_for("exporting", nullptr);
    window.wait_for("exact", true);
    EXPECT_FALSE(std::filesystem::exists(folder.path("scene.png")));

    // The window closes when the file is whole, or the export is given up.
    window.key("F12");
    window.wait_meanwhile("another export", exports);
    window.key("ctrl+q");
    window.key("Escape");
    window.wait_for("exporting", nullptr);
    window.key("ctrl+q");
    EXPECT_EQ(window.wait_for_end().status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder.path("scene.png")));
}

// By the view in the window: the bytes of `render --frames`.
TEST(Exporting, MakesPicturesOfAllFrames) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("a.xyz", "2\n\nO 0 0 0\nN 3 0 0\n2\n\nO 0 1 0\nN 3 0 0\n");
    ViewerWindow window(folder, {scene, "--size", "64x48"});
    window.drag(window.pixel(10, 10), window.pixel(90, 30), 3);
    window.key("shift+F12");
    window.wait_for("dialogs", Json::array({"film"}));
    window.click_widget("browser kind");
    window.click_widget("browser kind Pictures (.png)");
    window.click_widget("browser ok");
    announced(window, "a-{frame:05}.png (2 pictures, 64 x 48)");
    EXPECT_EQ(window.at("filming"), nullptr);

    window.choose("View", "Use this view as the scene's camera");
    window.wait_for("changed", true);
    window.key("ctrl+shift+s");
    choose_file(window, "viewed.toml");
    window.wait_for("path", folder.path("viewed.toml"));
    const Outcome rendered = run(cpu_render(folder, {scene, "--frames", "all", "--camera", folder.path("viewed.toml"),
                                                     "--background", "#202430", "-s", "64x48", "-o", "r-{frame:05}.png"}));
    EXPECT_EQ(rendered.status, 0) << rendered;
    for (const char* number : {"00000.png", "00001.png"}) {
        EXPECT_EQ(folder.read(std::string("a-") + number), folder.read(std::string("r-") + number));
    }
    EXPECT_NE(folder.read("a-00000.png"), folder.read("a-00001.png"));
}

TEST(Exporting, EndsBeforeTheWindowDoes) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", two_spheres);
    ViewerWindow window(folder, {scene, "--size", "2000x2000"});
    window.keys({"F12", "ctrl+q"});
    EXPECT_EQ(window.wait_for_end().status, 0);
    EXPECT_EQ(folder.read("scene.png"), render_bytes(folder, scene, {"-s", "2000x2000"}));
}

TEST(Exporting, SaysWhyItCannotWriteAndLeavesNothing) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("gone/scene.txt", two_spheres);
    ViewerWindow window(folder, {scene});
    std::filesystem::remove_all(folder.path("gone"));
    const std::vector<std::string> before = folder.names();
    window.key("F12");
    answer(window, "error", "OK");
    wait_for_no_dialogs(window);
    EXPECT_EQ(window.at("announcement"), "");
    EXPECT_EQ(folder.names(), before);
}

TEST(Exporting, PutsAnUntitledPictureIntoThePicturesFolder) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path("home/Pictures"));
    ViewerWindow window(folder, {"-", "--size", "64x48", "--background", "white"}, {}, two_spheres);
    EXPECT_EQ(window.at("title"), "untitled - sphereview");
    EXPECT_EQ(window.at("spheres"), 2);
    window.key("F12");
    announced(window, folder.path("home/Pictures/untitled.png") + " (64 x 48)");
    const std::string scene = folder.write("scene.txt", two_spheres);
    EXPECT_EQ(folder.read("home/Pictures/untitled.png"), render_bytes(folder, scene, {"-s", "64x48", "--background", "white"}));
}

TEST_F(PictureAtRest, IsWhatRenderWritesInEveryMode) {
    window_.choose("View", "4 samples a pixel");
    expect_rest(4);
    window_.click_widget("menu View");
    window_.click_widget("menu Shading");
    window_.click_widget("item Headlight");
    expect_rest(4, "headlight");
    window_.key("F12");
    announced(window_, "scene.png");
    EXPECT_EQ(folder_.read("scene.png"), render_bytes(folder_, scene_, {"--shade", "headlight", "--samples", "4"}));
    window_.key("alt+6");
    expect_rest(16, "headlight");
    window_.key("alt+1");
    for (const auto& [key, mode] :
         {std::pair{"ctrl+3", "normal"}, {"ctrl+4", "depth"}, {"ctrl+5", "id"}, {"ctrl+6", "studio"}, {"ctrl+1", "flat"}}) {
        window_.key(key);
        expect_rest(1, mode);
    }
}

TEST_F(PictureAtRest, GivesWayToTheLivePictureAndComesBack) {
    window_.key("alt+4");
    expect_rest(4);
    select_red();
    Json revision = window_.at("revision");
    const Place from = window_.widget("slider x");
    window_.move_to(from);
    window_.press();
    for (const double right : {-25.0, -40.0}) {  // it refines also while the button is held, when the hand rests
        window_.move_to({from.x + right, from.y});
        const Json first = wait_for_another(revision);
        EXPECT_EQ(first.at("samples"), 1) << "at once, as without anti-aliasing";
        revision = first.at("revision");
    }
    window_.release();
    expect_rest(4);
    window_.key("ctrl+z");
    wait_for_another(revision);
    expect_rest(4);
}

// Spheres around the eye that differ in the last bit of their radii, in the light of 1,024 lamps: a picture with 16 samples takes
// minutes. All that is looked at is what happens before it is made.
TEST(HardPicture, IsMadeWhileTheWindowAnswersAndKeepsEdits) {
    constexpr int many = 50;
    std::ostringstream spheres;
    spheres.precision(17);
    double radius = 150.0;
    for (int i = 0; i < many; ++i, radius = std::nextafter(radius, 200.0)) {
        spheres << "[[sphere]]\ncenter = [0, 0, 0]\nradius = " << radius << "\ncolor = [200, " << i << ", 0]\n";
    }
    const TemporaryFolder folder;
    ViewerWindow window(folder, {folder.write("scene.toml", "[light]\nlights = 1024\n"), "--samples", "16", "--shade", "studio"});
    replace_by_rename(folder, "scene.toml", "[light]\nlights = 1024\n" + spheres.str());
    const auto is_being_made = [](const Json& f) { return f.at("making") == true && f.at("exact") == false; };
    window.wait_meanwhile("work on the picture", [&](const Json& f) { return f.at("spheres") == many && is_being_made(f); });

    window.step("an edit begins the picture anew, and is kept");
    window.key("Insert");
    window.wait_meanwhile("the edit", [&](const Json& f) { return f.at("spheres") == many + 1 && is_being_made(f); });
    window.wait_meanwhile("what is kept", [&](const Json&) { return contains(kept_changes(folder), "[[sphere]]"); });
    EXPECT_TRUE(is_being_made(window.redraw()));

    window.step("answers");
    constexpr int answers = 20;
    std::vector<double> seconds;
    for (int i = 0; i < answers; ++i) {
        window.key("ctrl+i");
        const int selected = i % 2 == 0 ? many : 1;
        const Json& redraw = window.wait_meanwhile("an answer", [&](const Json& f) { return f.at("selected") == selected; });
        ASSERT_TRUE(is_being_made(redraw)) << "answer " << i;
        seconds.push_back(redraw.at("seconds").get<double>());
    }
    std::ranges::sort(seconds);
    std::cout << "the median of " << answers << " redraws: " << 1000.0 * seconds[answers / 2] << " ms\n";

    window.step("the end does not wait for the picture");
    window.send(SIGTERM);
    EXPECT_EQ(window.wait_for_end().status, 128 + SIGTERM);
}

TEST(Samples, AreKeptOverriddenAndInExports) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.txt", two_spheres);
    const auto close = [](ViewerWindow& window) {
        window.key("ctrl+q");
        EXPECT_EQ(window.wait_for_end().status, 0);
    };
    {
        ViewerWindow window(folder, {scene, "--size", "90x80"});
        EXPECT_EQ(window.at("samples"), 1);
        window.key("alt+6");
        window.wait_for("samples", 16);
        window.key("F12");
        announced(window, "scene.png (90 x 80, 16 samples a pixel)");
        close(window);
    }
    EXPECT_EQ(folder.read("scene.png"), render_bytes(folder, scene, {"-s", "90x80", "--samples", "16"}));
    {
        ViewerWindow window(folder, {scene});
        window.wait_for("samples", 16);
        close(window);
    }
    ViewerWindow window(folder, {scene, "--samples", "4"});
    window.wait_for("samples", 4);
}

}  // namespace sphereview::test
