// Measuring between spheres.
#include "panels/measuring.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "panels/harness.hpp"
#include "panels/math_text.hpp"
#include "support/spheres.hpp"

namespace sphereview {

namespace {

struct MeasuringHarness {
    explicit MeasuringHarness(Rectangle picture = {100.0F, 50.0F, 600.0F, 500.0F}) : area(picture) {
        Scene scene = scene_of_alike(5);
        const std::vector<glm::dvec3> places = {{0, 1, 0}, {0, 0, 0}, {3, 0, 0}, {3, 0, 4}, {9, 9, 9}};
        for (std::size_t i = 0; i < places.size(); ++i) scene.spheres[i].center = places[i];
        scene.names[1] = "sun";
        panels.document = Document(scene);
        panels.redraws(4);
    }

    void measure_all(const std::vector<std::uint32_t>& spheres) {
        for (const std::uint32_t sphere : spheres) measure(measuring, panels.document, sphere);
        panels.redraws(4);
    }
    std::vector<std::string> words(bool left_handed = false) const {
        std::vector<std::string> found;
        for (const Measure& one : measures_of(measuring, panels.document.scene(), left_handed))
            found.push_back(in_words(one, true));
        return found;
    }

    Rectangle area;
    Measuring measuring{.on = true};
    std::vector<ImVec2> places;
    std::vector<Rectangle> marks;
    PanelHarness panels{
        [this](const PanelContext& context) { draw_measuring(context, measuring, area, places, marks); }, {}, 800.0F, 600.0F};
};

using Words = std::vector<std::string>;

TEST(Measures, AreAnglesInDegrees) {
    EXPECT_NEAR(*angle_of({1, 0, 0}, {0, 0, 0}, {0, 7, 0}), 90.0, 1e-12);
    EXPECT_NEAR(*angle_of({1, 1, 1}, {0, 0, 0}, {-1, -1, 1}), 109.47122063449069, 1e-12);
    EXPECT_NEAR(*angle_of({1, 0, 0}, {0, 0, 0}, {1, 1e-9, 0}), 1e-9 * 180.0 / 3.14159265358979, 1e-20) << "near 0, too";
    EXPECT_FALSE(angle_of({1, 0, 0}, {1, 0, 0}, {2, 0, 0}));
}

TEST(Measures, DihedralsAreClockwiseAsTheyAreSeen) {
    // Seen from b to c, along +x; in right-handed coordinates with y up, z is to the right there.
    const glm::dvec3 a{0, 1, 0};
    const glm::dvec3 b{0, 0, 0};
    const glm::dvec3 c{1, 0, 0};
    const auto at = [](double degrees) {
        const double angle = degrees * 3.14159265358979323846 / 180.0;
        return glm::dvec3{1, std::cos(angle), std::sin(angle)};
    };
    for (const double angle : {0.0, 30.0, 90.0, 150.0, -30.0, -120.0}) {
        EXPECT_NEAR(*dihedral_of(a, b, c, at(angle), false), angle, 1e-10);
        EXPECT_NEAR(*dihedral_of(a, b, c, at(angle), true), -angle, 1e-10);
    }
    EXPECT_NEAR(*dihedral_of(a, b, c, {1, -1, 0}, false), 180.0, 1e-10);
    EXPECT_NEAR(*dihedral_of(a, b, c, {1, -1, 0}, true), 180.0, 1e-10);
    EXPECT_FALSE(dihedral_of({-1, 0, 0}, b, c, at(30.0), false)) << "on a line";
}

TEST(Measures, AreShownWithAMinusAndCopiedAsNumbers) {
    const PanelHarness panel([](const PanelContext&) {});
    const Measure angle{"dihedral", -12.5, true};
    EXPECT_EQ(value_text(angle, 4), in_glyphs("\u221212.5") + "\u00B0");
    EXPECT_EQ(in_words(angle, true), "dihedral = -12.5\u00B0");
}

TEST(MeasuringPanel, GivesDistancesThenAnAngleThenADihedral) {
    MeasuringHarness harness;
    EXPECT_EQ(harness.words(), Words());
    harness.measure_all({1});
    EXPECT_EQ(harness.words(), Words());
    harness.measure_all({1, 2});
    EXPECT_EQ(harness.words(), Words{"distance sphere 1 'sun' to sphere 2 = 3"}) << "twice the same is once";
    harness.measure_all({3});
    EXPECT_EQ(harness.words(), (Words{"distance sphere 1 'sun' to sphere 2 = 3", "distance sphere 2 to sphere 3 = 4",
                                      "angle sphere 1 'sun', sphere 2, sphere 3 = 90\xC2\xB0"}));
    EXPECT_NE(harness.panels.text().find("angle sphere 1 'sun', sphere 2, sphere 3"), std::string::npos) << harness.panels.text();
    harness.measure_all({4});
    harness.measure_all({0});
    EXPECT_EQ(harness.measuring.spheres, std::vector<std::uint32_t>{0}) << "a fifth begins anew";
    harness.measure_all({1, 2, 3});
    EXPECT_EQ(harness.words().size(), 6U);
    EXPECT_EQ(harness.words(false).back(), "dihedral sphere 0, sphere 1 'sun', sphere 2, sphere 3 = 90\xC2\xB0");
    EXPECT_EQ(harness.words(true).back(), "dihedral sphere 0, sphere 1 'sun', sphere 2, sphere 3 = -90\xC2\xB0");
}

TEST(MeasuringPanel, FollowsEditsAndForgetsSpheresThatHaveOtherNumbers) {
    MeasuringHarness harness;
    harness.measure_all({1, 2});
    Sphere moved = harness.panels.document.scene().spheres[2];
    moved.center.x = 7.5;
    harness.panels.document.apply(ChangeSpheres{{2}, {moved}}, "Move");
    harness.panels.redraws(2);
    EXPECT_EQ(harness.words(), Words{"distance sphere 1 'sun' to sphere 2 = 7.5"});
    harness.panels.document.apply(RemoveSpheres{{0}}, "Delete");
    harness.panels.redraws(2);
    EXPECT_TRUE(harness.measuring.spheres.empty());
}

TEST(MeasuringPanel, CopiesBeginsAnewAndEnds) {
    MeasuringHarness harness;
    harness.panels.click("measure copy");
    EXPECT_STREQ(ImGui::GetClipboardText(), "") << "nothing is measured";
    harness.measure_all({1, 2});
    harness.panels.click("measure copy");
    EXPECT_STREQ(ImGui::GetClipboardText(), "distance sphere 1 'sun' to sphere 2 = 3\n");
    harness.panels.click("measure again");
    EXPECT_TRUE(harness.measuring.on && harness.measuring.spheres.empty());
    const WidgetRectangle window = harness.panels.rectangles.at("measuring");
    EXPECT_LT(window.right, 600.0F) << "the legend is at the right";
    EXPECT_GE(window.left, 100.0F);
    EXPECT_GE(window.top, 50.0F);
    harness.panels.click("measure end");
    EXPECT_FALSE(harness.measuring.on);
    harness.panels.redraws(2);
    EXPECT_FALSE(harness.panels.has("measuring"));
}

TEST(MeasuringPanel, IsMovedAsideAndStaysWithinThePicture) {
    MeasuringHarness harness;
    const auto window = [&] { return harness.panels.rectangles.at("measuring"); };
    const WidgetRectangle first = window();
    const ImVec2 edge{first.right - 4.0F, first.bottom - 3.0F};
    harness.panels.drag(edge, {edge.x + 100.0F, edge.y + 200.0F});
    EXPECT_NEAR(window().left, first.left + 100.0F, 1.0F);
    EXPECT_NEAR(window().top, first.top + 200.0F, 1.0F);
    harness.area = {100.0F, 50.0F, 380.0F, 300.0F};
    harness.panels.redraws(2);
    EXPECT_LE(window().right, 480.0F);
    EXPECT_LE(window().bottom, 350.0F);
}

TEST(MeasuringPanel, CoversNoSphereThatIsMeasured) {
    MeasuringHarness harness;
    const WidgetRectangle at_first = harness.panels.rectangles.at("measuring");
    harness.places = {{at_first.left + 10.0F, at_first.bottom + 20.0F}, {690.0F, 70.0F}};
    harness.measure_all({0, 1, 2, 3});  // the window grows
    const WidgetRectangle grown = harness.panels.rectangles.at("measuring");
    for (const ImVec2& place : harness.places) {
        EXPECT_FALSE(place.x > grown.left && place.x < grown.right && place.y > grown.top && place.y < grown.bottom);
    }
    // Where the person drags it, it stays.
    const ImVec2 handle{grown.left + 60.0F, grown.top + 10.0F};
    harness.panels.drag(handle, {handle.x, handle.y - 150.0F});
    const float dragged = harness.panels.rectangles.at("measuring").top;
    EXPECT_LT(dragged, grown.top - 100.0F);
    harness.places = {{grown.left + 20.0F, dragged + 20.0F}};
    harness.panels.redraws(4);
    EXPECT_EQ(harness.panels.rectangles.at("measuring").top, dragged);
}

// Axes, scale bar and legend: each could be where the window is at first.
TEST(MeasuringPanel, CoversNothingThatIsDrawnOverThePicture) {
    const Rectangle area{100.0F, 50.0F, 600.0F, 500.0F};
    const float right = area.x + area.width;
    const float bottom = area.y + area.height;
    const std::vector<std::vector<Rectangle>> cases = {
        {{area.x, area.y, 200.0F, 120.0F}},
        {{area.x, bottom - 430.0F, 110.0F, 430.0F}},                                           // high axes at the left
        {{right - 420.0F, area.y, 420.0F, 200.0F}},                                            // a wide legend
        {{right - 420.0F, area.y, 420.0F, 90.0F}, {area.x, bottom - 110.0F, 110.0F, 110.0F}},  // and axes
        {{area.x, area.y, 600.0F, 40.0F}, {right - 300.0F, bottom - 60.0F, 300.0F, 60.0F}},
    };
    for (const std::vector<Rectangle>& marks : cases) {
        MeasuringHarness harness(area);
        harness.measuring = {};
        harness.panels.redraws(2);
        harness.marks = marks;
        harness.measuring.on = true;
        harness.panels.redraws(4);
        const auto covers = [&] {
            const WidgetRectangle window = harness.panels.rectangles.at("measuring");
            return std::ranges::any_of(marks, [&](const Rectangle& mark) {
                return window.left < mark.x + mark.width && window.right > mark.x && window.top < mark.y + mark.height &&
                       window.bottom > mark.y;
            });
        };
        EXPECT_FALSE(covers()) << marks.front().x;
        harness.measure_all({0, 1, 2, 3});  // the window grows
        EXPECT_FALSE(covers()) << marks.front().x;
        // The person may drag it there.
        const WidgetRectangle window = harness.panels.rectangles.at("measuring");
        const ImVec2 handle{window.left + 60.0F, window.top + 8.0F};
        const Rectangle& mark = marks.front();
        harness.panels.drag(handle, {mark.x + 0.5F * mark.width, mark.y + 0.5F * mark.height});
        harness.panels.redraws(4);
        EXPECT_TRUE(covers()) << marks.front().x;
    }
}

TEST(MeasuringPanel, FitsANarrowPicture) {
    MeasuringHarness harness({100.0F, 50.0F, 150.0F, 500.0F});
    harness.measure_all({1, 2, 3});
    const WidgetRectangle window = harness.panels.rectangles.at("measuring");
    for (const char* widget : {"measure copy", "measure again", "measure end"}) {
        EXPECT_LT(harness.panels.rectangles.at(widget).right, window.right) << widget;
    }
    EXPECT_LT(window.right, 260.0F) << "the legend is at the right";
    EXPECT_GE(window.left, 100.0F);
}

}  // namespace

}  // namespace sphereview
