// When frames of a film are due, and which. Times are given, not waited for.
#include "viewer/play_clock.hpp"

#include <gtest/gtest.h>

namespace sphereview {

namespace {

using namespace std::chrono_literals;

using FrameNumbers = std::vector<std::int64_t>;

constexpr PlayClock::Time start_time{100s};
const PlayChoices ten_a_second{.speed = 10.0};

}  // namespace

TEST(PlayClock, KeepsTheBeatAndCatchesUpWithNoMoreThanOne) {
    PlayClock clock;
    EXPECT_FALSE(clock.plays());
    clock.play(start_time);
    EXPECT_TRUE(clock.plays());
    EXPECT_EQ(clock.due(ten_a_second), start_time + 100ms);
    clock.shown(ten_a_second, start_time + 130ms);
    EXPECT_EQ(clock.due(ten_a_second), start_time + 200ms) << "a late frame does not make the next one late";
    clock.shown(ten_a_second, start_time + 750ms);
    EXPECT_EQ(clock.due(ten_a_second), start_time + 850ms) << "what was held up is not hurried through";
    clock.hold(start_time + 2s);
    EXPECT_EQ(clock.due(ten_a_second), start_time + 2100ms);
    EXPECT_EQ(clock.due({.speed = 2.0}), start_time + 2500ms) << "another speed holds at once";
    clock.shown(ten_a_second, start_time + 2010ms);
    EXPECT_EQ(clock.due(ten_a_second), start_time + 2110ms) << "a frame that was asked for by hand";
    clock.pause();
    EXPECT_FALSE(clock.plays());
}

TEST(PlayClock, EndsOrRepeats) {
    const PlayClock clock;
    const KnownFrames four{4, true};
    EXPECT_EQ(clock.next_ones(1, Repeat::once, four, 9), (FrameNumbers{2, 3}));
    EXPECT_EQ(clock.next_ones(2, Repeat::loop, four, 5), (FrameNumbers{3, 0, 1, 2, 3}));
    EXPECT_EQ(clock.next_ones(2, Repeat::back_and_forth, four, 8), (FrameNumbers{3, 2, 1, 0, 1, 2, 3, 2}));
    for (const Repeat repeat : {Repeat::once, Repeat::loop, Repeat::back_and_forth}) {
        EXPECT_EQ(clock.next_ones(0, repeat, {1, true}, 3), FrameNumbers{}) << "there is no other";
    }
}

TEST(PlayClock, WaitsForFramesToBeFound) {
    const PlayClock clock;
    for (const Repeat repeat : {Repeat::once, Repeat::loop, Repeat::back_and_forth}) {
        EXPECT_EQ(clock.next_ones(2, repeat, {4, false}, 3), FrameNumbers{3}) << "the last known one need not be the last";
    }
}

TEST(PlayClock, GoesForwardWhereItDoesNotGoBackAnyMore) {
    PlayClock clock;
    const KnownFrames four{4, true};
    EXPECT_EQ(clock.step_from(3, Repeat::back_and_forth, four), 2);
    EXPECT_EQ(clock.step_from(2, Repeat::back_and_forth, four), 1);
    EXPECT_EQ(clock.step_from(1, Repeat::loop, four), 2);
    EXPECT_EQ(clock.step_from(2, Repeat::back_and_forth, four), 3);
    // The file has become shorter.
    EXPECT_EQ(clock.step_from(9, Repeat::back_and_forth, four), 3);
    EXPECT_EQ(PlayClock().step_from(9, Repeat::loop, four), 0);
}

TEST(PlaySpeeds, GoUpAndDownAndEnd) {
    EXPECT_EQ(next_speed(24.0, 1), 30.0);
    EXPECT_EQ(next_speed(24.0, -1), 15.0);
    EXPECT_EQ(next_speed(play_speeds.front(), -1), play_speeds.front());
    EXPECT_EQ(next_speed(play_speeds.back(), 1), play_speeds.back());
}

}  // namespace sphereview
