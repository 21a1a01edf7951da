// The commands of the Edit and View menus on the viewer's state, without a window.
#include "viewer/perform.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "base/number.hpp"
#include "camera/navigation.hpp"
#include "support/spheres.hpp"
#include "unit/projection.hpp"
#include "viewer/layout.hpp"

namespace sphereview {

namespace {

struct Commands : testing::Test {
    Commands() : state(ViewOptions{}, ViewerSettings{}) {
        Scene scene = scene_of({Sphere{.center = {0, 0, 300}, .radius = 60, .color = {255, 0, 0}},
                                Sphere{.center = {100, 0, 300}, .radius = 30, .color = {0, 255, 0}}});
        state.document = Document(scene);
        state.camera = scene.camera;
        state.pivot = {0, 0, 300};
        before = scene;
    }

    bool is_enabled(CommandId id) const { return info_of(commands_of(state), id).enabled; }
    bool is_checked(CommandId id) const { return info_of(commands_of(state), id).checked; }

    // Instead of the system's.
    std::string* use_clipboard() {
        state.clipboard = {[this] { return clipboard; }, [this](const std::string& text) { clipboard = text; }};
        return &clipboard;
    }

    Scene before;
    ViewerState state;
    std::string clipboard;
};

}  // namespace

TEST_F(Commands, EachIsOneStepThatUndoes) {
    for (const CommandId id : {CommandId::add_sphere, CommandId::duplicate, CommandId::remove, CommandId::hide,
                               CommandId::move_down, CommandId::use_view_as_camera}) {
        SCOPED_TRACE(std::string(info_of(commands_of(state), id).label));
        state.selection.set_only(0);
        state.camera.eye.x = 5.0;
        ASSERT_TRUE(is_enabled(id));
        run_command(state, id);
        EXPECT_TRUE(state.document.is_changed());
        run_command(state, CommandId::undo);
        EXPECT_FALSE(state.document.can_undo());
        EXPECT_FALSE(state.document.is_changed());
        EXPECT_EQ(state.scene().spheres, before.spheres);
        EXPECT_EQ(state.scene().camera, before.camera);
    }
}

// What the command line says of the light holds until the light is edited.
TEST_F(Commands, AnEditOfTheLightReplacesTheCommandLines) {
    state.light.sky = 0.5;
    state.light.sun_strength = 2.0;  // of a sun that this scene does not have
    EXPECT_EQ(state.shown_light(), (Light{.lights = {}, .sky = 0.5}));
    Light edited = state.shown_light();
    edited.key = 0.25;
    perform(state, {EditScene{ChangeLight{edited}, "Change the key light"}});
    EXPECT_EQ(state.scene().light, edited);
    EXPECT_EQ(state.shown_light(), edited);
    run_command(state, CommandId::undo);
    EXPECT_EQ(state.shown_light(), Light{});
}

TEST_F(Commands, WithoutASelectionThereIsNothingToDo) {
    for (const CommandId id : {CommandId::duplicate, CommandId::remove, CommandId::hide, CommandId::move_up, CommandId::move_down,
                               CommandId::rename, CommandId::undo, CommandId::redo, CommandId::use_view_as_camera}) {
        EXPECT_FALSE(is_enabled(id)) << info_of(commands_of(state), id).label;
        run_command(state, id);
        EXPECT_FALSE(state.document.can_undo());
    }
    state.selection.set_only(0);
    EXPECT_FALSE(is_enabled(CommandId::move_up));
    EXPECT_TRUE(is_enabled(CommandId::move_down));
}

TEST_F(Commands, WhatWasAddedOrMovedIsSelected) {
    run_command(state, CommandId::add_sphere);
    EXPECT_EQ(state.selection.numbers(), std::vector<std::uint32_t>{2});
    state.selection.set({0, 1});
    run_command(state, CommandId::duplicate);
    EXPECT_EQ(state.selection.numbers(), (std::vector<std::uint32_t>{3, 4}));
    run_command(state, CommandId::remove);
    EXPECT_TRUE(state.selection.empty());
    state.selection.set_only(0);
    run_command(state, CommandId::move_down);
    EXPECT_EQ(state.selection.numbers(), std::vector<std::uint32_t>{1});
}

TEST_F(Commands, UndoSelectsWhatWasSelectedBeforeSpheresWereAdded) {
    state.selection.set_only(1);
    for (int i = 0; i < 3; ++i) run_command(state, CommandId::duplicate);
    run_command(state, CommandId::add_sphere);
    EXPECT_EQ(state.selection.numbers(), (std::vector<std::uint32_t>{5}));
    run_command(state, CommandId::undo);
    EXPECT_EQ(state.selection.numbers(), (std::vector<std::uint32_t>{4}));
    for (int i = 0; i < 3; ++i) run_command(state, CommandId::undo);
    EXPECT_EQ(state.selection.numbers(), (std::vector<std::uint32_t>{1}));
    run_command(state, CommandId::redo);
    EXPECT_EQ(state.selection.numbers(), (std::vector<std::uint32_t>{2}));
}

// What the command line asks for holds for its run; what is chosen in the window is remembered.
TEST_F(Commands, TheCommandLinesLookIsNotRemembered) {
    state.settings.shading = Shading::flat;
    state.settings.samples = 1;
    state.settings.export_width = 12;
    EXPECT_EQ(settings_to_keep(state), ViewerSettings{});
    run_command(state, CommandId::no_anti_aliasing);
    EXPECT_EQ(settings_to_keep(state).samples, 1) << "chosen, though it was so already";
    EXPECT_EQ(settings_to_keep(state).shading, Shading::studio);
    choose_size(state, &ViewerSettings::export_width, &ViewerSettings::export_height, {12, 1000});
    EXPECT_EQ(settings_to_keep(state).export_width, 1000) << "what the dialog offered";
    choose_size(state, &ViewerSettings::export_width, &ViewerSettings::export_height, {12, 13});
    EXPECT_EQ(settings_to_keep(state).export_width, 12);
    EXPECT_EQ(settings_to_keep(state).export_height, 13);
}

TEST_F(Commands, AClickInThePictureScrollsTheListAndOneInTheListDoesNot) {
    Selection selection;
    selection.set_only(1);
    perform(state, {SelectSpheres{selection}});
    EXPECT_FALSE(state.side_panel.scroll_to_selection);
    perform(state, {SelectSpheres{selection, true}});
    EXPECT_TRUE(state.side_panel.scroll_to_selection);
}

TEST_F(Commands, CopiedSpheresArePastedBesideTheirOriginals) {
    const std::string* text = use_clipboard();
    EXPECT_FALSE(is_enabled(CommandId::copy) || is_enabled(CommandId::cut));
    state.selection.set({0, 1});
    run_command(state, CommandId::copy);
    EXPECT_EQ(*text, "2\n255 0 0\n0 0 300\n60\n0 255 0\n100 0 300\n30\n");
    EXPECT_FALSE(state.document.is_changed());
    for (int i = 0; i < 2; ++i) run_command(state, CommandId::paste);
    ASSERT_EQ(state.scene().spheres.size(), 6U);
    EXPECT_EQ(state.selection.numbers(), (std::vector<std::uint32_t>{4, 5}));
    for (const std::size_t i : {2U, 3U, 4U, 5U}) {
        Sphere expected = before.spheres[i % 2];
        expected.center.x += i < 4 ? 60.0 : 120.0;
        EXPECT_EQ(state.scene().spheres[i], expected) << i;
    }
    EXPECT_EQ(state.document.undo_name(), "Paste 2 spheres");
    for (int i = 0; i < 2; ++i) run_command(state, CommandId::undo);
    EXPECT_EQ(state.scene().spheres, before.spheres);
}

// Into another scene, coordinates stay what they are unless the very same sphere stands there.
TEST_F(Commands, PastedSpheresStayWhereTheyWere) {
    std::string* text = use_clipboard();
    *text = "2\n9 9 9\n0 0 300\n61\n8 8 8\n-40 0 200\n5\n";  // the first is around sphere 0 and has its centre
    run_command(state, CommandId::paste);
    ASSERT_EQ(state.scene().spheres.size(), 4U);
    EXPECT_EQ(state.scene().spheres[2].center, glm::dvec3(0, 0, 300));
    EXPECT_EQ(state.scene().spheres[3].center, glm::dvec3(-40, 0, 200));
    EXPECT_FALSE(state.messages.announcement.starts_with("Pasted beside")) << state.messages.announcement;
    run_command(state, CommandId::paste);
    EXPECT_EQ(state.scene().spheres[5].center, glm::dvec3(21, 0, 200));
    EXPECT_EQ(state.messages.announcement, "Pasted beside where they were, by (61, 0, 0): the same spheres stand there already.");
}

TEST_F(Commands, CutTakesNamesAndHiddenSpheresAlong) {
    use_clipboard();
    state.document.apply(RenameSphere{1, "moon"}, "");
    state.selection.set_only(1);
    run_command(state, CommandId::hide);
    const Scene cut = state.scene();
    run_command(state, CommandId::cut);
    EXPECT_EQ(state.scene().spheres.size(), 1U);
    run_command(state, CommandId::paste);
    EXPECT_EQ(state.scene().spheres, cut.spheres) << "where it was: that place is free";
    EXPECT_EQ(state.scene().names, cut.names);
}

TEST_F(Commands, WhatIsNoSceneIsNotPasted) {
    std::string* text = use_clipboard();
    for (const auto& [content, message] :
         {std::pair("", "Nothing to paste: the clipboard holds no text."), std::pair("0\n", "Nothing to paste: no sphere."),
          std::pair("hello, world", "Nothing to paste: clipboard:1:1: ")}) {
        *text = content;
        run_command(state, CommandId::paste);
        EXPECT_TRUE(state.messages.announcement.starts_with(message)) << state.messages.announcement;
        EXPECT_EQ(state.messages.announcement.find('\n'), std::string::npos);
        EXPECT_FALSE(state.document.can_undo());
    }
}

TEST_F(Commands, SpheresAreAddedBesideOthersWhateverTheScreensSize) {
    std::vector<std::vector<Sphere>> added;
    use_clipboard();
    for (const int exponent : exponents_of_screens) {
        state.document = Document(before);
        state.camera = camera_of_screen(exponent);
        state.selection.set_only(0);
        for (const CommandId id : {CommandId::copy, CommandId::paste, CommandId::duplicate, CommandId::add_sphere})
            run_command(state, id);
        added.push_back(state.scene().spheres);
        ASSERT_EQ(added.back().size(), 5U);
        EXPECT_TRUE(std::isfinite(added.back().back().radius)) << exponent;
        if (exponent > 0) added.back().back() = added.front().back();  // it is beside the screen, far away
        EXPECT_EQ(added.back(), added.front()) << exponent;
    }
}

TEST_F(Commands, NoSphereIsAddedInsideAnotherOrWhereNobodySeesIt) {
    for (int i = 0; i < 9; ++i) run_command(state, CommandId::add_sphere);
    const std::vector<Sphere>& spheres = state.scene().spheres;
    for (std::size_t i = 2; i < spheres.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GE(glm::distance(spheres[i].center, spheres[j].center), std::max(spheres[i].radius, spheres[j].radius));
        }
        const auto place = place_of(state.camera, state.picture_size, spheres[i].center);
        ASSERT_TRUE(place) << i;
        EXPECT_TRUE(place->x > 0.0 && place->x < state.picture_size.width && place->y > 0.0 && place->y < state.picture_size.height)
            << i << ": " << place->x << ", " << place->y;
        EXPECT_LE(shortest(spheres[i].center.x).size() + shortest(spheres[i].radius).size(), 12U) << "few digits";
    }
}

