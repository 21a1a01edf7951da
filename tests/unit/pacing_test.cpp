// When to draw, and how coarsely.
#include "viewer/pacing.hpp"

#include <gtest/gtest.h>

#include <map>
#include <utility>

namespace sphereview {

namespace {

// Draws until nothing is to be drawn.
int redraws_until_rest(Pacing& pacing, int step) {
    int redraws = 0;
    while (!pacing.rests() && redraws < 100) {
        const bool refines = pacing.refines();
        pacing.drew(refines ? 1 : step);
        ++redraws;
    }
    return redraws;
}

}  // namespace

TEST(Pacing, RestsAfterAFewFrames) {
    Pacing pacing;
    EXPECT_LT(redraws_until_rest(pacing, 1), 6);
    EXPECT_EQ(pacing.patience(), std::nullopt);
    pacing.touch();
    EXPECT_FALSE(pacing.rests());
    EXPECT_EQ(pacing.patience(), 0.0);
}

// A scroll bar that comes or goes changes what is beside it in the redraws that follow.
TEST(Pacing, GoesOnWhilePanelsChangeButNotForEver) {
    Pacing pacing;
    const int settled = redraws_until_rest(pacing, 1);
    pacing.touch();
    for (int i = 0; i < settled + 2; ++i) {
        EXPECT_FALSE(pacing.rests()) << i;
        pacing.drew(1, true);
    }
    pacing.drew(1, false);
    EXPECT_TRUE(pacing.rests());
    pacing.touch();
    int redraws = 0;
    for (; !pacing.rests() && redraws < 100; ++redraws) pacing.drew(1, true);
    EXPECT_LT(redraws, 20);
    pacing.show_once();
    pacing.drew(1, true);
    EXPECT_TRUE(pacing.rests()) << "nothing happened: what changed is what is shown";
}

TEST(Pacing, AnotherPictureTakesOneFrame) {
    Pacing pacing;
    redraws_until_rest(pacing, 1);
    pacing.show_once();
    EXPECT_EQ(redraws_until_rest(pacing, 1), 1);
    pacing.touch();
    pacing.show_once();
    EXPECT_GT(redraws_until_rest(pacing, 1), 1) << "the panels settle all the same";
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

TEST(Pacing, LooksForEventsBetweenThePartsOfAFinePicture) {
    Pacing pacing;
    while (pacing.patience() == 0.0) pacing.drew(32);
    EXPECT_EQ(pacing.patience(), Pacing::refine_after);
    for (int i = 0; i < 5; ++i) {
        pacing.refined_a_part();
        EXPECT_TRUE(pacing.refines());
        EXPECT_EQ(pacing.patience(), 0.0);
    }
    // An event is answered first.
    pacing.touch();
    EXPECT_FALSE(pacing.refines());
    while (pacing.patience() == 0.0) pacing.drew(32);
    EXPECT_EQ(pacing.patience(), Pacing::refine_after);
    pacing.drew(1);
    EXPECT_TRUE(pacing.rests());
}

namespace {

// A device and a scene: a picture takes `fixed` seconds, `lists` besides, and `pixels` for drawing all pixels.
struct Load {
    double lists = 0.0;
    double fixed = 0.0;
    double pixels = 0.0;
};

// Moves for so many redraws; returns how many had each step.
std::map<int, int> steps_of(Pacing& pacing, const Load& load, int redraws) {
    std::map<int, int> steps;
    for (int i = 0; i < redraws; ++i) {
        const int step = pacing.moving_step();
        ++steps[step];
        const double drawing = load.fixed + load.pixels / (step * step);
        pacing.traced(step, load.lists + drawing, drawing);
    }
    return steps;
}

constexpr double budget = Pacing::redraw_budget;

}  // namespace

TEST(Pacing, IsAsFineAsTheTimeAllows) {
    for (const auto& [pixels, step] : {std::pair{0.9, 1}, {1.5, 2}, {3.0, 2}, {10.0, 4}, {50.0, 8}, {1e6, 8}}) {
        Pacing pacing;
        EXPECT_EQ(pacing.moving_step(), 1);
        steps_of(pacing, {.pixels = pixels * budget}, 20);
        EXPECT_GE(steps_of(pacing, {.pixels = pixels * budget}, 200)[step], 190) << pixels;
    }
}

// Of a coarse drawing most is what does not shrink with its pixels: 10,000 spheres were shown at 1/8 with 6.8 ms a redraw.
TEST(Pacing, IsNotCoarseForCostsThatStay) {
    const Load load{.lists = 0.003, .fixed = 0.0035, .pixels = 0.031};
    Pacing pacing;
    steps_of(pacing, load, 20);
    EXPECT_GE(steps_of(pacing, load, 200)[2], 190);
    // Nor once something else has made it coarse.
    steps_of(pacing, {.pixels = 500.0 * budget}, 40);
    EXPECT_EQ(pacing.moving_step(), 8);
    steps_of(pacing, load, 20);
    EXPECT_GE(steps_of(pacing, load, 200)[2], 190);
}

TEST(Pacing, IsNotCoarseWhereThatSavesNoTime) {
    Pacing pacing;
    const Load load{.lists = 4.0 * budget, .pixels = 0.1 * budget};
    steps_of(pacing, load, 5);
    EXPECT_GE(steps_of(pacing, load, 100)[1], 90);
}

// A million spheres: a fine picture takes as long as many coarse ones. It is not tried again while a coarse one fits so.
TEST(Pacing, TriesNothingThatTakesMuchTooLong) {
    Pacing pacing;
    const Load load{.lists = 0.2 * budget, .pixels = 10.0 * budget};
    steps_of(pacing, load, 20);
    std::map<int, int> steps = steps_of(pacing, load, 1000);
    EXPECT_EQ(steps[1], 0);
    EXPECT_LT(steps[2], 10);
    EXPECT_GT(steps[4], 990);
}

TEST(Pacing, OneSlowFrameIsSoonForgotten) {
    Pacing pacing;
    const Load load{.pixels = 0.4 * budget};
    steps_of(pacing, load, 20);
    pacing.traced(1, 20.0 * budget, 20.0 * budget);
    EXPECT_GE(steps_of(pacing, load, 20)[1], 16);
    // Many are.
    EXPECT_LE(steps_of(pacing, {.pixels = 20.0 * budget}, 20)[1], 5);
}

// Pictures of thousands of spheres that overlap everywhere are traced coarser than was asked for.
TEST(Pacing, StaysAsCoarseAsThePictureHadToBe) {
    Pacing pacing;
    pacing.traced(32, budget, 0.9 * budget);
    EXPECT_EQ(pacing.moving_step(), 32);
    // A finer one is tried, ever less often.
    int tries = 0;
    for (int i = 0; i < 1000; ++i) {
        tries += pacing.moving_step() < 32 ? 1 : 0;
        pacing.traced(32, 0.9 * budget, 0.5 * budget);
    }
    EXPECT_GT(tries, 0);
    EXPECT_LT(tries, 10);
    EXPECT_EQ(steps_of(pacing, {.pixels = 0.5 * budget}, 50)[1], 45);
}

TEST(Pacing, FollowsAViewThatBecomesFasterToDraw) {
    Pacing pacing;
    steps_of(pacing, {.pixels = 40.0 * budget}, 50);
    EXPECT_EQ(pacing.moving_step(), 8);
    steps_of(pacing, {.pixels = 0.5 * budget}, 5);
    EXPECT_EQ(steps_of(pacing, {.pixels = 0.5 * budget}, 50)[1], 50);
}

// What else a redraw does is no trace, and takes its time from it.
TEST(Pacing, AFilmLeavesTimeForItsRedraws) {
    Pacing pacing;
    pacing.traced(1, 0.020, 0.018);
    EXPECT_EQ(pacing.moving_step(), 1) << "of a view that moves";
    pacing.play(0.002, true);
    EXPECT_EQ(pacing.budget(), Pacing::redraw_budget) << "there is time enough";
    pacing.end_play();
    pacing.play(0.025, true);
    EXPECT_LT(pacing.budget() + 0.025, 1.0 / Pacing::film_rate);
    pacing.traced(1, 0.020, 0.018);
    EXPECT_EQ(pacing.moving_step(), 2);
    for (int i = 0; i < 100; ++i) pacing.play(1.0, true);
    EXPECT_GT(pacing.budget(), 0.0) << "however slow the rest is";
    pacing.end_play();
    EXPECT_EQ(pacing.budget(), Pacing::redraw_budget);
}

// Between the frames of a film nothing is drawn twice; of a slow one the panels do not wait for the next.
TEST(Pacing, AFilmsRedrawsSettleThePanels) {
    Pacing pacing;
    redraws_until_rest(pacing, 1);
    pacing.play(0.01, true);
    pacing.touch();
    EXPECT_EQ(redraws_until_rest(pacing, 1), 1);
    pacing.play(0.01, false);
    pacing.touch();
    EXPECT_GT(redraws_until_rest(pacing, 1), 1);
    pacing.play(0.01, true);
    pacing.end_play();
    pacing.touch();
    EXPECT_GT(redraws_until_rest(pacing, 1), 1);
}

}  // namespace sphereview
