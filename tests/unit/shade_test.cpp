#include "shade/shade.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace sphereview {

namespace {

using Bytes = std::vector<int>;

Scene red_and_blue() {
    Scene scene;
    scene.spheres.resize(2);
    scene.spheres[0].color = {255, 1, 2};
    scene.spheres[1].color = {3, 4, 254};
    return scene;
}

Bytes shaded(const Scene& scene, const Background& background, std::vector<std::int32_t> visible) {
    Image picture = make_picture({static_cast<int>(visible.size()), 1}, background);
    shade_flat(scene, background, {0, 0, picture.width(), 1}, visible, picture);
    return {picture.bytes().begin(), picture.bytes().end()};
}

}  // namespace

TEST(ShadeFlat, GivesEveryColourByteForByte) {
    EXPECT_EQ(shaded(red_and_blue(), {}, {0, visible_background, 1}), (Bytes{255, 1, 2, 0, 0, 0, 3, 4, 254}));
    EXPECT_EQ(shaded(red_and_blue(), {{9, 8, 7}, false}, {visible_background, 0}), (Bytes{9, 8, 7, 255, 1, 2}));
}

TEST(ShadeFlat, TakesTheBackgroundItIsGivenNotTheScenes) {
    Scene scene = red_and_blue();
    scene.background = {{50, 50, 50}, false};
    EXPECT_EQ(shaded(scene, {{1, 1, 1}, false}, {visible_background}), (Bytes{1, 1, 1}));
}

TEST(ShadeFlat, MakesATransparentBackgroundClearAndSpheresOpaque) {
    EXPECT_EQ(shaded(red_and_blue(), {{0, 0, 0}, true}, {1, visible_background}), (Bytes{3, 4, 254, 255, 0, 0, 0, 0}));
}

TEST(ShadeFlat, WritesNothingOutsideItsBlock) {
    Image picture(4, 3, 3);
    std::ranges::fill(picture.bytes(), std::uint8_t{77});
    const std::vector<std::int32_t> visible = {0, 1};
    shade_flat(red_and_blue(), {}, {2, 1, 1, 2}, visible, picture);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
            const int red = x == 2 && y == 1 ? 255 : x == 2 && y == 2 ? 3 : 77;
            EXPECT_EQ(picture.at(x, y)[0], red) << x << "," << y;
        }
    }
}

TEST(ShadeFlat, PutsABlockIntoAPartOfThePicture) {
    Image part(2, 2, 3);
    std::ranges::fill(part.bytes(), std::uint8_t{77});
    shade_flat(red_and_blue(), {}, {11, 20, 1, 2}, std::vector<std::int32_t>{0, 1}, part, {10, 20});
    EXPECT_EQ((Bytes{part.bytes().begin(), part.bytes().end()}), (Bytes{77, 77, 77, 255, 1, 2, 77, 77, 77, 3, 4, 254}));
}

}  // namespace sphereview