TEST_F(Commands, WhatIsShownIsMarked) {
    for (const CommandId toggle : {CommandId::toggle_panel, CommandId::toggle_inspector, CommandId::toggle_export_area}) {
        const bool was = is_checked(toggle);
        run_command(state, toggle);
        EXPECT_NE(is_checked(toggle), was);
    }
}

TEST_F(Commands, TheOtherProjectionIsAViewAndComesBack) {
    EXPECT_FALSE(is_checked(CommandId::orthographic));
    run_command(state, CommandId::orthographic);
    EXPECT_TRUE(is_checked(CommandId::orthographic));
    // The screen is where the pivot is.
    EXPECT_EQ(state.camera, (Camera{{0, 0, 0}, {0, 0, 300}, {150, 0, 0}, {0, 150, 0}, Projection::orthographic}));
    EXPECT_FALSE(state.document.can_undo());
    EXPECT_EQ(state.scene().camera, before.camera);
    run_command(state, CommandId::fit_all);
    ASSERT_TRUE(state.flight);
    EXPECT_TRUE(state.flight->last().orthographic());
    run_command(state, CommandId::orthographic);
    EXPECT_EQ(state.camera, (Camera{{0, 0, 0}, {0, 0, 300}, {150, 0, 0}, {0, 150, 0}}));
}

