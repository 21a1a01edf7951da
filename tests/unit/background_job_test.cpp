#include "base/background_job.hpp"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <thread>

#include "base/parallel.hpp"

namespace sphereview {

TEST(BackgroundJob, EndsAndPassesOnWhatItThrew) {
    auto value = std::make_shared<int>(0);
    const BackgroundJob job([value](WorkControl& control) {
        control.done = 7;
        *value = 5;
    });
    job.wait();
    EXPECT_TRUE(job.ended());
    EXPECT_EQ(*value, 5);
    EXPECT_EQ(job.control().done, 7u);
    EXPECT_NO_THROW(job.rethrow());
    const BackgroundJob failing([](WorkControl&) { throw std::runtime_error("no"); });
    failing.wait();
    EXPECT_THROW(failing.rethrow(), std::runtime_error);
}

TEST(BackgroundJob, IsNotWaitedForWhenNobodyWantsIt) {
    std::promise<void> gate;
    std::promise<bool> told;
    {
        const BackgroundJob job([open = gate.get_future().share(), &told](WorkControl& control) {
            open.wait();
            told.set_value(control.cancelled);
            control.check();
        });
        EXPECT_FALSE(job.wait_for(std::chrono::milliseconds(1)));
    }
    gate.set_value();  // only now, after its end, can the work go on
    EXPECT_TRUE(told.get_future().get());
}

TEST(BackgroundJob, LeavesItsLoopsWhenItIsCancelled) {
    std::promise<void> begun;
    std::promise<void> left;
    {
        const BackgroundJob job([&](WorkControl& control) {
            try {
                parallel_for(1'000'000, [&](std::size_t i) {
                    if (i == 0) begun.set_value();
                    while (!control.cancelled) std::this_thread::yield();
                });
            } catch (const Cancelled&) {
                left.set_value();
            }
        });
        begun.get_future().wait();
    }
    EXPECT_EQ(left.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
}

TEST(BackgroundJob, SharesTheCoresWithItsLoop) {
    const auto sum = [] {
        std::atomic<std::size_t> total = 0;
        for (int round = 0; round < 200; ++round) {
            parallel_for(64, [&](std::size_t i) { total += i; });
        }
        return total.load();
    };
    auto other = std::make_shared<std::size_t>(0);
    const BackgroundJob job([other, sum](WorkControl&) { *other = sum(); });
    EXPECT_EQ(sum(), 200u * 64 * 63 / 2);
    job.wait();
    EXPECT_EQ(*other, 200u * 64 * 63 / 2);
}

}  // namespace sphereview
