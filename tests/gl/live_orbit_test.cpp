// The picture of the window while the camera moves about many spheres.
#include <gtest/gtest.h>

#include "camera/navigation.hpp"
#include "gl/live_export.hpp"
#include "tiles/pixel_grid.hpp"

namespace sphereview::test {
namespace {

using LiveOrbit = LiveAndExported;

// So many that a coarse grid has lists of its own.
TEST_P(LiveOrbit, MovesAboutManySpheres) {
    Scene scene = colorful_scene(33'000);
    for (Sphere& sphere : scene.spheres) sphere.radius *= 0.2;
    const Document document(scene);
    LivePicture picture;
    View view{scene.camera, {203, 101}};
    for (int turn = 0; turn < 4; ++turn) {
        view.camera = orbited(view.camera, {0.0, 0.0, 250.0}, 0.2, 0.05);
        const Image expected = colored(scene, view, numbers(scene, view));
        const DrawnSpheres drawn = drawn_spheres(scene, view.camera);
        for (const int step : {8, 2, 1}) {
            const PixelGrid grid{view.size, step};
            const Image image = shown(picture, document, view, step);
            for (int y = 0; y < view.size.height; ++y) {
                for (int x = 0; x < view.size.width; ++x) {
                    const Pixel traced{grid.traced_column(x / step), grid.traced_row(y / step)};
                    if (at(image, x, y) == at(expected, traced.x, traced.y)) continue;
                    // Of a doubtful pixel a window shows a guess, which may be another with other lists.
                    ASSERT_NE(decision_level(scene, drawn, view.camera, view.size, traced), DecisionLevel::in_float)
                        << turn << ", step " << step << ": " << x << "," << y;
                }
            }
            if (turn % 2 == 0 && step == 2) break;  // on to the next view, not refined
        }
    }
    EXPECT_EQ(picture.step(), 1);
    EXPECT_FALSE(picture.update(document, view, 8));  // it has better
    const DrawnSpheres drawn = drawn_spheres(scene, view.camera);
    const Resolver resolver(scene, drawn, view.camera, view.size, nullptr);
    DecisionLevel level{};
    for (int y = 0; y < view.size.height; ++y)
        EXPECT_EQ(picture.pick(document, {2 * y, y}), resolver.resolve({2 * y, y}, level)) << y;
}

TEST_P(LiveOrbit, FollowsColoursAndPicksWhileItMoves) {
    Scene scene = colorful_scene(33'000);
    Document document(scene);
    LivePicture picture;
    View view{scene.camera, {120, 90}};
    shown(picture, document, view, 8);
    Selection all;
    all.set({0, 1, 3});
    for (int turn = 0; turn < 3; ++turn) {
        view.camera = orbited(view.camera, {0.0, 0.0, 250.0}, 0.1, 0.0);
        Sphere sphere = document.scene().spheres[0];
        sphere.color = {static_cast<std::uint8_t>(turn), 200, 7};
        document.apply(change(0, sphere), "colour");
        LivePicture anew;
        EXPECT_TRUE(same(shown(picture, document, view, 8, {&all, {}, 2.0F}), shown(anew, document, view, 8, {&all, {}, 2.0F})));
        const DrawnSpheres drawn = drawn_spheres(document.scene(), view.camera);
        const Resolver resolver(document.scene(), drawn, view.camera, view.size, nullptr);
        DecisionLevel level{};
        for (int i = 0; i < 90; ++i) EXPECT_EQ(picture.pick(document, {i, i}), resolver.resolve({i, i}, level)) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Contexts, LiveOrbit, testing::ValuesIn(context_kinds()), [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace sphereview::test