TEST_F(Commands, TheViewIsWhatACameraIsEditedTo) {
    Camera edited = before.camera;
    edited.eye.z = -40.0;
    state.flight.emplace(before.camera, edited, glm::dvec3(0.0));
    perform(state, {EditScene{ChangeCamera{edited, true}, "Move the camera's eye"}});
    EXPECT_EQ(state.camera, edited);
    EXPECT_FALSE(state.flight);
    run_command(state, CommandId::undo);
    EXPECT_EQ(state.camera, before.camera);
    run_command(state, CommandId::redo);
    EXPECT_EQ(state.camera, edited);
    // Who looks from elsewhere goes on to do so.
    state.camera.eye.x = 7.0;
    const Camera elsewhere = state.camera;
    run_command(state, CommandId::undo);
    EXPECT_EQ(state.camera, elsewhere);
    EXPECT_EQ(state.scene().camera, before.camera);
    // And so does who made the view the scene's camera.
    run_command(state, CommandId::use_view_as_camera);
    run_command(state, CommandId::undo);
    EXPECT_EQ(state.camera, elsewhere);
    EXPECT_EQ(state.scene().camera, before.camera);
}

TEST_F(Commands, AViewIsSavedNamedAndFlownTo) {
    state.camera.eye.x = 5.0;
    const Camera first = state.camera;
    run_command(state, CommandId::save_view);
    state.camera.eye.x = 9.0;
    run_command(state, CommandId::save_view);
    EXPECT_EQ(state.scene().views, (std::vector<SavedView>{{"view 1", first}, {"view 2", state.camera}}));
    EXPECT_EQ(state.document.undo_name(), "Save view 'view 2'");
    EXPECT_EQ(state.side_panel.renamed_view.of, 1U);
    EXPECT_TRUE(state.panel_shown);
    EXPECT_EQ(state.scene().camera, before.camera);
    // What is kept already is not kept again, but named.
    state.camera = first;
    run_command(state, CommandId::save_view);
    EXPECT_EQ(state.scene().views.size(), 2U);
    EXPECT_EQ(state.side_panel.renamed_view.of, 0U);
    EXPECT_NE(state.messages.announcement.find("'view 1'"), std::string::npos);
    state.camera.eye.x = 9.0;
    perform(state, {ShowView{first}});
    ASSERT_TRUE(state.flight);
    const Clock::time_point begin = Clock::now();
    fly_on(state, begin);
    fly_on(state, begin + std::chrono::seconds(1));
    EXPECT_EQ(state.camera, first);
    for (int i = 0; i < 2; ++i) run_command(state, CommandId::undo);
    EXPECT_TRUE(state.scene().views.empty());
    EXPECT_FALSE(state.document.is_changed());
    EXPECT_EQ(state.camera, first) << "no camera was changed";
}

