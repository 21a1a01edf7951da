// The file of the scene in the viewer: opened, stepped through, changed, gone, saved. Without a window.
#include "viewer/scene_file.hpp"

#include <sys/stat.h>

#include <filesystem>

#include "unit/data_in_viewer.hpp"

namespace sphereview {

// Of a file that is shown all the same, and of each frame.
TEST_F(DataInViewer, SaysWhatTheReaderWarnedOf) {
    EXPECT_EQ(state.messages.announcement, "");
    const std::string cut = folder.write("cut.xyz", "1\n\nO 0 0 1\n2\n\nO 0 0 1\nMW 0 0 1\n3\n");
    open(cut);
    const std::string warning = cut + ":9:1: the text ends, expected the comment of frame 2; what follows frame 1 is passed over";
    EXPECT_EQ(state.messages.announcement, warning);
    step_to_next_frame();
    EXPECT_EQ(state.messages.announcement, cut + ": found 1 virtual site or dummy, which is no atom; shown small");
    folder.write("cut.xyz", "1\n\nO 0 0 1\n2\n\nO 0 0 1\nXx 0 0 2\n");
    look();
    EXPECT_TRUE(state.messages.announcement.ends_with("shown small")) << state.messages.announcement;
}

// Only in the window: what is rendered from the same file stays as it was. Another frame has the background too.
TEST_F(DataInViewer, HasAQuietBackgroundThatIsTheScenes) {
    const Background quiet{{32, 36, 48}, false};
    EXPECT_EQ(load_scene(path).scene.background, Background{});
    open(path);
    EXPECT_EQ(state.shown_background(), quiet);
    EXPECT_FALSE(state.document.is_changed());
    step_to_next_frame();
    EXPECT_EQ(state.frame, 1);
    EXPECT_EQ(state.scene().background, quiet);
    perform(state, {EditScene{ChangeBackground{Background{}}, "Change background", 0}});
    EXPECT_EQ(state.shown_background(), Background{});
    open_scene(state, folder.write("plain.txt", "1\n255 0 0 0 0 100 10\n"));
    EXPECT_EQ(question()->id, "save-changes");
}

TEST_F(DataInViewer, FramesAreSteppedThroughWithViewAndSelection) {
    EXPECT_EQ(state.frames, 3);
    EXPECT_FALSE(is_enabled(CommandId::previous_frame));
    state.camera.eye.x = 7.0;
    state.selection.set_only(0);
    run_command(state, CommandId::next_frame);
    EXPECT_EQ(state.frame, 1);
    EXPECT_EQ(x(), 1.0);
    EXPECT_EQ(state.camera.eye.x, 7.0);
    EXPECT_TRUE(state.selection.empty()) << "of another number of spheres";
    EXPECT_FALSE(state.document.is_changed() || state.document.can_undo());
    state.selection.set_only(1);
    perform(state, {ShowFrame{2}});
    EXPECT_EQ(x(), 3.0);
    EXPECT_EQ(state.selection.numbers(), std::vector<std::uint32_t>{1});
    EXPECT_FALSE(is_enabled(CommandId::next_frame));
    for (const std::int64_t frame : {std::int64_t{-1}, std::int64_t{3}}) show_frame(state, frame);
    EXPECT_EQ(state.frame, 2);
    run_command(state, CommandId::previous_frame);
    EXPECT_EQ(state.frame, 1);
    EXPECT_TRUE(state.dialogs.empty());
}

TEST_F(DataInViewer, AStepAsksAboutEdits) {
    add_sphere();
    run_command(state, CommandId::next_frame);
    ASSERT_NE(question(), nullptr);
    EXPECT_EQ(question()->id, "save-changes");
    answer(2);
    EXPECT_EQ(state.frame, 0);
    EXPECT_TRUE(state.document.is_changed());
    run_command(state, CommandId::next_frame);
    answer(1);
    finish_reading();
    EXPECT_EQ(state.frame, 1);
    EXPECT_EQ(state.scene().spheres.size(), 2U);
    EXPECT_FALSE(state.document.is_changed());
}

TEST_F(DataInViewer, SavingAsksForAnotherName) {
    add_sphere();
    run_command(state, CommandId::file_save);
    ASSERT_FALSE(state.dialogs.empty());
    const auto* browser = std::get_if<FileBrowser>(&state.dialogs.back());
    ASSERT_NE(browser, nullptr);
    EXPECT_EQ(browser->name, "a.toml");
    const auto accept = browser->accept;
    state.dialogs.clear();
    accept(folder.path("b.csv"), {});  // which it could not write
    ASSERT_NE(question(), nullptr);
    EXPECT_EQ(question()->id, "error");
    EXPECT_FALSE(folder.has("b.csv"));
    state.dialogs.clear();
    accept(folder.path("b.toml"), {});
    finish_writing();
    EXPECT_EQ(state.path, folder.path("b.toml"));
    EXPECT_EQ(state.format, SceneFormat::toml);
    EXPECT_EQ(state.frames, 1);
    EXPECT_EQ(load_scene(state.path).scene, state.scene());
    EXPECT_EQ(folder.read("a.xyz"), three_frames);
}

TEST_F(DataInViewer, AChangedFileIsReadAgainAtTheSameFrame) {
    show_frame(state, 1);
    folder.write("a.xyz", "0\n\n1\n\nO 9 0 100\n");
    look_at_file(state);
    EXPECT_EQ(x(), 9.0);
    EXPECT_EQ(state.frame, 1);
    EXPECT_EQ(state.frames, 2);
    folder.write("a.xyz", "0\n\n");
    look_at_file(state);
    EXPECT_EQ(state.messages.scene_error, "");
    EXPECT_EQ(state.frame, 0) << "the last that there is now";
    EXPECT_TRUE(state.scene().spheres.empty());
    undo(state);
    EXPECT_EQ(x(), 9.0);
}

TEST_F(DataInViewer, AFileThatIsGoneIsSaidAndAFileThatIsBackToo) {
    open(path);
    const std::string bytes = folder.read("a.xyz");
    std::filesystem::remove(path);
    look_at_file(state);
    EXPECT_EQ(state.messages.scene_gone, path);
    EXPECT_TRUE(state.document.is_changed()) << "the scene is in the window alone";
    look_at_file(state);
    EXPECT_EQ(state.messages.announcement, "") << "nothing is new";
    folder.write("a.xyz", bytes);
    look();
    EXPECT_EQ(state.messages.scene_gone, "");
    EXPECT_EQ(state.messages.announcement, path + " is there again");
    EXPECT_FALSE(state.document.is_changed());
    // Another content is taken without a question, for there are no edits.
    std::filesystem::remove(path);
    look_at_file(state);
    folder.write("a.xyz", "1\n\nO 9 0 100\n");
    look();
    EXPECT_EQ(x(), 9.0);
    EXPECT_TRUE(state.dialogs.empty());
    // Edits stay edits.
    add_sphere();
    std::filesystem::remove(path);
    look_at_file(state);
    folder.write("a.xyz", "1\n\nO 8 0 100\n");
    look();
    ASSERT_NE(question(), nullptr);
    EXPECT_EQ(question()->id, "reload");
    EXPECT_TRUE(state.document.is_changed());
}

TEST_F(DataInViewer, SavingEndsThatTheFileIsGone) {
    adopt(state, load_scene(folder.write("b.toml", "background = 'white'\n")), folder.path("b.toml"));
    std::filesystem::remove(folder.path("b.toml"));
    look_at_file(state);
    EXPECT_EQ(state.messages.scene_gone, folder.path("b.toml"));
    save_scene(state);
    finish_writing();
    EXPECT_TRUE(folder.has("b.toml"));
    EXPECT_EQ(state.messages.scene_gone, "");
    look_at_file(state);
    EXPECT_FALSE(state.document.is_changed());
}

// It is neither read, which would wait for somebody who writes, nor written into, where the scene would be lost.
TEST_F(DataInViewer, AFifoInThePlaceOfTheFileIsNotTheScene) {
    const std::string scene = folder.write("b.toml", "background = 'white'\n");
    adopt(state, load_scene(scene), scene);
    add_sphere();
    std::filesystem::remove(scene);
    ASSERT_EQ(mkfifo(scene.c_str(), 0600), 0);
    const auto save = [&] {
        state.messages.announcement.clear();
        save_scene(state);
        finish_writing();
    };
    for (const bool noticed : {false, true}) {
        if (noticed) look_at_file(state);
        EXPECT_FALSE(state.loading) << "nobody writes there";
        save();
        ASSERT_NE(question(), nullptr);
        EXPECT_EQ(question()->text, scene + ": cannot be written: it is no regular file");
        EXPECT_EQ(state.messages.announcement, "");
        EXPECT_TRUE(state.document.is_changed());
        state.dialogs.clear();
    }
    EXPECT_EQ(state.messages.scene_gone,
              scene + ": not while something else than a regular file stands there; save under another name");
    EXPECT_TRUE(std::filesystem::is_fifo(scene));
    std::filesystem::remove(scene);
    save();
    EXPECT_EQ(state.messages.announcement, "Saved " + scene);
    EXPECT_FALSE(state.document.is_changed());
}

TEST_F(DataInViewer, ANameWithALineFeedIsSaidOnOneLine) {
    const std::string scene = folder.write("a\nb.toml", "background = 'white'\n");
    adopt(state, load_scene(scene), scene);
    save_scene(state);
    finish_writing();
    EXPECT_EQ(state.messages.announcement, "Saved " + folder.path("a\\x0ab.toml"));
    std::filesystem::remove(scene);
    look_at_file(state);
    EXPECT_EQ(state.messages.scene_gone, folder.path("a\\x0ab.toml"));
}

TEST(RadiusOption, HoldsForEveryFileThatIsOpened) {
    const test::TemporaryFolder folder;
    ViewOptions options;
    options.data = {1, 0.25};
    ViewerState state(options, ViewerSettings{});
    open_scene(state, folder.write("a.xyz", three_frames));
    EXPECT_EQ(state.frame, 0) << "the frame is of the first file alone";
    EXPECT_EQ(state.scene().spheres.at(0).radius, 0.25);
    show_frame(state, 1);
    EXPECT_EQ(state.scene().spheres.at(1).radius, 0.25);
    open_scene(state, folder.write("b.csv", "x,y,z\n1,2,3\n"));
    EXPECT_EQ(state.scene().spheres.at(0).radius, 0.25);
    EXPECT_FALSE(info_of(commands_of(state), CommandId::next_frame).enabled);
}

// A save writes the file anew, and a parsed file has no comments.
TEST_F(DataInViewer, CommentsAreNotDroppedUnasked) {
    const std::string commented = "# By hand.\nbackground = \"#102030\"\n";
    const auto save = [&] {
        run_command(state, CommandId::file_save);
        finish_writing();
    };
    const auto edit_and_save = [&](const std::string& file) {
        open(file);
        add_sphere();
        save();
    };
    edit_and_save(folder.write("hand.toml", commented));
    ASSERT_NE(question(), nullptr);
    EXPECT_EQ(question()->id, "drops-comments");
    answer(2);
    EXPECT_EQ(folder.read("hand.toml"), commented);
    EXPECT_TRUE(state.document.is_changed());
    save();
    answer(0);
    ASSERT_FALSE(state.dialogs.empty());
    EXPECT_TRUE(std::holds_alternative<FileBrowser>(state.dialogs.back()));
    state.dialogs.clear();
    save();
    answer(1);
    finish_writing();
    EXPECT_NE(folder.read("hand.toml"), commented);
    EXPECT_FALSE(state.document.is_changed());
    add_sphere();
    save();
    EXPECT_TRUE(state.dialogs.empty()) << "the comments are gone";
    for (const std::string content : {"background = \"#102030\"\n", "# An empty scene.\n"}) {
        edit_and_save(folder.write("plain.toml", content));
        EXPECT_TRUE(state.dialogs.empty()) << content;
        EXPECT_FALSE(state.document.is_changed());
    }
}

}  // namespace sphereview
