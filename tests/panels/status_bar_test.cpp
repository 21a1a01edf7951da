#include "panels/status_bar.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

struct StatusHarness {
    Status status;
    PanelHarness panels;

    explicit StatusHarness(Scene scene = {}, float width = 1400.0F)
        : panels(PanelHarness::in_window([this](const PanelContext& context) { draw_status_bar(context, status); }, width, 40.0F),
                 std::move(scene), width, 100.0F) {}

    std::string text() { return panels.text(); }
    bool says(const std::string& words) { return text().find(words) != std::string::npos; }
};

Scene scene_of(std::size_t count) {
    Scene scene;
    scene.spheres.resize(count);
    return scene;
}

}  // namespace

TEST(StatusBar, TellsOfAnEmptyScene) {
    StatusHarness bar;
    EXPECT_TRUE(bar.says("0 spheres")) << bar.text();
    EXPECT_TRUE(bar.says("0.0 ms")) << bar.text();
    EXPECT_FALSE(bar.says("hidden"));
    EXPECT_FALSE(bar.says("background"));
}

TEST(StatusBar, TellsWhatIsDrawnAndSelected) {
    StatusHarness bar(scene_of(12'345));
    bar.panels.selection.set({1, 2, 3});
    bar.status.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
    bar.status.frame_seconds = 0.01234;
    bar.status.step = 4;
    bar.status.pixel = Pixel{12, 34};
    bar.status.hidden = 1'000;
    bar.status.sphere = 7;
    for (const char* words :
         {"llvmpipe (LLVM 15.0.6, 256 bits)", "12,345 spheres, 1,000 hidden, 3 selected", "12.3 ms", "1/4", "12, 34", "sphere 7"}) {
        EXPECT_TRUE(bar.says(words)) << words << " is not in " << bar.text();
    }
    bar.status.sphere.reset();
    bar.status.step = 1;
    EXPECT_TRUE(bar.says("background"));
    EXPECT_FALSE(bar.says("1/"));
}

TEST(StatusBar, TellsTheFrameOfSeveral) {
    StatusHarness bar;
    EXPECT_FALSE(bar.says("frame "));
    bar.panels.frame_of_file = 3;
    bar.panels.frames_of_file = 120;
    EXPECT_TRUE(bar.says("frame 3 of 0..119")) << bar.text();
}

TEST(StatusBar, OneSphereIsOne) {
    StatusHarness bar(scene_of(1));
    EXPECT_TRUE(bar.says("1 sphere"));
    EXPECT_FALSE(bar.says("1 spheres"));
}

TEST(StatusBar, SurvivesWhatCannotBe) {
    Scene scene = scene_of(2);
    scene.names[1] = std::string(10'000, 'n') + "\n##%n%s";
    StatusHarness bar(scene, 60.0F);
    bar.status.renderer = std::string(10'000, 'r') + "%s%n";
    bar.status.frame_seconds = std::numeric_limits<double>::infinity();
    bar.status.pixel = Pixel{2'000'000'000, -5};
    bar.status.sphere = 1;
    bar.status.hidden = std::numeric_limits<std::size_t>::max();
    EXPECT_FALSE(bar.says("inf"));
    bar.status.sphere = 99;  // of a picture of the scene before
    bar.status.frame_seconds = std::numeric_limits<double>::quiet_NaN();
    EXPECT_GT(bar.panels.vertices(), 0);
}

}  // namespace sphereview