TEST_F(Commands, EverySideIsSeen) {
    for (const auto& [id, ahead] : {std::pair{CommandId::view_front, glm::dvec3{0, 0, 1}},
                                    {CommandId::view_back, glm::dvec3{0, 0, -1}},
                                    {CommandId::view_right, glm::dvec3{-1, 0, 0}},
                                    {CommandId::view_left, glm::dvec3{1, 0, 0}},
                                    {CommandId::view_top, glm::dvec3{0, -1, 0}},
                                    {CommandId::view_bottom, glm::dvec3{0, 1, 0}}}) {
        SCOPED_TRACE(std::string(info_of(commands_of(state), id).label));
        run_command(state, id);
        ASSERT_TRUE(state.flight);
        const Clock::time_point begin = Clock::now();
        state.flight->advance(begin);
        const Camera arrived = state.flight->advance(begin + std::chrono::seconds(1));
        EXPECT_LT(glm::distance(camera_axes(arrived).ahead, ahead), 1e-12);
    }
}

TEST_F(Commands, OneChoiceOfAntiAliasingIsMarked) {
    const auto marked = [&] {
        std::vector<CommandId> found;
        for (const CommandInfo& info : commands_of(state)) {
            const bool is_choice =
                info.label.find("nti-aliasing") != std::string_view::npos || info.label.find("samples") != std::string_view::npos;
            if (is_choice && info.checked) found.push_back(info.id);
        }
        return found;
    };
    EXPECT_EQ(marked(), std::vector{CommandId::anti_aliasing_16});
    run_command(state, CommandId::no_anti_aliasing);
    EXPECT_EQ(state.settings.samples, 1);
    EXPECT_EQ(marked(), std::vector{CommandId::no_anti_aliasing});
    run_command(state, CommandId::anti_aliasing_16);
    EXPECT_EQ(state.settings.samples, 16);
    EXPECT_EQ(marked(), std::vector{CommandId::anti_aliasing_16});
    run_command(state, CommandId::anti_aliasing_4);
    EXPECT_EQ(state.settings.samples, 4);
    EXPECT_EQ(marked(), std::vector{CommandId::anti_aliasing_4});
}

