// What is kept of changes that are for all frames, where frames are of several sizes, and how it comes back.
#include <algorithm>
#include <filesystem>
#include <numeric>

#include "unit/frames_in_viewer.hpp"
#include "viewer/offer_recovery.hpp"

namespace sphereview {

namespace {

using namespace std::chrono_literals;

// Frames of 2, 5, 3 and 1 atoms; that of 5 is shown.
struct FrameRecoveryTest : FramesInViewer {
    FrameRecoveryTest() {
        open(sized_frames({2, 5, 3, 1}));
        show_frame(state, 1);
    }

    void rename(std::uint32_t number, const std::string& name) { apply(state, {RenameSphere{number, name}, "Rename"}); }
    // As the loop does while nobody does anything.
    void wait_some_time() {
        for (int i = 0; i < 4; ++i) {
            state.autosave.look(state.document, edited_file(state), now += 1h);
            state.autosave.finish();
        }
    }
    // The smallest first.
    std::vector<Scene> kept() const {
        std::vector<Scene> scenes;
        for (const auto& file : std::filesystem::directory_iterator(folder.path("state/sphereview"))) {
            if (file.path().extension() == ".toml") scenes.push_back(load_scene(file.path().string()).scene);
        }
        std::ranges::sort(scenes, {}, [](const Scene& scene) { return scene.spheres.size(); });
        return scenes;
    }
    std::vector<std::size_t> kept_sizes() const {
        std::vector<std::size_t> sizes;
        for (const Scene& scene : kept()) sizes.push_back(scene.spheres.size());
        return sizes;
    }
    // As if the window was killed, and the next one asked.
    void kill_and_recover(const std::function<void()>& meanwhile = [] {}) {
        ASSERT_TRUE(state.autosave.keep(state.document, edited_file(state)));
        for (const auto& file : std::filesystem::directory_iterator(folder.path("state/sphereview"))) {
            if (file.path().extension() == ".toml") std::filesystem::copy_file(file, folder.path("left.toml"));
        }
        remove_own_recovery();
        adopt(state, {{}, "", SceneFormat::toml}, "");
        std::filesystem::rename(folder.path("left.toml"), folder.path("state/sphereview/recovery-1.toml"));
        meanwhile();
        const std::vector<Recovery> left = list_recoveries();
        ASSERT_EQ(left.size(), 1U);
        recover(state, left.front());
        EXPECT_TRUE(test::eventually([&] {
            finish_work(state);
            return !state.loading;
        }));
        EXPECT_TRUE(state.document.is_changed());
        EXPECT_TRUE(list_recoveries().empty()) << "this window's now";
    }
};

using Sizes = std::vector<std::size_t>;

}  // namespace

TEST_F(FrameRecoveryTest, ASmallFramesChangesAreKeptBesideThoseThatItLacks) {
    rename(4, "last");
    Sphere hidden = state.scene().spheres[3];
    hidden.hidden = true;
    apply(state, {ChangeSpheres{{3}, {hidden}}, "Hide"});
    show_frame(state, 0);
    wait_some_time();
    EXPECT_EQ(kept_sizes(), Sizes{5}) << "nothing is changed here";
    for (const std::string name : {"first", "still the first"}) {
        rename(0, name);
        wait_some_time();
        ASSERT_EQ(kept_sizes(), (Sizes{2, 5}));
        EXPECT_EQ(name_of(kept()[0], 0), name);
        EXPECT_EQ(name_of(kept()[1], 4), "last");
        EXPECT_TRUE(kept()[1].spheres[3].hidden);
    }
    // Where all are there again, one copy has all.
    show_frame(state, 1);
    wait_some_time();
    ASSERT_EQ(kept_sizes(), Sizes{5});
    EXPECT_EQ(name_of(kept()[0], 0), "still the first");
    EXPECT_EQ(name_of(kept()[0], 4), "last");
    EXPECT_TRUE(kept()[0].spheres[3].hidden);
}

// Else looking through frames of changing sizes would write a copy for each.
TEST_F(FrameRecoveryTest, OnlyWhatIsNewIsKeptBeforeASmallerFrame) {
    rename(4, "last");
    show_frame(state, 0);
    state.autosave.finish();
    ASSERT_EQ(kept_sizes(), Sizes{5});
    std::filesystem::remove_all(folder.path("state/sphereview"));
    std::filesystem::create_directories(folder.path("state/sphereview"));
    show_frame(state, 1);
    show_frame(state, 0);
    state.autosave.finish();
    EXPECT_EQ(kept_sizes(), Sizes{}) << "written again";
    show_frame(state, 1);
    state.player.clock.play(PlayClock::Time{});
    rename(3, "fourth");
    show_frame(state, 2);
    state.autosave.finish();
    ASSERT_EQ(kept_sizes(), Sizes{5}) << "also while a film plays";
    EXPECT_EQ(name_of(kept()[0], 3), "fourth");
}

TEST_F(FrameRecoveryTest, UndoInASmallFrameLosesNothingAtTheEnd) {
    std::vector<std::uint32_t> numbers(5);
    std::iota(numbers.begin(), numbers.end(), 0U);
    std::vector<Sphere> hidden = state.scene().spheres;
    for (Sphere& sphere : hidden) sphere.hidden = true;
    apply(state, {ChangeSpheres{numbers, hidden}, "Hide"});
    show_frame(state, 0);
    undo(state);
    EXPECT_TRUE(state.document.is_changed());
    state.autosave.finish();
    EXPECT_NE(keep_unsaved(state).find("are kept"), std::string::npos);
    ASSERT_EQ(kept_sizes(), (Sizes{2, 5}));
    EXPECT_FALSE(kept()[0].spheres[0].hidden);
    EXPECT_TRUE(std::ranges::all_of(kept()[1].spheres, &Sphere::hidden));
}

TEST_F(FrameRecoveryTest, NoMoreIsKeptThanHasSomethingOfItsOwn) {
    rename(4, "last");
    for (const std::string name : {"once", "twice"}) {
        for (const std::int64_t frame : {2, 3, 0}) {
            show_frame(state, frame);
            rename(0, name + std::to_string(frame));
            wait_some_time();
        }
    }
    ASSERT_EQ(kept_sizes(), (Sizes{2, 3, 5}));
    EXPECT_EQ(name_of(kept()[0], 0), "twice0");
    EXPECT_EQ(name_of(kept()[1], 0), "twice2");
    state.document.mark_saved();
    wait_some_time();
    EXPECT_TRUE(kept().empty()) << "saved, or given up";
}

TEST_F(FrameRecoveryTest, TheQuestionSaysWhatGoesAlong) {
    const auto words = [&] {
        show_frame(state, 0);
        const std::string text = std::get<Question>(state.dialogs.back()).text;
        state.dialogs.clear();
        return text;
    };
    Sphere moved = state.scene().spheres[0];
    moved.center.y = 1.0;
    apply(state, {ChangeSpheres{{0}, {moved}}, "Move"});
    EXPECT_TRUE(words().ends_with("hidden go along.")) << words();
    run_command(state, CommandId::add_sphere);
    EXPECT_TRUE(words().ends_with("only as they were before spheres were added, deleted or reordered here.")) << words();
}

TEST_F(FrameRecoveryTest, ARecoveredFrameIsOneOfItsFileAgain) {
    rename(1, "second");
    edit(1, [](Sphere& s) { s.hidden = true; });
    kill_and_recover();
    EXPECT_EQ(state.frames, 4);
    EXPECT_EQ(state.frame, 1);
    EXPECT_EQ(reach_of_edits(state), EditsReach::all_frames);
    show_frame(state, 2);
    EXPECT_TRUE(sphere(1).hidden);
    EXPECT_EQ(name_of(state.scene(), 1), "second");
    // What is recovered can be taken back, also around a reload.
    kill_and_recover();
    EXPECT_EQ(state.frame, 2);
    edit(0, [](Sphere& s) { s.color = {1, 2, 3}; });
    replace_file(sized_frames({2, 5, 3, 1, 1}));
    for (int i = 0; i < 3; ++i) undo(state);
    EXPECT_FALSE(sphere(1).hidden);
    EXPECT_EQ(reach_of_edits(state), EditsReach::none);
    for (int i = 0; i < 3; ++i) redo(state);
    EXPECT_FALSE(state.document.is_changed());
    for (int i = 0; i < 2; ++i) undo(state);
    EXPECT_TRUE(sphere(1).hidden);
    show_frame(state, 0);
    EXPECT_TRUE(sphere(1).hidden);
    EXPECT_NE(sphere(0).color, (Color{1, 2, 3}));
}

TEST_F(FrameRecoveryTest, ARecoveredPlaceIsTheFramesOwn) {
    edit(1, [](Sphere& s) { s.hidden = true; });
    edit(1, [](Sphere& s) { s.center.y = 5.0; });
    kill_and_recover();
    EXPECT_EQ(sphere(1).center.y, 5.0);
    EXPECT_EQ(reach_of_edits(state), EditsReach::this_frame);
    show_frame(state, 2);
    answer(1);
    EXPECT_TRUE(sphere(1).hidden);
    EXPECT_EQ(sphere(1).center.y, 0.0);
}

TEST_F(FrameRecoveryTest, RecoveredSpheresThatCameShareNothing) {
    edit(1, [](Sphere& s) { s.hidden = true; });
    state.selection.set_only(0);
    run(CommandId::remove);
    run(CommandId::add_sphere);
    kill_and_recover();
    EXPECT_EQ(state.frames, 4);
    EXPECT_EQ(reach_of_edits(state), EditsReach::this_frame);
    show_frame(state, 2);
    answer(1);
    EXPECT_FALSE(sphere(0).hidden);
}

TEST_F(FrameRecoveryTest, AKeptFileThatSaysWrongNumbersSharesNothing) {
    edit(1, [](Sphere& s) { s.hidden = true; });
    run(CommandId::add_sphere);
    kill_and_recover([&] {
        std::string text = folder.read("state/sphereview/recovery-1.toml");
        const std::size_t end = text.find('\n', text.find("# frame"));
        ASSERT_EQ(text.substr(end - 2, 2), " 0");
        folder.write("state/sphereview/recovery-1.toml", text.replace(end - 1, 1, "1"));
    });
    show_frame(state, 2);
    answer(1);
    EXPECT_FALSE(sphere(1).hidden);
}

TEST_F(FrameRecoveryTest, AFrameOfAFileThatHasChangedIsRecoveredAlone) {
    edit(1, [](Sphere& s) { s.hidden = true; });
    kill_and_recover([&] { folder.write("a.xyz", sized_frames({2, 5, 3})); });
    EXPECT_EQ(state.frames, 1);
    EXPECT_TRUE(sphere(1).hidden);
    EXPECT_EQ(state.path, path);
    kill_and_recover([&] { std::filesystem::remove(path); });
    EXPECT_TRUE(sphere(1).hidden);
}

TEST_F(FrameRecoveryTest, AFrameThatTheFileNoLongerHadIsRecoveredAlone) {
    for (const bool keeps : {true, false}) {
        SCOPED_TRACE(keeps);
        open(sized_frames({2, 5, 3}));
        show_frame(state, 1);
        edit(1, [](Sphere& s) { s.hidden = true; });
        replace_file(sized_frames({2, 6, 3, 1}), keeps ? 1 : 0);
        if (!keeps) undo(state);
        kill_and_recover();
        EXPECT_EQ(state.frames, 1);
        EXPECT_EQ(state.scene().spheres.size(), 5U);
        EXPECT_TRUE(sphere(1).hidden);
    }
}

}  // namespace sphereview
