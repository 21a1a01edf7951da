// Frames that are read beside the loop.
#include "viewer/frames_ahead.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <thread>

#include "support/eventually.hpp"
#include "support/no_threads.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

namespace {

std::string frame_of_two(int number) {
    return "2\n\nO " + std::to_string(number) + " 0 100\nH " + std::to_string(number) + " 2 100\n";
}

struct AheadFile : testing::Test {
    std::string write(int frames, const std::string& end = "") {
        std::string text;
        for (int i = 0; i < frames; ++i) text += frame_of_two(i);
        return folder.write("a.xyz", text + end);
    }
    static double x_of(const std::optional<LoadedScene>& loaded) { return loaded.value().scene.spheres.at(0).center.x; }
    static bool is_counted(const FramesAhead& ahead) {
        return test::eventually([&] { return ahead.count().all; });
    }

    test::TemporaryFolder folder;
};

}  // namespace

TEST_F(AheadFile, GivesWhatIsWantedOnce) {
    FramesAhead ahead(write(5), {});
    EXPECT_FALSE(ahead.take(3));
    ahead.want({3, 4, 0});
    for (const std::int64_t frame : {std::int64_t{0}, std::int64_t{4}, std::int64_t{3}}) {
        ahead.wait_for(frame);
        EXPECT_EQ(ahead.fault_of(frame), std::nullopt);
        EXPECT_EQ(x_of(ahead.take(frame)), static_cast<double>(frame));
        EXPECT_FALSE(ahead.take(frame));
    }
    ahead.want({1, 2});
    ahead.wait_for(1);
    ahead.want({2});
    EXPECT_FALSE(ahead.take(1)) << "what is not wanted any more is forgotten";
    ahead.wait_for(2);
    EXPECT_TRUE(ahead.take(2));
}

// Whoever drags a handle over frames sees some of those on the way.
TEST_F(AheadFile, WhatWasReadWhileAnotherCameToBeWantedIsThereOnce) {
    FramesAhead ahead(write(50), {});
    std::int64_t frame = 0;
    std::optional<PassedFrame> passed;
    EXPECT_TRUE(test::eventually([&] {
        for (int i = 0; i < 1000 && !passed; ++i) {
            frame = (frame + 1) % 50;
            ahead.want({frame});
            // Now and then as long as it takes to begin with a frame, and not to end.
            std::this_thread::sleep_for(std::chrono::microseconds(i % 300));
            passed = ahead.take_passed();
        }
        return passed.has_value();
    }));
    ASSERT_TRUE(passed);
    EXPECT_EQ(passed->loaded.scene.spheres.at(0).center.x, static_cast<double>(passed->number));
}

TEST_F(AheadFile, CountsWithoutBeingAsked) {
    const FramesAhead ahead(write(200), {});
    ASSERT_TRUE(is_counted(ahead));
    EXPECT_EQ(ahead.count().frames, 200);
    EXPECT_EQ(ahead.count().fault, "");
    EXPECT_GT(ahead.count().part, 0.99);
}

TEST_F(AheadFile, AFaultIsOfItsFrameAlone) {
    FramesAhead ahead(write(2, "2\n\nO 0 0 1\nH x 0 1\n" + frame_of_two(3)), {});
    ahead.want({2, 3});
    ahead.wait_for(2);
    ahead.wait_for(3);
    ASSERT_TRUE(ahead.fault_of(2));
    EXPECT_NE(ahead.fault_of(2)->find("a.xyz:12:3: found 'x'"), std::string::npos) << *ahead.fault_of(2);
    EXPECT_FALSE(ahead.take(2));
    EXPECT_EQ(ahead.fault_of(3), std::nullopt);
    EXPECT_EQ(x_of(ahead.take(3)), 3.0);
}

TEST_F(AheadFile, EndsWhereTheTextIsCutOff) {
    FramesAhead ahead(write(3, "2\n"), {});
    ASSERT_TRUE(is_counted(ahead));
    EXPECT_EQ(ahead.count().frames, 3);
    EXPECT_NE(ahead.count().fault.find("the text ends"), std::string::npos) << ahead.count().fault;
}

TEST_F(AheadFile, AnotherLookReadsAnew) {
    LoadOptions options;
    options.data.all_properties_up_to = 10;
    FramesAhead ahead(write(3), options);
    ahead.want({1});
    ahead.wait_for(1);
    LookOptions grey;
    grey.color_by = "y";
    grey.map = ColorMap::grey;
    grey.range = ValueRange{0.0, 4.0};
    ahead.set_look(grey);
    ahead.set_look(grey);  // nothing is new
    ahead.wait_for(1);
    const auto loaded = ahead.take(1);
    ASSERT_TRUE(loaded);
    const Color color = loaded->scene.spheres.at(1).color;
    EXPECT_EQ(color.r, color.g);
    EXPECT_EQ(color.g, color.b);
}

// What the file's points have because the file says none does not change from frame to frame.
TEST_F(AheadFile, PointsHaveOneRadius) {
    const std::string dump = [] {
        std::string text;
        for (const char* x : {"1", "9"}) {
            text += "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 10\n0 10\n0 10\n";
            text += std::string("ITEM: ATOMS id type x y z\n1 1 0 0 0\n2 1 ") + x + " 0 0\n";
        }
        return text;
    }();
    FramesAhead ahead(folder.write("a.dump", dump), {});
    ahead.want({0, 1});
    ahead.wait_for(0);
    ahead.wait_for(1);
    EXPECT_EQ(ahead.take(0).value().scene.spheres.at(0).radius, ahead.take(1).value().scene.spheres.at(0).radius);
}

// One large frame is read in any case, and no second one beside it.
TEST_F(AheadFile, LargeFramesAreNotHoarded) {
    FramesAhead ahead(write(2), {}, 1);
    ahead.want({0, 1});
    ahead.wait_for(0);
    ASSERT_TRUE(is_counted(ahead));
    EXPECT_FALSE(ahead.take(1));
    EXPECT_TRUE(ahead.take(0));
    ahead.wait_for(1);
    EXPECT_TRUE(ahead.take(1)) << "the room is there again";
}

TEST_F(AheadFile, WhatCannotBeOpenedIsSaidOfEveryFrame) {
    FramesAhead ahead(folder.path("missing.xyz"), {});
    ahead.want({0});
    ahead.wait_for(0);
    ASSERT_TRUE(ahead.fault_of(0));
    EXPECT_NE(ahead.fault_of(0)->find("missing.xyz"), std::string::npos) << *ahead.fault_of(0);
    EXPECT_EQ(ahead.fault_of(7), ahead.fault_of(0));
    EXPECT_TRUE(ahead.count().all);
}

TEST_F(AheadFile, WithoutAThreadThereIsAFaultAndNoWait) {
    if (!test::NoThreads::possible) GTEST_SKIP() << "threads can always begin here";
    const std::string path = write(2);
    const test::NoThreads none;
    FramesAhead ahead(path, {});
    ahead.want({0});
    ahead.wait_for(0);
    EXPECT_TRUE(ahead.fault_of(0).value_or("").ends_with("the system allows no more threads"));
}

// Whoever ends it does not wait for a file that never comes.
TEST_F(AheadFile, ItsEndWaitsForNothing) {
    const std::string fifo = folder.path("a.xyz");
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    FramesAhead ahead(fifo, {});
    ahead.want({0});
    EXPECT_FALSE(ahead.take(0));
}

}  // namespace sphereview
