// The part of the side panel that colours and sizes spheres by a property: its edits, its range, and what the legend is told.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "look/sizes.hpp"
#include "panels/harness.hpp"

namespace sphereview {

namespace {

struct OpenLookPanel : OpenPartHarness {
    OpenLookPanel() : OpenPartHarness("look", &add_properties, 1000.0F) {}

    static void add_properties(Scene& scene) {
        scene.properties.push_back({"charge", std::vector<double>{-1.0, 0.0, 3.0}});
        scene.properties.push_back({"chain", Labels{{"B", "A"}, {0, 1, 0}}});
    }

    void choose(const std::string& field, const std::string& entry) {
        click(field);
        redraws(3);
        click(field + " " + entry);
        redraws(3);
    }
    std::vector<Color> colors() const {
        std::vector<Color> found;
        for (const Sphere& one : document.scene().spheres) found.push_back(one.color);
        return found;
    }
    static std::vector<Color> expected(ColorMap map, const std::vector<double>& parts) {
        std::vector<Color> found;
        for (const double part : parts) found.push_back(color_of(map, part));
        return found;
    }
    LookPanelState& look() { return state().look; }
    std::string legend() {
        const Coloring* shown = shown_coloring(document, look());
        return shown == nullptr ? "" : in_words(*shown);
    }
};

}  // namespace

TEST(LookPanel, ColorsByNumbersInOneStep) {
    OpenLookPanel panel;
    const std::vector<Color> before = panel.colors();
    EXPECT_EQ(panel.legend(), "");
    panel.choose("colour by", "charge");
    EXPECT_EQ(panel.colors(), panel.expected(ColorMap::viridis, {0.0, 0.25, 1.0}));
    EXPECT_EQ(panel.document.undo_name(), "Colour by 'charge'");
    EXPECT_EQ(panel.legend(), "colours by charge: viridis from -1 to 3");
    panel.choose("map", "turbo");
    EXPECT_EQ(panel.colors(), panel.expected(ColorMap::turbo, {0.0, 0.25, 1.0}));
    EXPECT_EQ(panel.legend(), "colours by charge: turbo from -1 to 3");
    // The legend and the panel follow what is undone.
    panel.undo();
    EXPECT_EQ(panel.legend(), "colours by charge: viridis from -1 to 3");
    EXPECT_NE(panel.look().colors.map, ColorMap::turbo);
    panel.document.redo();
    panel.redraws(2);
    EXPECT_EQ(panel.legend(), "colours by charge: turbo from -1 to 3");
    EXPECT_EQ(panel.look().colors.map, ColorMap::turbo);
    panel.undo();
    panel.undo();
    EXPECT_EQ(panel.colors(), before);
    EXPECT_EQ(panel.legend(), "");
}

TEST(LookPanel, ADragOfTheRangeIsOneStep) {
    OpenLookPanel panel;
    panel.choose("colour by", "charge");
    panel.take_actions();
    panel.drag(panel.place("histogram", 0.99F), panel.place("histogram", 0.5F));
    EXPECT_GE(panel.edits_of_one_gesture().size(), 2U);
    ASSERT_TRUE(panel.look().colors.range);
    const ValueRange range = *panel.look().colors.range;
    EXPECT_EQ(range.low, -1.0);
    EXPECT_NEAR(range.high, 1.0, 0.1);
    EXPECT_EQ(panel.colors(), panel.expected(ColorMap::viridis, {0.0, part_of(0.0, range, false), 1.0}));
    panel.undo();
    EXPECT_EQ(panel.colors(), panel.expected(ColorMap::viridis, {0.0, 0.25, 1.0}));
    EXPECT_EQ(panel.legend(), "colours by charge: viridis from -1 to 3");
    EXPECT_FALSE(panel.look().colors.range);
    panel.undo();
    EXPECT_FALSE(panel.document.can_undo());
}

TEST(LookPanel, TheRangeIsTypedOrOfTheDataOrOfWhatIsSeen) {
    OpenLookPanel panel;
    panel.choose("colour by", "charge");
    panel.enter("to", "9");
    EXPECT_EQ(panel.look().colors.range, (ValueRange{-1.0, 9.0}));
    EXPECT_EQ(panel.colors(), panel.expected(ColorMap::viridis, {0.0, 0.1, 0.4}));
    panel.click("range of data");
    EXPECT_EQ(panel.colors(), panel.expected(ColorMap::viridis, {0.0, 0.25, 1.0}));
    panel.click("range of seen");
    ASSERT_TRUE(panel.look().asks_for_seen);
    panel.look().seen = {0, 1};
    panel.redraws(2);
    EXPECT_EQ(panel.look().colors.range, (ValueRange{-1.0, 0.0}));
    EXPECT_EQ(panel.colors(), panel.expected(ColorMap::viridis, {0.0, 1.0, 1.0}));
    panel.click("logarithm");
    EXPECT_EQ(panel.legend(), "colours by charge: viridis from 3 to 3, by the logarithm");
}

TEST(LookPanel, ColorsByWords) {
    OpenLookPanel panel;
    panel.choose("colour by", "chain");
    EXPECT_EQ(panel.colors(), (std::vector<Color>{category_color(1), category_color(0), category_color(1)}));
    EXPECT_FALSE(panel.has("map"));
    ASSERT_NE(shown_coloring(panel.document, panel.look()), nullptr);
    EXPECT_EQ(panel.look().shown->categories[1], (Category{"B", category_color(1), 2}));
    // Hidden spheres are not counted.
    Sphere hidden = panel.sphere(2);
    hidden.hidden = true;
    panel.document.apply(ChangeSpheres{{2}, {hidden}}, "Hide");
    shown_coloring(panel.document, panel.look());
    EXPECT_EQ(panel.look().shown->categories[1].count, 1U);
    // Other colours of most of them are another scene's.
    std::vector<Sphere> others = panel.document.scene().spheres;
    for (Sphere& one : others) one.color = {1, 2, 3};
    panel.document.apply(ChangeSpheres{{0, 1, 2}, others}, "Paint");
    EXPECT_EQ(panel.legend(), "");
}

// Of a large scene the file's properties are read when somebody asks for one.
TEST(LookPanel, WaitsForWhatIsNotReadYet) {
    OpenLookPanel panel;
    panel.property_names = {"charge", "mass", "chain"};
    panel.redraws(2);
    panel.click("colour by");
    panel.redraws(3);
    panel.take_actions();
    panel.click("colour by mass");
    panel.redraws(2);
    EXPECT_FALSE(panel.taken<RequestProperties>().empty());
    EXPECT_FALSE(panel.document.can_undo());
    panel.document.add_properties({{"mass", std::vector<float>{2.0F, 1.0F, 1.5F}}});
    panel.redraws(3);
    EXPECT_EQ(panel.colors(), panel.expected(ColorMap::viridis, {1.0, 0.0, 0.5}));
    panel.take_actions();
    panel.redraws(2);
    EXPECT_TRUE(panel.take_actions().empty());
    // What cannot be read is asked for no more.
    panel.property_names = {"charge", "mass", "chain", "lost"};
    panel.redraws(2);
    panel.choose("colour by", "lost");
    panel.property_names.pop_back();
    panel.redraws(2);
    panel.take_actions();
    panel.redraws(2);
    EXPECT_TRUE(panel.take_actions().empty());
    EXPECT_FALSE(panel.look().recolors);
}

TEST(LookPanel, SizesByNumbers) {
    OpenLookPanel panel;
    const std::vector<Sphere> before = panel.document.scene().spheres;
    panel.click("size by");
    panel.redraws(3);
    EXPECT_FALSE(panel.has("size by chain"));
    panel.click("size by charge");
    panel.redraws(3);
    EXPECT_EQ(panel.document.undo_name(), "Size by 'charge'");
    EXPECT_EQ(panel.sphere(2).radius, 3.0 * panel.look().scale);
    EXPECT_EQ(panel.sphere(0).radius, 0.02 * panel.sphere(2).radius);
    panel.enter("scale", "2");
    EXPECT_EQ(panel.sphere(2).radius, 6.0);
    panel.undo();
    panel.undo();
    EXPECT_EQ(panel.document.scene().spheres, before);
}

TEST(LookPanel, GivesTheirOwnColoursAndSizesBack) {
    OpenLookPanel panel;
    const std::vector<Sphere> before = panel.document.scene().spheres;
    panel.choose("colour by", "charge");
    panel.choose("map", "turbo");
    panel.choose("size by", "charge");
    panel.choose("colour by", "own");
    panel.choose("size by", "own");
    EXPECT_EQ(panel.document.scene().spheres, before);
    EXPECT_EQ(panel.document.undo_name(), "Own sizes");
    EXPECT_EQ(panel.look().colors.property, "");
    EXPECT_EQ(panel.legend(), "");
    panel.undo();
    panel.undo();
    EXPECT_EQ(panel.legend(), "colours by charge: turbo from -1 to 3");
    // Of other spheres nobody knows them.
    panel.document.apply(RemoveSpheres{{0}}, "Delete");
    panel.redraws(2);
    panel.take_actions();
    panel.choose("colour by", "own");
    EXPECT_TRUE(panel.taken<EditScene>().empty());
}

TEST(LookPanel, GivesAtomsTheRadiiOfTheirElements) {
    OpenLookPanel none;
    none.click("size by");
    none.redraws(3);
    EXPECT_FALSE(none.has("size by covalent radii")) << "no elements";
}

TEST(LookPanel, GivesAtomsTheRadiiOfTheirElementsOnceTheyAreRead) {
    OpenLookPanel panel;
    panel.property_names = {"charge", "chain", "element"};
    panel.redraws(2);
    const std::vector<Sphere> before = panel.document.scene().spheres;
    panel.choose("size by", "van der Waals radii");
    EXPECT_FALSE(panel.taken<RequestProperties>().empty());
    panel.document.add_properties({{"element", Labels{{"C", "H"}, {0, 1, 0}}}});
    panel.redraws(3);
    EXPECT_EQ(panel.document.undo_name(), "Use van der Waals radii");
    EXPECT_EQ(panel.sphere(0).radius, radius_of_element("C", RadiiKind::vdw));
    panel.choose("size by", "covalent radii");
    EXPECT_EQ(panel.sphere(1).radius, radius_of_element("H", RadiiKind::covalent));
    EXPECT_EQ(chosen_radii(panel.look()), RadiiKind::covalent);
    panel.choose("size by", "own");
    EXPECT_EQ(panel.document.scene().spheres, before);
    EXPECT_FALSE(panel.has("slider scale"));
}

TEST(LookPanel, TheRangesHandlesAreAsLargeAsItsWords) {
    OpenLookPanel panel;
    panel.choose("colour by", "charge");
    ImGui::GetIO().FontGlobalScale = 2.0F;
    panel.redraws(3);
    const WidgetRectangle histogram = panel.rectangles.at("histogram");
    for (const char* name : {"handle from", "handle to"}) {
        const WidgetRectangle handle = panel.rectangles.at(name);
        EXPECT_GE(handle.right - handle.left, 0.9F * ImGui::GetFontSize()) << name;
        EXPECT_GE(handle.left, histogram.left) << name;
        EXPECT_LE(handle.right, histogram.right + 0.5F) << name;
        EXPECT_LE(handle.bottom, histogram.bottom) << name;
    }
    const ImVec2 begin = panel.place("handle from");
    panel.move(begin);
    panel.press();
    panel.move({begin.x + 60.0F, begin.y});
    panel.redraws(2);
    const auto lowest = [] {
        float bottom = 0.0F;
        for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
            if (window->Active && (window->Flags & ImGuiWindowFlags_Tooltip) != 0) bottom = window->Pos.y + window->Size.y;
        }
        return bottom;
    };
    EXPECT_GT(lowest(), 0.0F) << "a tooltip tells the value";
    EXPECT_LE(lowest(), histogram.top + 1.0F) << "and covers neither the handles nor the fields";
    panel.release();
    panel.redraws(2);
    panel.drag(panel.place("handle from", 0.2F), {histogram.left + 100.0F, histogram.bottom - 2.0F});
    ASSERT_TRUE(panel.look().colors.range);
    EXPECT_GT(panel.look().colors.range->low, -1.0);
}

}  // namespace sphereview
