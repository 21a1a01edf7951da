// The frames of a file in the viewer: stepped through, played, edited. Without a window; times are given.
#include "viewer/frame_player.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "support/environment.hpp"
#include "support/eventually.hpp"
#include "support/temporary_folder.hpp"
#include "viewer/command_table.hpp"
#include "viewer/perform.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/scene_saving.hpp"

namespace sphereview {

namespace {

using namespace std::chrono_literals;

// Two atoms that go along x.
std::string moved_frames(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += "2\nProperties=species:S:1:pos:R:3:charge:R:1\nO " + std::to_string(i) + " 0 100 " + std::to_string(i) + "\nH " +
                std::to_string(i) + " 3 100 0\n";
    }
    return text;
}

// Of so many atoms each.
std::string sized_frames(const std::vector<int>& sizes) {
    std::string text;
    for (const int size : sizes) {
        text += std::to_string(size) + "\n\n";
        for (int i = 0; i < size; ++i) text += "O " + std::to_string(3 * i) + " 0 100\n";
    }
    return text;
}

struct FramesInViewer : testing::Test {
    FramesInViewer() : state(ViewOptions{}, ViewerSettings{}) { open(moved_frames(5)); }
    ~FramesInViewer() override {
        state.autosave.finish();
        remove_own_recovery();
    }

    void open(const std::string& text, const std::string& name = "a.xyz") {
        path = folder.write(name, text);
        adopt(state, load_scene(path, load_options(state, path, 0)), path);
    }
    void run(CommandId id) { run_command(state, id); }
    const Sphere& sphere(std::size_t number) const { return state.scene().spheres.at(number); }
    Question* question() { return state.dialogs.empty() ? nullptr : std::get_if<Question>(&state.dialogs.back()); }
    void answer(int number) {
        ASSERT_NE(question(), nullptr);
        const Question asked = *question();
        state.dialogs.pop_back();
        asked.answer(number);
    }
    void edit(std::uint32_t number, const std::function<void(Sphere&)>& change, const std::string& name = "Change") {
        Sphere changed = sphere(number);
        change(changed);
        apply(state, {ChangeSpheres{{number}, {changed}}, name});
    }
    // As the loop does, so much time later than before, until a frame is there or the film has stopped.
    FrameNews next(std::chrono::milliseconds later, bool held = false) {
        now += later;
        FrameNews news = FrameNews::none;
        test::eventually([&] {
            const FrameNews one = follow_player(state, now, held);
            if (one == FrameNews::frame || one == FrameNews::stopped) news = one;
            return news != FrameNews::none;
        });
        return news;
    }
    void play() {
        run(CommandId::play);
        now = PlayClock::Time::clock::now();
    }
    // By another program, without a question.
    void replace_file(const std::string& text) {
        folder.write("a.xyz", text);
        look_at_file(state);
        EXPECT_TRUE(test::eventually([&] {
            finish_work(state);
            return !state.loading;
        }));
        if (question() != nullptr && question()->id == "reload") answer(0);
    }
    // In one range for all frames.
    void color_by_charge() {
        LookPanelState& look = state.side_panel.look;
        const ColorBy by{.property = "charge", .map = ColorMap::grey, .range = ValueRange{0.0, 8.0}};
        const Property& charge = *find_property(state.scene().properties, "charge");
        const Coloring coloring = coloring_of(state.scene(), charge, by);
        std::vector<Sphere> spheres = state.scene().spheres;
        for (std::size_t i = 0; i < spheres.size(); ++i) spheres[i].color = colors_of(charge, coloring)[i];
        note_colors(look, {by, coloring});
        apply(state, {ChangeSpheres{{0, 1}, spheres}, "Colour"});
        ASSERT_NE(shown_coloring(state.document, look), nullptr);
    }
    bool plays() const { return state.player.clock.plays(); }

    test::TemporaryFolder folder;
    test::Variable folder_of_state{"XDG_STATE_HOME", folder.path("state")};  // where changes are kept
    std::string path;
    ViewerState state;
    PlayClock::Time now{};
};

}  // namespace

