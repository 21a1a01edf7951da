// When to draw, and how coarsely.
#include "viewer/pacing.hpp"

#include <gtest/gtest.h>

namespace sphereview {

namespace {

// Draws until nothing is to be drawn.
int frames_until_rest(Pacing& pacing, int step) {
    int frames = 0;
    while (!pacing.rests() && frames < 100) {
        const bool refines = pacing.refines();
        pacing.drew(refines ? 1 : step);
        ++frames;
    }
    return frames;
}

}  // namespace

TEST(Pacing, RestsAfterAFewFrames) {
    Pacing pacing;
    EXPECT_LT(frames_until_rest(pacing, 1), 6);
    EXPECT_EQ(pacing.patience(), std::nullopt);
    pacing.touch();
    EXPECT_FALSE(pacing.rests());
    EXPECT_EQ(pacing.patience(), 0.0);
}

TEST(Pacing, AnotherPictureTakesOneFrame) {
    Pacing pacing;
    frames_until_rest(pacing, 1);
    pacing.show_once();
    EXPECT_EQ(frames_until_rest(pacing, 1), 1);
    pacing.touch();
    pacing.show_once();
    EXPECT_GT(frames_until_rest(pacing, 1), 1) << "the panels settle all the same";
}

TEST(Pacing, ACoarsePictureIsRefinedBeforeItRests) {
    Pacing pacing;
    pacing.touch();
    pacing.drew(4);
    EXPECT_FALSE(pacing.refines()) << "while it still moves";
    while (pacing.patience() == 0.0) pacing.drew(4);
    EXPECT_FALSE(pacing.rests());
    EXPECT_TRUE(pacing.refines());
    EXPECT_EQ(pacing.patience(), Pacing::refine_after);
    pacing.drew(1);
    EXPECT_TRUE(pacing.rests());
}

TEST(Pacing, ASlowDeviceMovesCoarsely) {
    Pacing pacing;
    EXPECT_EQ(pacing.moving_step(), 1);
    pacing.traced(1, 0.9 * Pacing::frame_budget, 0.9 * Pacing::frame_budget);
    EXPECT_EQ(pacing.moving_step(), 1);
    pacing.traced(1, 10 * Pacing::frame_budget, 10 * Pacing::frame_budget);
    EXPECT_EQ(pacing.moving_step(), 4);
    pacing.traced(1, 1e6, 1e6);
    EXPECT_EQ(pacing.moving_step(), 8);
    for (int i = 0; i < 100; ++i) pacing.traced(8, 0.001 * Pacing::frame_budget, 0.001 * Pacing::frame_budget);
    EXPECT_EQ(pacing.moving_step(), 1);
}

TEST(Pacing, KnowsThatListsShrinkLittle) {
    constexpr double budget = Pacing::frame_budget;
    Pacing little;
    for (int i = 0; i < 100; ++i) little.traced(8, 0.5 * budget, 0.001 * budget);
    EXPECT_EQ(little.moving_step(), 1) << "coarser would be hardly faster";
    Pacing much;
    much.traced(2, 0.9 * budget, 0.2 * budget);
    EXPECT_EQ(much.moving_step(), 2);
    much.traced(2, 1.7 * budget, 0.2 * budget);
    EXPECT_EQ(much.moving_step(), 8) << "fewer spheres are listed for fewer rays";
}

}  // namespace sphereview
