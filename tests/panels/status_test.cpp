#include <gtest/gtest.h>

#include <limits>

#include "panels/status.hpp"
#include "support/panel_harness.hpp"
#include "support/spheres.hpp"

namespace sphereview {

namespace {

struct MessageHarness {
    Messages messages;
    Rectangle area{100.0F, 50.0F, 600.0F, 500.0F};
    CornerMarks marks;
    bool cancelled = false;
    PanelHarness panels{[this](const PanelContext& context) {
                            if (draw_messages(context, messages, area, marks).work) cancelled = true;
                        },
                        {},
                        800.0F,
                        600.0F};

    WidgetRectangle rectangle(const std::string& name) {
        panels.redraws(4);
        return panels.rectangles.at(name);
    }
    void expect_inside(const std::string& name) {
        const WidgetRectangle r = rectangle(name);
        EXPECT_GE(r.left, area.x) << name;
        EXPECT_GE(r.top, area.y) << name;
        EXPECT_LE(r.right, area.x + area.width) << name;
        EXPECT_LE(r.bottom, area.y + area.height) << name;
    }
};

std::string lines(int count) {
    std::string text;
    for (int i = 1; i <= count; ++i) text += "shade.frag:" + std::to_string(i) + ": error: syntax error, unexpected '}'\n";
    return text;
}

TEST(MessagesPanel, DrawsNothingWithoutAMessage) {
    MessageHarness harness;
    EXPECT_EQ(harness.panels.vertices(), 0);
    EXPECT_TRUE(harness.panels.rectangles.empty());
}

TEST(MessagesPanel, AnnouncesAtTheBottom) {
    MessageHarness harness;
    harness.messages.announcement = "Saved /home/a/b.png";
    harness.expect_inside("message announcement");
    const WidgetRectangle r = harness.rectangle("message announcement");
    EXPECT_GT(r.top, 450.0F);
    EXPECT_NEAR(0.5F * (r.left + r.right), 400.0F, 2.0F);
    EXPECT_NE(harness.panels.text().find("Saved /home/a/b.png"), std::string::npos);
    harness.panels.move(harness.panels.place("message announcement"));
    EXPECT_FALSE(ImGui::GetIO().WantCaptureMouse) << "clicks go through to the picture";
}

TEST(MessagesPanel, AnnouncesAboveTheMarksInTheCornersThatItWouldCover) {
    MessageHarness harness;
    harness.marks = {.left = {100.0F, 110.0F}, .right = {150.0F, 60.0F}};
    harness.messages.announcement = "Saved";
    EXPECT_GT(harness.rectangle("message announcement").bottom, 500.0F) << "between them";
    harness.messages.announcement = "Saved /" + std::string(50, 'x');
    EXPECT_LE(harness.rectangle("message announcement").bottom, 490.0F);
    harness.messages.announcement = "Saved /" + std::string(200, 'x');
    EXPECT_LE(harness.rectangle("message announcement").bottom, 440.0F);
}

TEST(MessagesPanel, WorkIsShownAtTheTopOneBelowTheOther) {
    MessageHarness harness;
    harness.messages.work = WorkShown{"Exporting a.png", 0.5, true};
    harness.messages.film = WorkShown{"Exporting a.mp4", 0.5, true};
    const WidgetRectangle work = harness.rectangle("message work");
    EXPECT_LT(work.top, harness.area.y + 20.0F);
    EXPECT_GE(harness.rectangle("message film").top, work.bottom);
}

TEST(MessagesPanel, WrapsAVeryLongPath) {
    MessageHarness harness;
    harness.messages.announcement = "Saved /" + std::string(900, 'x') + ".png";
    harness.messages.scene_error = "/" + std::string(900, 'y') + ".toml:3:4: expected %s%n";
    harness.expect_inside("message announcement");
    harness.expect_inside("message scene error");
    const WidgetRectangle error = harness.rectangle("message scene error");
    EXPECT_GT(error.bottom - error.top, 5.0F * ImGui::GetFontSize()) << "on several lines";
}

TEST(MessagesPanel, ShowsWhatIsReadAndCancelsOnlyWhatCanBe) {
    MessageHarness harness;
    harness.messages.work = WorkShown{"Reading /" + std::string(200, 'y') + "%s.txt: 35 of 70 MB", 0.5, true};
    harness.expect_inside("message work");
    harness.expect_inside("cancel work");
    EXPECT_FALSE(harness.cancelled);
    harness.panels.click("cancel work");
    EXPECT_TRUE(harness.cancelled);
    harness.panels.rectangles.clear();
    harness.messages.work = WorkShown{"Saving a.txt", {}, false};
    harness.expect_inside("message work");
    EXPECT_FALSE(harness.panels.rectangles.contains("cancel work"));
}

TEST(MessagesPanel, ShowsWhatIsBrokenUntilItIsClosed) {
    MessageHarness harness;
    harness.messages.scene_error = "four.txt:2:5: expected a number";
    const WidgetRectangle low = harness.rectangle("message scene error");
    EXPECT_LT(low.bottom - low.top, 6.0F * ImGui::GetFontSize()) << "as high as a short text needs";
    harness.messages.shader_error = lines(500);
    harness.expect_inside("message scene error");
    harness.expect_inside("message shader error");
    EXPECT_GE(harness.rectangle("message shader error").top, harness.rectangle("message scene error").bottom);
    EXPECT_NE(harness.panels.text().find("last good scene is shown"), std::string::npos) << harness.panels.text();
    EXPECT_NE(harness.panels.text().find("four.txt:2:5: expected a number"), std::string::npos);
    EXPECT_FALSE(harness.messages.scene_error.empty());
    harness.panels.click("close scene error");
    EXPECT_TRUE(harness.messages.scene_error.empty());
    EXPECT_FALSE(harness.messages.shader_error.empty());
    harness.messages.scene_gone = "/scenes/four.txt";
    harness.expect_inside("message scene gone");
    EXPECT_GE(harness.rectangle("message shader error").top, harness.rectangle("message scene gone").bottom);
    EXPECT_NE(harness.panels.text().find("/scenes/four.txt"), std::string::npos);
    harness.panels.click("close scene gone");
    EXPECT_TRUE(harness.messages.scene_gone.empty());
    harness.panels.click("close shader error");
    EXPECT_TRUE(harness.messages.shader_error.empty());
}

TEST(MessagesPanel, SurvivesATinyArea) {
    MessageHarness harness;
    harness.messages = {"Saved", "a:1:1: b", lines(3)};
    harness.area = {0.0F, 0.0F, 0.0F, 0.0F};
    harness.panels.redraws(4);
    EXPECT_GT(harness.panels.vertices(), 0);
}

struct StatusHarness {
    Status status;
    PanelHarness panels;