TEST_F(FramesInViewer, PlaysToTheEndAndFromTheBeginningAgain) {
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

TEST_F(FramesInViewer, RepeatsAsIsChosen) {
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

TEST_F(FramesInViewer, PlaysAsRecorded) {
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

TEST_F(FramesInViewer, WaitsWhileSomethingIsInTheHandOrAsked) {
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

TEST_F(FramesInViewer, AFaultStopsItWithOneMessage) {
    open(moved_frames(2) + "2\n\nO 0 0 1\nH x 0 1\n" + moved_frames(1));
    EXPECT_EQ(state.frames, 4);
    play();
    EXPECT_EQ(next(50ms), FrameNews::frame);
    EXPECT_EQ(next(50ms), FrameNews::stopped);
    EXPECT_FALSE(plays());
    EXPECT_EQ(state.frame, 1);
    ASSERT_EQ(state.dialogs.size(), 1U);
    EXPECT_EQ(question()->title, "Frame 2 cannot be read");
    EXPECT_NE(question()->text.find("a.xyz:12:3: found 'x'"), std::string::npos) << question()->text;
    state.dialogs.clear();
    EXPECT_EQ(follow_player(state, now + 1s, false), FrameNews::none);
    EXPECT_TRUE(state.dialogs.empty());
    show_frame(state, 3);
    EXPECT_EQ(state.frame, 3) << "the others can be shown";
}

TEST_F(FramesInViewer, WhatIsSelectedAndMeasuredStaysByNumber) {
    state.selection.set_only(1);
    measure(state.measuring, state.document, 0);
    measure(state.measuring, state.document, 1);
    play();
    EXPECT_EQ(next(50ms), FrameNews::frame);
    EXPECT_EQ(state.selection.numbers(), std::vector<std::uint32_t>{1});
    EXPECT_EQ(state.measuring.spheres, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(state.measuring.revision, state.document.names_revision());
}

// Colours, radii, names, what is hidden, and what concerns the whole scene.
TEST_F(FramesInViewer, WhatIsNoPlaceGoesAlong) {
    EXPECT_EQ(reach_of_edits(state), EditsReach::none);
    edit(0, [](Sphere& s) { s.color = {1, 2, 3}; });
    EXPECT_EQ(reach_of_edits(state), EditsReach::all_frames);
    edit(1, [](Sphere& s) { s.hidden = true; });
    edit(1, [](Sphere& s) { s.radius = 0.125; });
    apply(state, {RenameSphere{1, "proton"}, "Rename"});
    apply(state, {ChangeBackground{{{9, 9, 9}, false}}, "Background"});
    play();
    for (int frame = 1; frame < 4; ++frame) {
        EXPECT_EQ(next(50ms), FrameNews::frame);
        EXPECT_EQ(sphere(0).center.x, frame);
        EXPECT_EQ(sphere(0).color, (Color{1, 2, 3}));
        EXPECT_TRUE(sphere(1).hidden);
        EXPECT_EQ(sphere(1).radius, 0.125);
        EXPECT_EQ(name_of(state.scene(), 1), "proton");
        EXPECT_EQ(state.scene().background.color, (Color{9, 9, 9}));
        EXPECT_TRUE(state.document.is_changed()) << "closing asks";
        EXPECT_EQ(reach_of_edits(state), EditsReach::all_frames);
    }
    EXPECT_TRUE(state.dialogs.empty());
    run(CommandId::play);
    // What is taken back in one frame is taken back in all.
    edit(1, [](Sphere& s) { s.hidden = false; });
    run(CommandId::previous_frame);
    EXPECT_FALSE(sphere(1).hidden);
    EXPECT_EQ(sphere(0).color, (Color{1, 2, 3}));
    EXPECT_EQ(state.document.undo_name(), "Changes of all frames");
    undo(state);
    EXPECT_EQ(reach_of_edits(state), EditsReach::none);
    EXPECT_FALSE(state.document.is_changed());
    run(CommandId::previous_frame);
    EXPECT_NE(sphere(0).color, (Color{1, 2, 3}));
    EXPECT_NE(name_of(state.scene(), 1), "proton");
    EXPECT_FALSE(state.document.is_changed());
}

TEST_F(FramesInViewer, ChangesStayWithTheNumberInFramesOfAllSizes) {
    open(sized_frames({2, 1, 3, 2}));
    edit(1, [](Sphere& s) { s.hidden = true; });
    apply(state, {RenameSphere{1, "second"}, "Rename"});
    show_frame(state, 1);
    edit(0, [](Sphere& s) { s.color = {1, 2, 3}; });
    show_frame(state, 2);
    EXPECT_TRUE(sphere(1).hidden);
    EXPECT_EQ(name_of(state.scene(), 1), "second");
    EXPECT_EQ(sphere(0).color, (Color{1, 2, 3}));
    edit(2, [](Sphere& s) { s.radius = 0.125; });
    show_frame(state, 3);
    EXPECT_TRUE(sphere(1).hidden);
    EXPECT_EQ(sphere(0).color, (Color{1, 2, 3}));
    // What is taken back where some spheres are missing is taken back of the others.
    show_frame(state, 1);
    EXPECT_EQ(sphere(0).color, (Color{1, 2, 3}));
    undo(state);
    EXPECT_NE(sphere(0).color, (Color{1, 2, 3}));
    show_frame(state, 2);
    EXPECT_NE(sphere(0).color, (Color{1, 2, 3}));
    EXPECT_TRUE(sphere(1).hidden);
    EXPECT_EQ(sphere(2).radius, 0.125);
    undo(state);
    redo(state);
    show_frame(state, 0);
    EXPECT_TRUE(sphere(1).hidden);
    EXPECT_EQ(name_of(state.scene(), 1), "second");
    undo(state);
    show_frame(state, 2);
    EXPECT_FALSE(sphere(1).hidden);
    EXPECT_EQ(name_of(state.scene(), 1), "O");
    EXPECT_EQ(sphere(2).radius, 0.125);
}

// A frame that has none of the spheres that were changed does not hide that something is not saved.
TEST_F(FramesInViewer, WhatAFrameCannotShowIsAskedAboutAndKept) {
    open(sized_frames({2, 1, 1}));
    edit(1, [](Sphere& s) { s.hidden = true; });
    show_frame(state, 1);
    ASSERT_EQ(state.frame, 1);
    EXPECT_TRUE(state.document.is_changed());
    EXPECT_EQ(reach_of_edits(state), EditsReach::all_frames);
    show_frame(state, 2);
    EXPECT_TRUE(state.document.is_changed());
    // The recovery is of the frame that has them.
    for (const auto later : {0s, 10s, 20s}) state.autosave.look(state.document, state.path, Autosave::Clock::now() + later);
    state.autosave.finish();
    EXPECT_NE(keep_unsaved(state).find("are kept"), std::string::npos);
    std::size_t kept = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder.path("state/sphereview"))) {
        if (file.path().extension() != ".toml") continue;
        const Scene scene = load_scene(file.path().string()).scene;
        ASSERT_EQ(scene.spheres.size(), 2U);
        EXPECT_TRUE(scene.spheres[1].hidden);
        ++kept;
    }
    EXPECT_EQ(kept, 1U);
    quit(state);
    EXPECT_FALSE(state.quits);
    ASSERT_NE(question(), nullptr);
    EXPECT_NE(question()->text.find("Some are of spheres that frame 2 does not have"), std::string::npos) << question()->text;
    answer(0);
    ASSERT_FALSE(state.dialogs.empty());
    auto* browser = std::get_if<FileBrowser>(&state.dialogs.back());
    ASSERT_NE(browser, nullptr);
    const auto accept = browser->accept;
    state.dialogs.clear();
    accept(folder.path("saved.toml"), {});
    ASSERT_NE(question(), nullptr);
    EXPECT_EQ(question()->id, "frame-loses");
    answer(1);
    EXPECT_FALSE(state.saving);
    // The file has grown, the frame is the same: what other frames have is not thrown away.
    folder.write("a.xyz", sized_frames({2, 1, 1, 1}));
    look_at_file(state);
    EXPECT_TRUE(test::eventually([&] {
        finish_work(state);
        return !state.loading;
    }));
    ASSERT_NE(question(), nullptr);
    EXPECT_EQ(question()->id, "reload");
    answer(1);
    show_frame(state, 0);
    EXPECT_TRUE(sphere(1).hidden);
    // Once it is taken back there is nothing left.
    undo(state);
    show_frame(state, 1);
    EXPECT_FALSE(state.document.is_changed());
    EXPECT_EQ(reach_of_edits(state), EditsReach::none);
}

TEST_F(FramesInViewer, APlaceIsThisFramesAndAskedAboutOnce) {
    play();
    EXPECT_EQ(next(50ms), FrameNews::frame);
    edit(0, [](Sphere& s) { s.center.y = 5.0; });
    edit(0, [](Sphere& s) { s.color = {1, 2, 3}; });
    EXPECT_EQ(reach_of_edits(state), EditsReach::this_frame);
    EXPECT_EQ(next(50ms), FrameNews::stopped);
    EXPECT_FALSE(plays());
    ASSERT_NE(question(), nullptr);
    EXPECT_EQ(question()->id, "save-changes");
    answer(2);
    EXPECT_FALSE(plays());
    EXPECT_EQ(sphere(0).center.y, 5.0);
    play();
    ASSERT_NE(question(), nullptr) << "playing begins with the question";
    answer(1);
    EXPECT_TRUE(plays());
    now = PlayClock::Time::clock::now();
    for (int frame = 2; frame < 5; ++frame) {
        EXPECT_EQ(next(50ms), FrameNews::frame);
        EXPECT_EQ(sphere(0).center.y, 0.0);
        EXPECT_EQ(sphere(0).color, (Color{1, 2, 3}));
    }
    EXPECT_TRUE(state.dialogs.empty());
}

// A sphere that has come and gone again changes nothing; one that has come is this frame's own.
TEST_F(FramesInViewer, SpheresThatComeAreThisFrames) {
    run(CommandId::add_sphere);
    EXPECT_EQ(reach_of_edits(state), EditsReach::this_frame);
    undo(state);
    edit(0, [](Sphere& s) { s.hidden = true; });
    EXPECT_EQ(reach_of_edits(state), EditsReach::all_frames);
    run(CommandId::next_frame);
    EXPECT_TRUE(sphere(0).hidden);
    EXPECT_EQ(state.frame, 1);
    // What was done before one came is known by number.
    edit(0, [](Sphere& s) { s.hidden = false; });
    run(CommandId::add_sphere);
    run(CommandId::next_frame);
    answer(1);
    EXPECT_EQ(state.frame, 2);
    EXPECT_FALSE(sphere(0).hidden);
}

// Colours by a property are made of each frame's own values, in one range, and are no changes; what is coloured by hand besides is.
TEST_F(FramesInViewer, ColoursByAPropertyDoNotFlicker) {
    const LookPanelState& look = state.side_panel.look;
    color_by_charge();
    play();
    for (int frame = 1; frame < 4; ++frame) {
        EXPECT_EQ(next(50ms), FrameNews::frame);
        const auto grey = static_cast<double>(sphere(0).color.r);
        EXPECT_NEAR(grey, frame * 255.0 / 8.0, 1.0) << frame;
        EXPECT_EQ(look.shown.value_or(Coloring{}).range, (ValueRange{0.0, 8.0}));
        EXPECT_FALSE(state.document.is_changed());
    }
}

// What the file holds now is what is played.
TEST_F(FramesInViewer, AReloadKeepsPlayingAndForgetsWhatOthersGot) {
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

// As a simulation leaves it that begins again.
TEST_F(FramesInViewer, AFileThatHasBecomeShorterIsShownFromItsNewLastFrame) {
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

TEST_F(FramesInViewer, AFileThatBecomesShorterWhileItPlaysIsNoFault) {
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

TEST_F(FramesInViewer, AReloadWhileItPlaysKeepsTheColoursByAProperty) {
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

// Of a large file no more is read than the first frame needs; the others are counted meanwhile.
TEST_F(FramesInViewer, CountsTheFramesOfALargeFileBesideTheLoop) {
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

TEST_F(FramesInViewer, SaysWhereALargeFileIsBadBehindItsFirstFrame) {
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
