// What a box in the picture selects, without a window.
#include "viewer/box_selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/decide_exactly.hpp"
#include "support/eventually.hpp"
#include "unit/random_scene.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview::test {

namespace {

// Thousands of spheres that only exact arithmetic tells apart, the nearest of which is the largest.
Scene hard_scene(int count) {
    Scene scene;
    double radius = 130.0;
    for (int i = 0; i < count; ++i, radius = std::nextafter(radius, 200.0)) scene.spheres.push_back({{0, 0, 200}, radius});
    return scene;
}

// Every pixel of it is exact work.
void open_hard_scene(ViewerState& state) {
    state.document = Document(hard_scene(3000));
    state.camera = state.scene().camera;
    state.picture_size = {1000, 1000};
}

// Whether the selection that is under way comes to its end.
bool ends(ViewerState& state) {
    return eventually([&] {
        finish_work(state);
        return !state.selecting;
    });
}

}  // namespace

TEST(SpheresSeen, AreThoseThatPixelsOfTheBlockShow) {
    const Scene scene = hard_scene(50);
    const PictureSize size{40, 30};
    std::vector<Contender> contenders;
    for (const Sphere& sphere : scene.spheres) contenders.push_back({static_cast<std::int32_t>(contenders.size()), &sphere});
    for (const Block block : {Block{0, 0, 40, 30}, {20, 15, 1, 1}, {0, 0, 1, 1}, {3, 4, 30, 2}}) {
        std::vector<std::uint32_t> expected;
        for (int y = block.y; y < block.y + block.height; ++y) {
            for (int x = block.x; x < block.x + block.width; ++x) {
                const std::int32_t number = decide_exactly(scene.camera, size, {x, y}, contenders);
                if (number >= 0) expected.push_back(static_cast<std::uint32_t>(number));
            }
        }
        std::ranges::sort(expected);
        expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
        EXPECT_EQ(spheres_seen(scene, scene.camera, size, block), expected) << block.x << " " << block.y;
    }
}

TEST(BoxSelection, DoesNotWaitForExactWork) {
    ViewerState state{ViewOptions{}, ViewerSettings{}};
    open_hard_scene(state);
    select_seen(state, {0, 0, 1000, 1000}, false);
    ASSERT_TRUE(state.selecting) << "a million pixels of exact work were waited for";
    EXPECT_TRUE(state.selection.empty());
    // Another box takes its place: of a few pixels, so that it ends soon.
    select_seen(state, {500, 500, 2, 2}, true);
    EXPECT_TRUE(ends(state));
    EXPECT_EQ(state.selection.numbers(), std::vector<std::uint32_t>{2999});
}

TEST(BoxSelection, GivesWayToWhatIsSelectedMeanwhile) {
    ViewerState state{ViewOptions{}, ViewerSettings{}};
    open_hard_scene(state);
    select_seen(state, {450, 450, 64, 64}, false);
    ASSERT_TRUE(state.selecting);
    state.selection.set_only(7);
    EXPECT_TRUE(ends(state));
    EXPECT_EQ(state.selection.numbers(), std::vector<std::uint32_t>{7});
}

TEST(BoxSelection, IsDroppedWhenItsNumbersMeanOtherSpheres) {
    ViewerState state{ViewOptions{}, ViewerSettings{}};
    open_hard_scene(state);
    select_seen(state, {450, 450, 64, 64}, false);
    ASSERT_TRUE(state.selecting);
    state.document.apply(RemoveSpheres{{0}}, "Delete sphere");
    EXPECT_TRUE(ends(state));
    EXPECT_TRUE(state.selection.empty());
}

}  // namespace sphereview::test
