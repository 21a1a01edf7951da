// Files of atoms in the viewer, without a window.
#include "viewer/scene_file.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>

#include "support/temporary_folder.hpp"
#include "viewer/command_table.hpp"
#include "viewer/perform.hpp"
#include "viewer/scene_properties.hpp"
#include "viewer/scene_saving.hpp"

namespace sphereview {

namespace {

constexpr const char* three_frames = "1\n\nO 0 0 100\n2\n\nO 1 0 100\nH 2 0 100\n2\n\nO 3 0 100\nH 4 0 100\n";

struct DataInViewer : testing::Test {
    DataInViewer() : path(folder.write("a.xyz", three_frames)), state(ViewOptions{}, ViewerSettings{}) {
        adopt(state, load_scene(path), path);
    }

    double x() const { return state.scene().spheres.at(0).center.x; }
    Question* question() { return state.dialogs.empty() ? nullptr : std::get_if<Question>(&state.dialogs.back()); }
    bool is_enabled(CommandId id) const { return info_of(commands_of(state), id).enabled; }
    void add_sphere() { run_command(state, CommandId::add_sphere); }
    void answer(int number) {
        ASSERT_NE(question(), nullptr);
        const auto asked = *question();
        state.dialogs.pop_back();
        asked.answer(number);
    }

    // A file is read beside the loop while edits are still being kept.
    void finish_reading() {
        while (state.loading) {
            state.loading->job.wait_for(std::chrono::milliseconds(100));
            finish_work(state);
        }
    }

