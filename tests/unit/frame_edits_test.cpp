// What the edits of a frame mean to the others.
#include <filesystem>
#include <map>

#include "unit/frames_in_viewer.hpp"

namespace sphereview {

namespace {

using namespace std::chrono_literals;

struct FrameEditsTest : FramesInViewer {};

}  // namespace

TEST_F(FrameEditsTest, WhatIsSelectedAndMeasuredStaysByNumber) {
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
TEST_F(FrameEditsTest, WhatIsNoPlaceGoesAlong) {
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

TEST_F(FrameEditsTest, WhatIsUndoneCanBeRedoneInAnotherFrame) {
    const auto look_through = [&] {
        for (const CommandId step : {CommandId::last_frame, CommandId::previous_frame}) run(step);
        EXPECT_EQ(sphere(0).center.x, 3.0);
        EXPECT_EQ(sphere(0).center.y, 0.0);
        EXPECT_TRUE(state.dialogs.empty());
    };
    edit(0, [](Sphere& s) { s.color = {1, 2, 3}; });
    edit(0, [](Sphere& s) { s.color = {4, 5, 6}; });
    apply(state, {RenameSphere{1, "proton"}, "Rename"});
    edit(0, [](Sphere& s) { s.center.y = 5.0; });
    run(CommandId::add_sphere);
    for (int i = 0; i < 4; ++i) undo(state);
    look_through();
    EXPECT_EQ(sphere(0).color, (Color{1, 2, 3}));
    EXPECT_EQ(name_of(state.scene(), 1), "H");
    EXPECT_EQ(state.document.redo_name(), "Changes of all frames");
    undo(state);
    EXPECT_FALSE(state.document.is_changed());
    look_through();
    EXPECT_NE(sphere(0).color, (Color{1, 2, 3}));
    EXPECT_FALSE(state.document.is_changed());
    redo(state);
    EXPECT_FALSE(state.document.can_redo()) << "a place, and a sphere that was added, are of the other frame";
    look_through();
    EXPECT_EQ(sphere(0).color, (Color{4, 5, 6}));
    EXPECT_EQ(name_of(state.scene(), 1), "proton");
    EXPECT_FALSE(state.document.can_redo());
    // An edit ends it, in whatever frame.
    undo(state);
    run(CommandId::next_frame);
    edit(1, [](Sphere& s) { s.hidden = true; });
    run(CommandId::previous_frame);
    EXPECT_FALSE(state.document.can_redo());
}

TEST_F(FrameEditsTest, WhatASmallFrameCannotRedoOthersCan) {
    open(sized_frames({2, 1, 2}));
    edit(0, [](Sphere& s) { s.color = {1, 2, 3}; });
    edit(1, [](Sphere& s) { s.hidden = true; });
    undo(state);
    show_frame(state, 1);
    EXPECT_EQ(sphere(0).color, (Color{1, 2, 3}));
    EXPECT_FALSE(state.document.can_redo());
    show_frame(state, 2);
    EXPECT_FALSE(sphere(1).hidden);
    redo(state);
    EXPECT_TRUE(sphere(1).hidden);
    undo(state);
    show_frame(state, 1);
    edit(0, [](Sphere& s) { s.radius = 0.125; });
    show_frame(state, 2);
    EXPECT_FALSE(state.document.can_redo()) << "something else was done since";
}

// Sizes and colours by a property are made anew of each frame's own values.
TEST_F(FrameEditsTest, AnUndoneLookIsRedoneInItsFrameAlone) {
    edit(1, [](Sphere& s) { s.hidden = true; });
    state.look_steps.insert("Colour");
    color_by_charge();
    undo(state);
    run(CommandId::next_frame);
    EXPECT_FALSE(state.document.can_redo());
    EXPECT_TRUE(sphere(1).hidden);
}

TEST_F(FrameEditsTest, ChangesStayWithTheNumberInFramesOfAllSizes) {
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
TEST_F(FrameEditsTest, WhatAFrameCannotShowIsAskedAboutAndKept) {
    open(sized_frames({2, 1, 1}));
    edit(1, [](Sphere& s) { s.hidden = true; });
    show_frame(state, 1);
    ASSERT_EQ(state.frame, 1);
    EXPECT_TRUE(state.document.is_changed());
    EXPECT_EQ(reach_of_edits(state), EditsReach::all_frames);
    show_frame(state, 2);
    EXPECT_TRUE(state.document.is_changed());
    // The recovery is of the frame that has them.
    for (const auto later : {0s, 10s, 20s}) state.autosave.look(state.document, edited_file(state), Autosave::Clock::now() + later);
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

TEST_F(FrameEditsTest, APlaceIsThisFramesAndAskedAboutOnce) {
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
TEST_F(FrameEditsTest, SpheresThatComeAreThisFrames) {
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
TEST_F(FrameEditsTest, ColoursByAPropertyDoNotFlicker) {
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

TEST_F(FrameEditsTest, ACategoryHasOneColourInAllFrames) {
    const auto frame = [](const std::string& first, const std::string& second) {
        return "2\nProperties=species:S:1:pos:R:3:v:S:1\nO 0 0 100 " + first + "\nO 0 3 100 " + second + "\n";
    };
    open(frame("a", "b") + frame("b", "c") + frame("c", "c") + frame("a", "c") + frame("c", "b"));
    color_by({.property = "v"});
    std::map<std::string, Color> colors = {{"a", sphere(0).color}, {"b", sphere(1).color}};
    run(CommandId::next_frame);
    colors["c"] = sphere(1).color;
    EXPECT_EQ(sphere(0).color, colors["b"]);
    EXPECT_TRUE(colors["c"] != colors["a"] && colors["c"] != colors["b"]);
    for (const auto& [first, second] : {std::pair("c", "c"), std::pair("a", "c"), std::pair("c", "b")}) {
        run(CommandId::next_frame);
        EXPECT_EQ(sphere(0).color, colors[first]) << state.frame;
        EXPECT_EQ(sphere(1).color, colors[second]) << state.frame;
        EXPECT_FALSE(state.document.is_changed());
    }
}

}  // namespace sphereview