TEST_F(Commands, AHiddenOneAmongOthersIsHiddenWithThem) {
    state.selection.set_only(0);
    run_command(state, CommandId::hide);
    EXPECT_TRUE(state.scene().spheres[0].hidden);
    run_command(state, CommandId::select_all);
    run_command(state, CommandId::hide);
    EXPECT_TRUE(state.scene().spheres[0].hidden && state.scene().spheres[1].hidden);
    run_command(state, CommandId::hide);
    EXPECT_FALSE(state.scene().spheres[0].hidden || state.scene().spheres[1].hidden);
}

TEST_F(Commands, AShadingIsChosenAndChecked) {
    const auto shade = [](Shading mode) {
        return static_cast<CommandId>(static_cast<int>(CommandId::first_shading) + static_cast<int>(mode));
    };
    EXPECT_TRUE(is_checked(shade(Shading::studio)));
    run_command(state, shade(Shading::depth));
    EXPECT_EQ(state.settings.shading, Shading::depth);
    EXPECT_TRUE(is_checked(shade(Shading::depth)));
    EXPECT_FALSE(is_checked(shade(Shading::studio)));
    EXPECT_FALSE(is_checked(CommandId::help));
    EXPECT_FALSE(state.document.is_changed());
}

TEST_F(Commands, TextIsScaledWithinWhatSettingsMayBe) {
    state.settings.text_scale = text_scale_range.most;
    run_command(state, CommandId::larger_text);
    EXPECT_EQ(state.settings.text_scale, text_scale_range.most);
    run_command(state, CommandId::smaller_text);
    EXPECT_NEAR(state.settings.text_scale, text_scale_range.most / 1.1, 1e-12);
    for (int i = 0; i < 50; ++i) run_command(state, CommandId::smaller_text);
    EXPECT_EQ(state.settings.text_scale, text_scale_range.least);
}

TEST(Layout, ThePanelIsNeverWiderThanItsSettingMayBe) {
    EXPECT_EQ(panel_width_within(360.0, 1000.0), 360.0);
    EXPECT_EQ(panel_width_within(360.0, 300.0), 300.0);
    EXPECT_EQ(panel_width_within(360.0, 10.0), panel_width_range.least);
    EXPECT_EQ(panel_width_within(1.0, 1000.0), panel_width_range.least);
    EXPECT_EQ(panel_width_within(9000.0, 8000.0), panel_width_range.most) << "or the next start would not believe it";
}

TEST_F(Commands, SelectByWhatSpheresAre) {
    state.selection.set_only(0);
    run_command(state, CommandId::invert_selection);
    EXPECT_EQ(state.selection.numbers(), std::vector<std::uint32_t>{1});
    run_command(state, CommandId::hide);
    state.selection.set_only(0);
    run_command(state, CommandId::select_hidden);
    EXPECT_EQ(state.selection.numbers(), std::vector<std::uint32_t>{1});
    run_command(state, CommandId::duplicate);
    state.selection.set_only(1);
    run_command(state, CommandId::select_same_color);
    EXPECT_EQ(state.selection.numbers(), (std::vector<std::uint32_t>{1, 2}));
    run_command(state, CommandId::select_none);
    EXPECT_FALSE(is_enabled(CommandId::select_same_color));
    run_command(state, CommandId::invert_selection);
    EXPECT_EQ(state.selection.size(), 3U);
}

}  // namespace sphereview