    test::TemporaryFolder folder;
    std::string path;
    ViewerState state;
};

}  // namespace

// Of a file that is shown all the same, and of each frame.
TEST_F(DataInViewer, SaysWhatTheReaderWarnedOf) {
    EXPECT_EQ(state.messages.announcement, "");
    const std::string cut = folder.write("cut.xyz", "1\n\nO 0 0 1\n2\n\nO 0 0 1\nMW 0 0 1\n3\n");
    open_scene(state, cut);
    finish_reading();
    const std::string warning = cut + ":9:1: the text ends, expected the comment of frame 2; what follows frame 1 is passed over";
    EXPECT_EQ(state.messages.announcement, warning);
    run_command(state, CommandId::next_frame);
    finish_reading();
    EXPECT_EQ(state.messages.announcement, cut + ": found 1 virtual site or dummy, which is no atom; shown small");
    folder.write("cut.xyz", "1\n\nO 0 0 1\n2\n\nO 0 0 1\nXx 0 0 2\n");
    look_at_file(state);
    finish_reading();
    EXPECT_TRUE(state.messages.announcement.ends_with("shown small")) << state.messages.announcement;
}

// Colours by a property are those of every frame, in the range that was chosen, and no reason to ask for a save.
TEST_F(DataInViewer, OtherFramesAreColouredAlike) {
    run_command(state, CommandId::next_frame);
    finish_reading();
    LookPanelState& look = state.side_panel.look;
    const ColorBy by{.property = "x", .map = ColorMap::grey, .range = ValueRange{0.0, 8.0}};
    const auto color_by_x = [&] {
        Property own;
        const Property& x = *find_values(state.scene(), "x", own);
        const Coloring coloring = coloring_of(state.scene(), x, by);
        std::vector<Sphere> spheres = state.scene().spheres;
        for (std::size_t i = 0; i < spheres.size(); ++i) spheres[i].color = colors_of(x, coloring)[i];
        note_colors(look, {by, coloring});
        apply(state, {ChangeSpheres{{0, 1}, spheres}, "Colour", 0});
    };
    color_by_x();
    ASSERT_NE(shown_coloring(state.document, look), nullptr);
    EXPECT_TRUE(state.document.is_changed());
    run_command(state, CommandId::next_frame);
    finish_reading();
    EXPECT_EQ(question(), nullptr);
    EXPECT_EQ(state.frame, 2);
    EXPECT_EQ(state.scene().spheres[0].color, (Color{96, 96, 96})) << "x = 3 of 8";
    EXPECT_NE(shown_coloring(state.document, look), nullptr);
    EXPECT_FALSE(state.document.is_changed());
    // What is edited besides is asked about.
    add_sphere();
    run_command(state, CommandId::previous_frame);
    EXPECT_NE(question(), nullptr);
    // Another file has its own colours.
    answer(1);
    const std::string other = folder.write("b.xyz", three_frames);
    open_scene(state, other);
    finish_reading();
    EXPECT_EQ(state.scene().spheres[0].color, (Color{255, 13, 13}));
}

// Only in the window: what is rendered from the same file stays as it was. Another frame has the background too.
TEST_F(DataInViewer, HasAQuietBackgroundThatIsTheScenes) {
    const Background quiet{{32, 36, 48}, false};
    EXPECT_EQ(load_scene(path).scene.background, Background{});
    open_scene(state, path);
    finish_reading();
    EXPECT_EQ(state.shown_background(), quiet);
    EXPECT_FALSE(state.document.is_changed());
    run_command(state, CommandId::next_frame);
    finish_reading();
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
    finish_writing(state, std::chrono::seconds(30));
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
    open_scene(state, path);
    finish_reading();
    const std::string bytes = folder.read("a.xyz");
    std::filesystem::remove(path);
    look_at_file(state);
    EXPECT_EQ(state.messages.scene_gone, path);
    EXPECT_TRUE(state.document.is_changed()) << "the scene is in the window alone";
    look_at_file(state);
    EXPECT_EQ(state.messages.announcement, "") << "nothing is new";
    folder.write("a.xyz", bytes);
    look_at_file(state);
    finish_reading();
    EXPECT_EQ(state.messages.scene_gone, "");
    EXPECT_EQ(state.messages.announcement, path + " is there again");
    EXPECT_FALSE(state.document.is_changed());
    // Another content is taken without a question, for there are no edits.
    std::filesystem::remove(path);
    look_at_file(state);
    folder.write("a.xyz", "1\n\nO 9 0 100\n");
    look_at_file(state);
    finish_reading();
    EXPECT_EQ(x(), 9.0);
    EXPECT_TRUE(state.dialogs.empty());
    // Edits stay edits.
    add_sphere();
    std::filesystem::remove(path);
    look_at_file(state);
    folder.write("a.xyz", "1\n\nO 8 0 100\n");
    look_at_file(state);
    finish_reading();
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
    finish_writing(state, std::chrono::seconds(30));
    EXPECT_TRUE(folder.has("b.toml"));
    EXPECT_EQ(state.messages.scene_gone, "");
    look_at_file(state);
    EXPECT_FALSE(state.document.is_changed());
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

// What the reader of a file has to say is seen, also what only --verbose says elsewhere.
TEST_F(DataInViewer, SaysWhatWasMadeOfATable) {
    const std::string table = folder.write("t.csv", "x,y,z,mass\n0,0,0,5\n0,0,8,5\nnan,,,5\n");
    open_scene(state, table);
    finish_reading();
    EXPECT_EQ(state.scene().spheres.size(), 2U);
    const std::string& said = state.messages.announcement;
    EXPECT_NE(said.find("1 row has no coordinates"), std::string::npos) << said;
    EXPECT_NE(said.find("no radius in the file: all get 2, "), std::string::npos) << said;
    EXPECT_NE(said.find("passed over: 'mass'; the panel Colour and size can use them"), std::string::npos) << said;
    EXPECT_EQ(said.find("--"), std::string::npos) << "a window has no options: " << said;
    // It can be read in peace.
    EXPECT_GT(*state.announcement_ends - Clock::now(), std::chrono::seconds(8));
}

// Of a small file they are there at once; of another they are read when they are asked for.
TEST_F(DataInViewer, HasPropertiesOfSmallFilesAtOnce) {
    open_scene(state, folder.write("small.csv", "x,y,z,q\n0,0,9,1\n1,0,9,2\n"));
    finish_reading();
    EXPECT_EQ(state.property_names, std::vector<std::string>{"q"});
    ASSERT_EQ(state.scene().properties.size(), 1U);
    perform(state, {RequestProperties{}});
    EXPECT_FALSE(state.loading);
}

// What is read with colours by a property knows the file's own, and other frames are read without where these were chosen.
TEST_F(DataInViewer, OtherFramesHaveTheirOwnColoursAndSizesWhereTheseWereChosen) {
    const Scene plain = state.scene();
    state.options.scene = path;
    state.options.look.color_by = "x";
    state.options.look.radius_scale = 3.0;
    open_scene(state, path);
    finish_reading();
    ASSERT_NE(state.scene().spheres[0].color, plain.spheres[0].color);
    LookPanelState& look = state.side_panel.look;
    EXPECT_EQ(look.own.colors, std::vector<Color>{plain.spheres[0].color});
    EXPECT_EQ(look.own.radii, std::vector<double>{plain.spheres[0].radius});
    look.colors.property.clear();
    look.own.colors_chosen = true;
    look.own.sizes_chosen = true;
    std::vector<Sphere> own = state.scene().spheres;
    own[0].color = look.own.colors[0];
    own[0].radius = look.own.radii[0];
    perform(state, {EditScene{ChangeSpheres{{0}, own}, "Own colours", 0, true}});
    shown_coloring(state.document, look);
    run_command(state, CommandId::next_frame);
    finish_reading();
    ASSERT_EQ(state.frame, 1);
    EXPECT_EQ(state.scene().spheres[0].color, plain.spheres[0].color) << "oxygen's";
    EXPECT_EQ(state.scene().spheres[0].radius, plain.spheres[0].radius);
}

struct LargeFileInViewer : DataInViewer {
    LargeFileInViewer() {
        std::string table = "x,y,z,q,kind\n";
        for (std::size_t i = 0; i <= most_spheres_with_properties; ++i)
            table += std::to_string(i) + ",0,9," + std::to_string(i + 7) + ",a\n";
        large = folder.write("large.csv", table);
        open_scene(state, large);
        finish_reading();
    }

    std::string large;
};

TEST_F(LargeFileInViewer, HasPropertiesOnRequest) {
    EXPECT_EQ(state.property_names, (std::vector<std::string>{"q", "kind"}));
    EXPECT_TRUE(state.scene().properties.empty());
    EXPECT_TRUE(has_unread_properties(state));
    // What has moved meanwhile stays where it is.
    perform(state, {EditScene{ChangeSpheres{{3}, {{{}, 7.0}}}, "Move", 0}, RequestProperties{}, RequestProperties{}});
    finish_reading();
    ASSERT_EQ(state.scene().properties.size(), 2U);
    EXPECT_EQ(number_at(state.scene().properties[0], 3), 10.0);
    EXPECT_EQ(state.scene().spheres[3].radius, 7.0);
    EXPECT_FALSE(has_unread_properties(state));
    EXPECT_TRUE(state.document.is_changed());
    undo(state);
    EXPECT_FALSE(state.document.is_changed());
    // They stay when the file changes.
    folder.write("large.csv", "x,y,z,q\n0,0,9,5\n");
    look_at_file(state);
    finish_reading();
    ASSERT_EQ(state.scene().spheres.size(), 1U);
    ASSERT_EQ(state.scene().properties.size(), 1U);
    EXPECT_EQ(number_at(state.scene().properties[0], 0), 5.0);
}

TEST_F(LargeFileInViewer, GivesPropertiesToTheSpheresOfTheFileWhateverCameOrWent) {
    Sphere added;
    added.center = {-5, -5, -5};
    const auto last = static_cast<std::uint32_t>(state.scene().spheres.size() - 1);
    perform(state, {EditScene{ReorderSphere{0, 1}, "Reorder", 0}, EditScene{RemoveSpheres{{3, 4}}, "Delete", 0},
                    EditScene{InsertSpheres{{0}, {NamedSphere{added, ""}}}, "Add", 0}, RequestProperties{}});
    finish_reading();
    const auto q = [&](std::uint32_t sphere) { return number_at(state.scene().properties.at(0), sphere); };
    ASSERT_EQ(state.scene().properties.size(), 2U);
    EXPECT_TRUE(std::isnan(q(0))) << "added";
    EXPECT_EQ(q(1), 8.0) << "the file's second";
    EXPECT_EQ(q(2), 7.0);
    EXPECT_EQ(q(3), 9.0);
    EXPECT_EQ(q(4), 12.0) << "behind those that were deleted";
    EXPECT_EQ(q(last - 1), last + 7.0);
    EXPECT_EQ(text_at(state.scene().properties[1], 1), "a");
    EXPECT_NE(state.messages.announcement.find("1 sphere has no values"), std::string::npos) << state.messages.announcement;
}

TEST_F(LargeFileInViewer, AnUndoneColouringSelectsNothing) {
    perform(state, {SelectSpheres{Selection{}}});
    Sphere red = state.scene().spheres[5];
    red.color = {255, 0, 0};
    perform(state, {EditScene{ChangeSpheres{{5}, {red}}, "Colour by 'q'", 0, true}});
    run_command(state, CommandId::undo);
    EXPECT_TRUE(state.selection.empty());
    run_command(state, CommandId::redo);
    EXPECT_TRUE(state.selection.empty());
    perform(state, {EditScene{ChangeSpheres{{6}, {red}}, "Move", 0}});
    run_command(state, CommandId::undo);
    EXPECT_EQ(state.selection.numbers(), (std::vector<std::uint32_t>{6})) << "an edit by hand as ever";
}

// Those of the command line are of its table alone.
TEST_F(DataInViewer, HasTheColumnsThatAreAskedFor) {
    state.options.scene = folder.write("a.csv", "a,b,c\n1,2,3\n");
    state.options.data.columns = {{"x", "a"}, {"y", "b"}, {"z", "c"}};
    open_scene(state, *state.options.scene);
    finish_reading();
    ASSERT_EQ(state.scene().spheres.size(), 1U);
    EXPECT_EQ(state.scene().spheres[0].center, glm::dvec3(1, 2, 3));
    open_scene(state, folder.write("b.csv", "x,y,z\n4,5,6\n"));
    finish_reading();
    EXPECT_EQ(state.scene().spheres.at(0).center, glm::dvec3(4, 5, 6));
}

// A save writes the file anew, and a parsed file has no comments.
TEST_F(DataInViewer, CommentsAreNotDroppedUnasked) {
    const std::string commented = "# By hand.\nbackground = \"#102030\"\n";
    const auto save = [&] {
        run_command(state, CommandId::file_save);
        while (state.saving) {
            state.saving->job.wait_for(std::chrono::milliseconds(100));
            finish_work(state);
        }
    };
    const auto edit_and_save = [&](const std::string& file) {
        open_scene(state, file);
        finish_reading();
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
    while (state.saving) finish_work(state);
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
