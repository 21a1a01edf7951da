// The list of the scene's saved views.
#include <gtest/gtest.h>

#include "panels/harness.hpp"

namespace sphereview {

namespace {

Camera camera_at(double x) {
    Camera camera;
    camera.eye.x = x;
    return camera;
}

struct OpenSavedViews : SidePanelHarness {
    OpenSavedViews() : SidePanelHarness(scene_with_views(), 1100.0F) {
        click("camera");
        redraws(2);
        take_actions();
    }

    static Scene scene_with_views() {
        Scene scene = line_of_spheres(3);
        scene.views = {{"above", camera_at(1.0)}, {"below", camera_at(2.0)}};
        return scene;
    }
    const std::vector<SavedView>& views() const { return document.scene().views; }
    void rename(std::size_t view, const std::string& name, ImGuiKey key = ImGuiKey_Enter) {
        double_click("view " + std::to_string(view));
        redraws(4);
        ASSERT_TRUE(has("view name"));
        type(name);
        tap(key);
        redraws(2);
    }
};

}  // namespace

TEST(SavedViewsPanel, AClickFliesThere) {
    OpenSavedViews panel;
    panel.click("view 1");
    const auto shown = panel.taken<ShowView>();
    ASSERT_EQ(shown.size(), 1U);
    EXPECT_EQ(shown[0].camera, camera_at(2.0));
    panel.click("save view");
    EXPECT_EQ(panel.commands_taken(), std::vector{CommandId::save_view});
}

TEST(SavedViewsPanel, ViewsAreRenamedAndDeleted) {
    OpenSavedViews panel;
    panel.rename(0, "over \"it\"");
    EXPECT_EQ(panel.views()[0], (SavedView{"over \"it\"", camera_at(1.0)}));
    EXPECT_EQ(panel.document.undo_name(), "Rename view 'above'");
    panel.rename(0, "x", ImGuiKey_Escape);
    EXPECT_EQ(panel.views()[0].name, "over \"it\"");
    panel.click("view 0 delete");
    EXPECT_EQ(panel.views(), (std::vector<SavedView>{{"below", camera_at(2.0)}}));
    panel.undo();
    panel.undo();
    EXPECT_EQ(panel.document.scene(), OpenSavedViews::scene_with_views());
    EXPECT_FALSE(panel.document.can_undo());
}

TEST(SavedViewsPanel, ANameThatNoViewCanHaveIsRefused) {
    OpenSavedViews panel;
    for (const auto& [name, why] : {std::pair{"top", "'top' is the name of a side."},
                                    {"below", "'below' is the name of another view."},
                                    {" ", "' ' is no name."},
                                    {"1,2", "'1,2' is an azimuth and an elevation."}}) {
        panel.rename(0, name);
        EXPECT_EQ(panel.document.scene(), OpenSavedViews::scene_with_views());
        panel.move({1000.0F, 900.0F});  // no tooltip, which would end the text
        EXPECT_NE(panel.text().find(why), std::string::npos) << panel.text();
        EXPECT_TRUE(panel.has("view name") && ImGui::GetIO().WantTextInput) << "the keys are still meant for the name";
        panel.tap(ImGuiKey_Escape);
        panel.redraws(2);
        EXPECT_FALSE(panel.has("view name") || panel.has("view fault"));
    }
    panel.rename(0, "fine");
    EXPECT_FALSE(panel.has("view fault"));
}

TEST(SavedViewsPanel, TheMenuSetsAViewToWhatIsSeen) {
    OpenSavedViews panel;
    panel.moved_view = camera_at(7.0);
    panel.redraws(2);
    panel.click("view 0", 1);
    panel.redraws(3);
    panel.click("view 0 Set to what is seen now");
    EXPECT_EQ(panel.views()[0], (SavedView{"above", camera_at(7.0)}));
    panel.click("view 1", 1);
    panel.redraws(3);
    panel.click("view 1 Delete");
    EXPECT_EQ(panel.views().size(), 1U);
}

TEST(SavedViewsPanel, NewOnesGetTheNextFreeName) {
    Scene scene = line_of_spheres(1);
    for (const std::string name : {"view 1", "view 2", "view 3"}) {
        const EditScene step = saved_view_of(scene, camera_at(1.0));
        EXPECT_EQ(step.name, "Save view '" + name + "'");
        scene.views = std::get<ChangeViews>(step.edit).views;
        EXPECT_EQ(scene.views.back().name, name);
    }
    scene.views.erase(scene.views.begin());
    EXPECT_EQ(std::get<ChangeViews>(saved_view_of(scene, {}).edit).views.back().name, "view 1");
}

// Whoever saves a view by its key types the name at once, also where this part of the panel is closed.
TEST(SavedViewsPanel, ANewViewIsNamedAtOnce) {
    SidePanelHarness panel(OpenSavedViews::scene_with_views(), 1100.0F);
    EXPECT_FALSE(panel.has("view 0"));
    start_renaming_view(panel.state(), panel.document.scene(), 1);
    panel.redraws(4);
    ASSERT_TRUE(panel.has("view name"));
    panel.type("underneath");
    panel.tap(ImGuiKey_Enter);
    EXPECT_EQ(panel.document.scene().views[1].name, "underneath");
}

}  // namespace sphereview
