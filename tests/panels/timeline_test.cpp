// The line of time under the picture, and its buttons.
#include "panels/timeline.hpp"

#include "panels/harness.hpp"

namespace sphereview {

namespace {

// A base, so that it is there when PanelHarness draws for the first time.
struct ShownTimeline {
    TimelineFacts facts;
    PlayChoices choices;
};

struct TimelineHarness : ShownTimeline, PanelHarness {
    explicit TimelineHarness(float width = 900.0F)
        : PanelHarness(in_window([this](const PanelContext& context) { draw_timeline(context, facts, choices); }, width, 60.0F),
                       line_of_spheres(3), 1000.0F) {
        frames_of_file = 101;
        frame_of_file = 20;
        redraws(2);
        take_actions();
    }

    std::vector<std::int64_t> frames_taken() {
        std::vector<std::int64_t> numbers;
        for (const ShowFrame& one : taken<ShowFrame>()) numbers.push_back(one.frame);
        return numbers;
    }
    bool says(const std::string& words) { return text().find(words) != std::string::npos; }
};

}  // namespace

TEST(Timeline, ButtonsRunTheCommands) {
    TimelineHarness panel;
    for (const auto& [widget, id] :
         {std::pair{"first frame", CommandId::first_frame}, std::pair{"previous frame", CommandId::previous_frame},
          std::pair{"play", CommandId::play}, std::pair{"next frame", CommandId::next_frame},
          std::pair{"last frame", CommandId::last_frame}}) {
        panel.click(widget);
        EXPECT_EQ(panel.commands_taken(), std::vector{id}) << widget;
        panel.wait();
    }
    for (CommandInfo& info : panel.commands) info.enabled = info.id != CommandId::next_frame;
    panel.click("next frame");
    EXPECT_TRUE(panel.commands_taken().empty()) << "there is none";
}

TEST(Timeline, AHandleIsDraggedAndHoldsTheFilm) {
    TimelineHarness panel;
    panel.move(panel.place("timeline", 0.5F));
    panel.press();
    panel.redraws(2);
    EXPECT_TRUE(panel.choices.handle_held);
    std::vector<std::int64_t> asked = panel.frames_taken();
    ASSERT_FALSE(asked.empty());
    EXPECT_EQ(asked.back(), 50);
    // What is asked for already is not asked for again.
    panel.facts.wanted = 50;
    panel.redraws(2);
    EXPECT_TRUE(panel.frames_taken().empty());
    EXPECT_TRUE(panel.says("frame 50, being read"));
    panel.move(panel.place("timeline", 1.0F));
    panel.move({990.0F, 500.0F});
    asked = panel.frames_taken();
    ASSERT_FALSE(asked.empty());
    EXPECT_EQ(asked.back(), 100);
    panel.release();
    panel.redraws(2);
    EXPECT_FALSE(panel.choices.handle_held);
    panel.take_actions();
    panel.drag(panel.place("timeline", 0.7F), {0.0F, 20.0F});
    asked = panel.frames_taken();
    ASSERT_FALSE(asked.empty());
    EXPECT_EQ(asked.back(), 0);
}

TEST(Timeline, SaysWhichFrameOfHowManyIsShown) {
    TimelineHarness panel;
    EXPECT_TRUE(panel.says("[ 20 ] of 0..100")) << panel.text();
    EXPECT_FALSE(panel.says("+"));
    panel.facts.counting = true;
    EXPECT_TRUE(panel.says("[ 20 ] of 0..100+"));
}

TEST(Timeline, TheNumberIsTypedOrDragged) {
    TimelineHarness panel;
    panel.click("slider frame");
    panel.redraws(3);
    panel.type("2*4");
    panel.tap(ImGuiKey_Enter);
    EXPECT_EQ(panel.frames_taken(), std::vector<std::int64_t>{8});
    panel.click("slider frame");
    panel.redraws(3);
    panel.type("101");  // the last is 100
    panel.tap(ImGuiKey_Enter);
    EXPECT_TRUE(panel.frames_taken().empty());
    panel.redraws(3);
    panel.tap(ImGuiKey_Escape);
    panel.redraws(2);
    const ImVec2 from = panel.place("slider frame");
    panel.drag(from, {from.x + 33.0F, from.y});
    const std::vector<std::int64_t> asked = panel.frames_taken();
    ASSERT_FALSE(asked.empty());
    EXPECT_EQ(asked.back(), 50);
}

TEST(Timeline, SaysWhatChangesApplyTo) {
    TimelineHarness panel;
    EXPECT_FALSE(panel.has("edits reach"));
    panel.facts.edits = EditsReach::all_frames;
    EXPECT_TRUE(panel.says("changes: all frames"));
    panel.facts.edits = EditsReach::this_frame;
    EXPECT_TRUE(panel.says("changes: this frame"));
    EXPECT_TRUE(panel.has("edits reach"));
}

TEST(Timeline, ChoosesSpeedAndRepeat) {
    TimelineHarness panel;
    EXPECT_TRUE(panel.says("24 / s"));
    panel.click("speed");
    panel.redraws(3);
    panel.click("speed 60 / s");
    panel.redraws(3);
    EXPECT_EQ(panel.choices.speed, PlaySpeed{60.0});
    for (const Repeat repeat : {Repeat::loop, Repeat::back_and_forth, Repeat::once}) {
        panel.wait();
        panel.click("repeat");
        EXPECT_EQ(panel.choices.repeat, repeat);
    }
}

TEST(Timeline, PlaysAsRecordedWhereTheFileHasTimes) {
    TimelineHarness panel;
    EXPECT_FALSE(panel.has("frame time"));
    panel.click("speed");
    panel.redraws(3);
    EXPECT_FALSE(panel.says("as recorded"));
    panel.tap(ImGuiKey_Escape);
    panel.facts.time = "9.500";
    panel.facts.time_unit = "ps";
    panel.facts.usual_step = 2.0;
    panel.choices.speed.recorded = 1000.0;
    panel.redraws(2);
    EXPECT_TRUE(panel.says("9.500 ps"));
    EXPECT_TRUE(panel.says("1000 ps / s"));
    panel.wait();
    panel.click("speed");
    panel.redraws(3);
    EXPECT_TRUE(panel.says("as recorded"));
    panel.click("speed 20 ps / s");
    panel.redraws(3);
    EXPECT_EQ(panel.choices.speed, (PlaySpeed{24.0, 20.0}));
    panel.facts.usual_step.reset();
    panel.redraws(2);
    EXPECT_TRUE(panel.says("24 / s")) << "of a file without times";
}

// A film whose times get longer does not push its line about.
TEST(Timeline, ALongTimeKeepsItsPlace) {
    TimelineHarness panel;
    panel.facts.time = "100.000";
    panel.redraws(2);
    const WidgetRectangle before = panel.rectangles.at("timeline");
    panel.facts.time = "9.5";
    panel.redraws(2);
    EXPECT_TRUE(panel.says("t 9.5"));
    EXPECT_EQ(panel.rectangles.at("timeline").right, before.right);
}

// The line stays, and it stays in the window.
TEST(Timeline, OfANarrowWindowLeavesTheLessNeededOut) {
    for (const float width : {900.0F, 500.0F, 320.0F, 240.0F, 190.0F}) {
        TimelineHarness panel(width);
        panel.facts.edits = EditsReach::this_frame;
        panel.redraws(2);
        EXPECT_TRUE(panel.has("play")) << width;
        const WidgetRectangle line = panel.rectangles.at("timeline");
        EXPECT_GE(line.right - line.left, 30.0F) << width;
        EXPECT_TRUE(panel.has("frame number") || width < 200.0F) << width;
        EXPECT_TRUE(panel.has("edits reach") || panel.has("edits mark") || width < 200.0F) << width;
        EXPECT_EQ(panel.has("speed"), width > 400.0F) << width;
        panel.facts.time = "0.500";
        panel.redraws(2);
        EXPECT_EQ(panel.has("frame time"), width > 300.0F) << width;
        panel.facts.time.clear();
        panel.redraws(2);
        for (const auto& [name, rectangle] : panel.rectangles) EXPECT_LE(rectangle.right, width) << name;
        EXPECT_EQ(panel.has("first frame"), width > 400.0F) << width;
    }
}

}  // namespace sphereview
