// Frames of a file that changes on disk while they are shown.
#include <algorithm>

#include "unit/frames_in_viewer.hpp"

namespace sphereview {

namespace {

using namespace std::chrono_literals;

struct FrameReloadTest : FramesInViewer {};

}  // namespace

// What the file holds now is what is played.
TEST_F(FrameReloadTest, AReloadKeepsPlayingAndForgetsWhatOthersGot) {
    edit(0, [](Sphere& s) { s.hidden = true; });
    run(CommandId::next_frame);
    EXPECT_TRUE(sphere(0).hidden);
    play();
    replace_file(moved_frames(7));
    EXPECT_EQ(state.frames, 7);
    EXPECT_TRUE(plays());
    EXPECT_FALSE(sphere(0).hidden);
    EXPECT_EQ(next(50ms), FrameNews::frame);
    EXPECT_FALSE(sphere(0).hidden);
}

TEST_F(FrameReloadTest, UndoingAReloadBringsTheChangesOfAllFramesBack) {
    edit(0, [](Sphere& s) { s.color = {1, 2, 3}; });
    run(CommandId::next_frame);
    edit(1, [](Sphere& s) { s.hidden = true; });
    const auto expect_changes = [&](bool changed) {
        for (const CommandId step : {CommandId::next_frame, CommandId::previous_frame}) {
            run(step);
            EXPECT_TRUE(state.dialogs.empty());
            EXPECT_EQ(sphere(0).color == (Color{1, 2, 3}), changed) << state.frame;
            EXPECT_EQ(sphere(1).hidden, changed) << state.frame;
            EXPECT_EQ(state.document.is_changed(), changed);
        }
    };
    replace_file(moved_frames(6));
    undo(state);
    redo(state);
    EXPECT_EQ(reach_of_edits(state), EditsReach::none);
    undo(state);
    EXPECT_EQ(reach_of_edits(state), EditsReach::all_frames);
    expect_changes(true);
    replace_file(moved_frames(7));
    replace_file(moved_frames(8));
    expect_changes(false);
}

TEST_F(FrameReloadTest, AFileThatGrowsLeavesWhatIsUndone) {
    edit(0, [](Sphere& s) { s.hidden = true; });
    undo(state);
    replace_file(moved_frames(6));
    run(CommandId::next_frame);
    redo(state);
    EXPECT_TRUE(sphere(0).hidden);
}

TEST_F(FrameReloadTest, UndoingAReloadBringsBackWhatTheFrameLacks) {
    open(sized_frames({2, 1, 2}));
    edit(1, [](Sphere& s) { s.hidden = true; });
    show_frame(state, 1);
    edit(0, [](Sphere& s) { s.color = {1, 2, 3}; });
    replace_file(sized_frames({2, 1, 2, 2}));
    undo(state);
    EXPECT_EQ(reach_of_edits(state), EditsReach::all_frames);
    show_frame(state, 2);
    EXPECT_TRUE(sphere(1).hidden);
    EXPECT_EQ(sphere(0).color, (Color{1, 2, 3}));
}

TEST_F(FrameReloadTest, AReloadCanBeUndoneAfterASave) {
    edit(0, [](Sphere& s) { s.color = {1, 2, 3}; });
    replace_file(moved_frames(6));
    save_scene(state);
    ASSERT_FALSE(state.dialogs.empty());
    const auto accept = std::get<FileBrowser>(state.dialogs.back()).accept;
    state.dialogs.clear();
    accept(folder.path("saved.toml"), {});
    finish_writing(state, 30s);
    ASSERT_EQ(state.path, folder.path("saved.toml"));
    undo(state);
    EXPECT_EQ(sphere(0).color, (Color{1, 2, 3}));
    redo(state);
    EXPECT_NE(sphere(0).color, (Color{1, 2, 3}));
    EXPECT_FALSE(state.document.is_changed());
}

TEST_F(FrameReloadTest, WhatAReloadReplacedIsInNoFile) {
    std::string text = moved_frames(5);
    std::ranges::replace(text, 'O', 'N');
    replace_file(text);
    EXPECT_EQ(reach_of_edits(state), EditsReach::none);
    undo(state);
    EXPECT_EQ(reach_of_edits(state), EditsReach::this_frame);
    redo(state);
    EXPECT_EQ(reach_of_edits(state), EditsReach::none);
}

// The others get what was changed and no place.
TEST_F(FrameReloadTest, UndoingAReloadThatMovedTheSpheresLeavesACopyOfThisFrame) {
    edit(0, [](Sphere& s) { s.center.y = 5.0; });
    edit(0, [](Sphere& s) { s.hidden = true; });
    std::string text = moved_frames(5);
    for (std::size_t at = 0; (at = text.find(" 100 ", at)) != std::string::npos; ++at) text.replace(at, 5, " 200 ");
    std::ranges::replace(text, 'O', 'N');
    replace_file(text);
    const Color color = sphere(0).color;
    undo(state);
    EXPECT_NE(sphere(0).color, color);
    EXPECT_EQ(sphere(0).center.z, 100.0);
    EXPECT_EQ(reach_of_edits(state), EditsReach::this_frame);
    edit(1, [](Sphere& s) { s.radius = 0.125; });
    run(CommandId::next_frame);
    ASSERT_NE(question(), nullptr);
    EXPECT_EQ(question()->id, "save-changes");
    answer(1);
    EXPECT_EQ(sphere(0).center, glm::dvec3(1.0, 0.0, 200.0));
    EXPECT_EQ(sphere(0).color, color) << "the file's";
    EXPECT_TRUE(sphere(0).hidden);
    EXPECT_EQ(sphere(1).radius, 0.125);
    EXPECT_EQ(reach_of_edits(state), EditsReach::all_frames);
}

// As a simulation leaves it that begins again.
TEST_F(FrameReloadTest, AFileThatHasBecomeShorterIsShownFromItsNewLastFrame) {
    run(CommandId::last_frame);
    EXPECT_EQ(state.frame, 4);
    replace_file(moved_frames(3));
    EXPECT_EQ(state.messages.scene_error, "");
    EXPECT_TRUE(state.dialogs.empty());
    EXPECT_EQ(state.frames, 3);
    EXPECT_EQ(state.frame, 2);
    EXPECT_EQ(sphere(0).center.x, 2.0);
    run(CommandId::previous_frame);
    EXPECT_EQ(state.frame, 1);
    EXPECT_TRUE(state.dialogs.empty());
    replace_file("2\n\nO 0 x 1\nH 0 0 1\n");
    EXPECT_NE(state.messages.scene_error, "") << "a broken file is no shorter one";
    EXPECT_EQ(state.frame, 1);
}

TEST_F(FrameReloadTest, AFileThatBecomesShorterWhileItPlaysIsNoFault) {
    show_frame(state, 3);
    run(CommandId::loop);
    play();
    folder.write("a.xyz", moved_frames(2));
    EXPECT_TRUE(test::eventually([&] {
        now += 50ms;
        follow_player(state, now, false);
        EXPECT_LT(state.frame, state.frames);
        look_at_file(state);
        finish_work(state);
        return state.frames == 2 && !state.loading;
    }));
    EXPECT_TRUE(state.dialogs.empty());
    EXPECT_TRUE(plays());
    EXPECT_EQ(next(50ms), FrameNews::frame);
    EXPECT_LT(state.frame, 2);
}

TEST_F(FrameReloadTest, AReloadWhileItPlaysKeepsTheColoursByAProperty) {
    color_by_charge();
    play();
    EXPECT_EQ(next(50ms), FrameNews::frame);
    std::string text = moved_frames(8);
    std::ranges::replace(text, 'O', 'N');
    replace_file(text);
    EXPECT_EQ(state.frames, 8);
    EXPECT_NEAR(static_cast<double>(sphere(0).color.r), 255.0 / 8.0, 1.0);
    for (int frame = 2; frame < 5; ++frame) {
        EXPECT_EQ(next(50ms), FrameNews::frame);
        EXPECT_NEAR(static_cast<double>(sphere(0).color.r), frame * 255.0 / 8.0, 1.0) << frame;
        EXPECT_FALSE(state.document.is_changed());
    }
    EXPECT_EQ(state.side_panel.look.colors.property, "charge");
}

}  // namespace sphereview