    explicit StatusHarness(Scene scene = {}, float width = 1400.0F)
        : panels(PanelHarness::in_window([this](const PanelContext& context) { draw_status_bar(context, status); }, width, 40.0F),
                 std::move(scene), width, 100.0F) {}

    std::string text() { return panels.text(); }
    bool says(const std::string& words) { return text().find(words) != std::string::npos; }
};

TEST(StatusBar, TellsOfAnEmptyScene) {
    StatusHarness bar;
    EXPECT_TRUE(bar.says("0 spheres")) << bar.text();
    EXPECT_TRUE(bar.says("0.0 ms")) << bar.text();
    EXPECT_FALSE(bar.says("hidden"));
    EXPECT_FALSE(bar.says("background"));
    bar.panels.document = Document(scene_of_alike(1));
    EXPECT_TRUE(bar.says("1 sphere"));
    EXPECT_FALSE(bar.says("1 spheres"));
}

TEST(StatusBar, TellsWhatIsDrawnAndSelected) {
    Scene scene = scene_of_alike(12'345);
    for (std::size_t i = 0; i < 1'000; ++i) scene.spheres[i].hidden = true;
    StatusHarness bar(scene);
    bar.panels.selection.set({1, 2, 3});
    bar.status.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
    bar.status.trace_seconds = 0.01234;
    bar.status.step = 4;
    bar.status.pixel = Pixel{12, 34};
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

// Whole columns are left out, those first that people look at least; what is cut ends in dots.
TEST(StatusBar, KeepsWhatIsUnderThePointerInAShortLine) {
    Scene scene = scene_of_alike(12'345);
    scene.names[7] = std::string(200, 'n');
    StatusHarness bar(scene, 420.0F);
    bar.status.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
    bar.status.pixel = Pixel{12, 34};
    bar.status.sphere = 7;
    EXPECT_TRUE(bar.says("12, 34")) << bar.text();
    EXPECT_TRUE(bar.says("nn...")) << bar.text();
    EXPECT_FALSE(bar.says("llvm")) << bar.text();
}

TEST(StatusBar, TellsTheValuesThatAreAskedFor) {
    Scene scene = scene_of_alike(2);
    scene.properties = {{"charge", std::vector<double>{0.25, std::numeric_limits<double>::quiet_NaN()}},
                        {"chain", Labels{{"A"}, {0, 0}}},
                        {"mass", std::vector<double>{1.0, 2.0}}};
    StatusHarness bar(scene);
    bar.status.pixel = Pixel{12, 34};
    bar.status.sphere = 0;
    bar.status.properties = {"CHARGE", "chain", "none such"};
    EXPECT_TRUE(bar.says("sphere 0, charge 0.25, chain A")) << bar.text();
    EXPECT_FALSE(bar.says("mass"));
    bar.status.sphere = 1;
    EXPECT_TRUE(bar.says("sphere 1, charge none, chain A")) << bar.text();
}

TEST(StatusBar, SurvivesWhatCannotBe) {
    Scene scene = scene_of_alike(2);
    scene.names[1] = std::string(10'000, 'n') + "\n##%n%s";
    StatusHarness bar(scene, 60.0F);
    bar.status.renderer = std::string(10'000, 'r') + "%s%n";
    bar.status.trace_seconds = std::numeric_limits<double>::infinity();
    bar.status.pixel = Pixel{2'000'000'000, -5};
    bar.status.sphere = 1;
    EXPECT_FALSE(bar.says("inf"));
    bar.status.sphere = 99;  // of a picture of the scene before
    bar.status.trace_seconds = std::numeric_limits<double>::quiet_NaN();
    EXPECT_GT(bar.panels.vertices(), 0);
}

}  // namespace

}  // namespace sphereview
