// What files hold of each sphere, in the viewer without a window: columns, properties, and colours and sizes by them.
#include "viewer/scene_properties.hpp"

#include <cmath>

#include "unit/data_in_viewer.hpp"

namespace sphereview {

namespace {

struct LargeFileInViewer : DataInViewer {
    LargeFileInViewer() {
        std::string table = "x,y,z,q,kind\n";
        for (std::size_t i = 0; i <= most_spheres_with_properties; ++i)
            table += std::to_string(i) + ",0,9," + std::to_string(i + 7) + ",a\n";
        large = folder.write("large.csv", table);
        open(large);
    }

    std::string large;
};

}  // namespace

// Colours by a property are those of every frame, in the range that was chosen, and no reason to ask for a save.
TEST_F(DataInViewer, OtherFramesAreColouredAlike) {
    step_to_next_frame();
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
    step_to_next_frame();
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
    open(other);
    EXPECT_EQ(state.scene().spheres[0].color, (Color{255, 13, 13}));
}

// What the reader of a file has to say is seen, also what only --verbose says elsewhere.
TEST_F(DataInViewer, SaysWhatWasMadeOfATable) {
    const std::string table = folder.write("t.csv", "x,y,z,mass\n0,0,0,5\n0,0,8,5\nnan,,,5\n");
    open(table);
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
    open(folder.write("small.csv", "x,y,z,q\n0,0,9,1\n1,0,9,2\n"));
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
    open(path);
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
    step_to_next_frame();
    ASSERT_EQ(state.frame, 1);
    EXPECT_EQ(state.scene().spheres[0].color, plain.spheres[0].color) << "oxygen's";
    EXPECT_EQ(state.scene().spheres[0].radius, plain.spheres[0].radius);
}

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
    look();
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
    open(*state.options.scene);
    ASSERT_EQ(state.scene().spheres.size(), 1U);
    EXPECT_EQ(state.scene().spheres[0].center, glm::dvec3(1, 2, 3));
    open(folder.write("b.csv", "x,y,z\n4,5,6\n"));
    EXPECT_EQ(state.scene().spheres.at(0).center, glm::dvec3(4, 5, 6));
}

}  // namespace sphereview
