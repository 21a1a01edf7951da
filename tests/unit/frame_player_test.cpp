// Frames that are stepped through, played and looked for by the handle.
#include <utility>

#include "unit/frames_in_viewer.hpp"

namespace sphereview {

namespace {

using namespace std::chrono_literals;

struct FramePlayerTest : FramesInViewer {};

}  // namespace

TEST_F(FramePlayerTest, PlaysToTheEndAndFromTheBeginningAgain) {
    play();
    EXPECT_TRUE(plays());
    EXPECT_TRUE(info_of(commands_of(state), CommandId::play).checked);
    ASSERT_TRUE(next_frame_due(state));
    EXPECT_EQ(follow_player(state, *next_frame_due(state) - 1ms, false), FrameNews::none) << "not yet";
    for (int frame = 1; frame < 5; ++frame) {
        EXPECT_EQ(next(50ms), FrameNews::frame);
        EXPECT_EQ(state.frame, frame);
        EXPECT_EQ(sphere(0).center.x, frame);
        EXPECT_FALSE(state.document.is_changed());
    }
    EXPECT_EQ(next(50ms), FrameNews::stopped);
    EXPECT_FALSE(plays());
    EXPECT_EQ(next_frame_due(state), std::nullopt);
    play();
    EXPECT_EQ(next(0ms), FrameNews::frame);
    EXPECT_EQ(state.frame, 0);
    run(CommandId::play);
    EXPECT_FALSE(plays());
}

TEST_F(FramePlayerTest, RepeatsAsIsChosen) {
    run(CommandId::last_frame);
    EXPECT_EQ(state.frame, 4);
    run(CommandId::back_and_forth);
    play();
    EXPECT_EQ(next(50ms), FrameNews::frame);
    EXPECT_EQ(state.frame, 3);
    EXPECT_EQ(next(50ms), FrameNews::frame);
    EXPECT_EQ(state.frame, 2);
    run(CommandId::loop);
    EXPECT_FALSE(info_of(commands_of(state), CommandId::back_and_forth).checked);
    for (const int frame : {3, 4, 0, 1}) {
        EXPECT_EQ(next(50ms), FrameNews::frame);
        EXPECT_EQ(state.frame, frame);
    }
    run(CommandId::first_frame);
    EXPECT_FALSE(plays()) << "a step stops it";
    EXPECT_EQ(state.frame, 0);
    EXPECT_FALSE(info_of(commands_of(state), CommandId::first_frame).enabled);
}

TEST_F(FramePlayerTest, PlaysAsRecorded) {
    std::string text;
    for (const char* const time : {"0", "2", "3", "3", "100", "0"}) text += std::string("1\ntime=") + time + "\nO 0 0 100\n";
    open(text);
    ASSERT_TRUE(test::eventually([&] { return timeline_facts(state).usual_step.has_value(); })) << "before it plays";
    EXPECT_EQ(timeline_facts(state).usual_step, 2.0);
    EXPECT_EQ(timeline_facts(state).time, "0");
    state.player.choices.speed.recorded = 4.0;
    EXPECT_EQ(frames_a_second(state), 2.0);
    run(CommandId::loop);
    play();
    state.player.clock.play(now);
    ASSERT_TRUE(test::eventually([&] { return state.player.ahead->time_of(4).has_value(); }));
    const std::vector<std::chrono::milliseconds> beats = {500ms, 250ms, 500ms, 10s, 500ms, 500ms};  // 2, 1, none, 97, -100, again
    for (std::size_t i = 0; i < beats.size(); ++i) {
        const auto frame = static_cast<std::int64_t>(i);
        ASSERT_EQ(state.frame, frame);
        ASSERT_TRUE(next_frame_due(state));
        EXPECT_EQ(*next_frame_due(state) - now, beats[i]) << i;
        EXPECT_EQ(follow_player(state, now + beats[i] - 1ms, false), FrameNews::none) << i;
        EXPECT_FALSE(state.player.wanted) << i;
        EXPECT_EQ(next(beats[i]), FrameNews::frame);
    }
    EXPECT_EQ(state.frame, 0);
    run(CommandId::play_faster);
    EXPECT_EQ(state.player.choices.speed, (PlaySpeed{24.0, 5.0}));
    open(text);
    EXPECT_EQ(state.player.choices.speed, (PlaySpeed{24.0, 5.0})) << "of the same file";
    open(moved_frames(3), "b.xyz");
    EXPECT_EQ(state.player.choices.speed, PlaySpeed{24.0}) << "of another file";
    EXPECT_TRUE(timeline_facts(state).time.empty());
}

TEST_F(FramePlayerTest, WaitsWhileSomethingIsInTheHandOrAsked) {
    play();
    EXPECT_EQ(follow_player(state, now + 1s, true), FrameNews::none);
    EXPECT_FALSE(state.player.wanted) << "no frame waits for the hand to open";
    state.dialogs.push_back(Question{.id = "error"});
    EXPECT_EQ(follow_player(state, now + 2s, false), FrameNews::none);
    EXPECT_FALSE(state.player.wanted);
    state.dialogs.clear();
    EXPECT_EQ(follow_player(state, now + 2s + 1ms, false), FrameNews::none) << "and begins a new beat";
    EXPECT_EQ(next(3s), FrameNews::frame);
}

struct DamagedFramesTest : FramesInViewer {
    // Frames 2, 5 and 6 of 0..6 have a wrong value.
    DamagedFramesTest() {
        const std::string bad = "2\n\nO 0 0 1\nH x 0 1\n";
        open(moved_frames(2) + bad + moved_frames(2) + bad + bad);
        EXPECT_EQ(state.frames, 7);
    }
    void expect_said(const std::string& beginning, const std::string& end) {
        const std::string said = std::exchange(state.messages.announcement, "");
        EXPECT_TRUE(said.starts_with(beginning)) << said;
        EXPECT_TRUE(said.ends_with(end)) << said;
        EXPECT_TRUE(state.dialogs.empty());
    }
};

TEST_F(DamagedFramesTest, AreSteppedOver) {
    run(CommandId::next_frame);
    run(CommandId::next_frame);
    EXPECT_EQ(state.frame, 3);
    EXPECT_EQ(sphere(0).center.x, 0.0);
    expect_said("Frame 2 cannot be read: " + path + ":12:3: found 'x'", "a number");
    run(CommandId::previous_frame);
    EXPECT_EQ(state.frame, 1);
    expect_said("Frame 2 cannot be read: ", "a number");
    show_frame(state, 4);
    run(CommandId::next_frame);
    EXPECT_EQ(state.frame, 4) << "none behind can be read";
    EXPECT_FALSE(state.player.wanted);
    expect_said("Frame 5 cannot be read: " + path + ":24:3", "\nNor can 1 more");
}

TEST_F(DamagedFramesTest, ArePlayedOverWithOneMessage) {
    run(CommandId::back_and_forth);
    play();
    std::vector<std::string> said;
    for (const int frame : {1, 3, 4, 4, 3, 1, 0, 1, 3, 4, 4}) {
        ASSERT_EQ(next(50ms), FrameNews::frame);
        EXPECT_EQ(state.frame, frame);
        said.push_back(std::exchange(state.messages.announcement, ""));
    }
    std::erase(said, "");
    ASSERT_EQ(said.size(), 2U);
    EXPECT_TRUE(said[0].starts_with("Frame 2 cannot be read: ")) << said[0];
    EXPECT_TRUE(said[1].starts_with("Frame 5 cannot be read: ")) << said[1];
    EXPECT_TRUE(plays());
    EXPECT_TRUE(state.dialogs.empty());
    run(CommandId::loop);
    for (const int frame : {0, 1}) {
        ASSERT_EQ(next(50ms), FrameNews::frame);
        EXPECT_EQ(state.frame, frame);
    }
}

TEST_F(DamagedFramesTest, EndAFilmThatHasNoOthers) {
    show_frame(state, 4);
    play();
    EXPECT_EQ(next(50ms), FrameNews::stopped);
    EXPECT_FALSE(plays());
    EXPECT_EQ(state.frame, 4);
    expect_said("Frame 5 cannot be read: ", "\nNor can 1 more");
}

TEST_F(DamagedFramesTest, StayUnderTheHandleUntilItIsLetGo) {
    state.player.choices.handle_held = true;
    show_frame(state, 2);
    EXPECT_EQ(timeline_facts(state).wanted, 2);
    EXPECT_TRUE(timeline_facts(state).wanted_in_vain);
    expect_said("Frame 2 cannot be read: ", "a number");
    EXPECT_EQ(follow_player(state, now, false), FrameNews::none);
    EXPECT_EQ(state.messages.announcement, "") << "once";
    EXPECT_EQ(state.frame, 0);
    show_frame(state, 4);
    EXPECT_EQ(state.frame, 4);
    show_frame(state, 2);
    state.player.choices.handle_held = false;
    EXPECT_EQ(next(0ms), FrameNews::frame);
    EXPECT_EQ(state.frame, 1);
}

// Of a large file no more is read than the first frame needs; the others are counted meanwhile.
TEST_F(FramePlayerTest, CountsTheFramesOfALargeFileBesideTheLoop) {
    std::string frame = "1000\n" + std::string(20'000, 'c') + "\n";
    for (int i = 0; i < 1000; ++i) frame += "O 1 2 3\n";
    std::string text;
    constexpr std::int64_t count = 700;
    for (std::int64_t i = 0; i < count; ++i) text += frame;
    path = folder.write("large.xyz", text);
    LoadedScene loaded = load_scene(path, load_options(state, path, 0));
    EXPECT_EQ(loaded.frames, 2);
    EXPECT_FALSE(loaded.all_frames);
    adopt(state, std::move(loaded), path);
    EXPECT_TRUE(reads_frames(state));
    EXPECT_TRUE(test::eventually([&] {
        follow_player(state, now, false);
        return state.player.all_frames;
    }));
    EXPECT_EQ(state.frames, count);
    EXPECT_FALSE(reads_frames(state));
    EXPECT_EQ(state.messages.announcement, "");
    // The handle goes ahead of what is read: the latest frame is shown, and of those before at most what was being read.
    for (const std::int64_t frame_under_handle : {std::int64_t{100}, std::int64_t{300}, count - 1})
        show_frame(state, frame_under_handle);
    EXPECT_EQ(timeline_facts(state).wanted, 699);
    EXPECT_TRUE(test::eventually([&] {
        follow_player(state, now, false);
        return state.frame == count - 1;
    }));
    EXPECT_EQ(timeline_facts(state).wanted, std::nullopt);
    EXPECT_EQ(follow_player(state, now, false), FrameNews::none) << "no other comes";
}

TEST_F(FramePlayerTest, SaysWhereALargeFileIsBadBehindItsFirstFrame) {
    const std::string text = "1\n" + std::string(std::size_t{17} << 20U, 'c') + "\nO 1 2 3\nnot a number\n\nO 1 2 3\n";
    path = folder.write("large.xyz", text);
    const LoadedScene loaded = load_scene(path, load_options(state, path, 0));
    EXPECT_EQ(loaded.frames, 1);
    EXPECT_TRUE(loaded.all_frames);
    ASSERT_EQ(loaded.warnings.size(), 1U);
    EXPECT_TRUE(loaded.warnings[0].starts_with(path + ":4:1: ")) << loaded.warnings[0];
    EXPECT_TRUE(loaded.warnings[0].ends_with("; what follows frame 0 is passed over")) << loaded.warnings[0];
}

}  // namespace sphereview
