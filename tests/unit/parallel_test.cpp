#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "support/eventually.hpp"

namespace sphereview {
namespace {

TEST(Parallel, CallsEachOnce) {
    for (const std::size_t count : {0U, 1U, 2U, 3U, 1000U, 100'000U}) {
        std::vector<int> calls(count);
        parallel_for(count, [&](std::size_t i) { ++calls[i]; });
        EXPECT_EQ(calls, std::vector<int>(count, 1));
    }
}

TEST(Parallel, PiecesCoverEverythingOnce) {
    for (const std::size_t count : {0U, 1U, 9U, 10U, 11U, 1005U}) {
        std::vector<int> calls(count);
        parallel_pieces(count, 10, [&](std::size_t begin, std::size_t end) {
            EXPECT_LE(end - begin, 10U);
            for (std::size_t i = begin; i < end; ++i) ++calls[i];
        });
        EXPECT_EQ(calls, std::vector<int>(count, 1));
    }
}

// Two calls that wait for each other: they can only end when both run at once.
TEST(Parallel, UsesMoreThanOneThread) {
    if (worker_count() < 2) GTEST_SKIP() << "this process may use one core only";
    std::atomic<int> begun = 0;
    parallel_for(2, [&](std::size_t) {
        ++begun;
        while (begun < 2) std::this_thread::yield();
    });
    EXPECT_EQ(begun, 2);
}

// While one thread's work stands still, the others help another's: again two calls that wait for each other.
TEST(Parallel, SharesItsThreadsBetweenJobs) {
    if (worker_count() < 2) GTEST_SKIP() << "this process may use one core only";
    std::atomic<bool> begun = false;
    std::atomic<bool> released = false;
    std::thread other([&] {
        parallel_for(static_cast<std::size_t>(worker_count()), [&, owner = std::this_thread::get_id()](std::size_t) {
            if (std::this_thread::get_id() == owner) {
                begun = true;
                while (!released) std::this_thread::yield();
            }
            while (!begun) std::this_thread::yield();
        });
    });
    while (!begun) std::this_thread::yield();
    std::atomic<int> met = 0;
    parallel_for(2, [&](std::size_t) {
        ++met;
        EXPECT_TRUE(test::eventually([&] { return met == 2; }));
    });
    released = true;
    other.join();
}

TEST(Parallel, RethrowsAndCanBeUsedAgain) {
    for (int round = 0; round < 100; ++round) {
        EXPECT_THROW(parallel_for(1000, [](std::size_t i) { i % 7 == 3 ? throw std::runtime_error("no") : void(); }),
                     std::runtime_error);
        std::atomic<std::size_t> sum = 0;
        parallel_for(100, [&](std::size_t i) { sum += i; });
        EXPECT_EQ(sum, 4950U);
    }
}

TEST(Parallel, MayBeNestedAndUsedByManyThreads) {
    std::atomic<int> calls = 0;
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&] {
            for (int round = 0; round < 50; ++round) {
                parallel_for(10, [&](std::size_t) { parallel_for(10, [&](std::size_t) { ++calls; }); });
            }
        });
    }
    threads.clear();
    EXPECT_EQ(calls, 4 * 50 * 100);
}

}  // namespace
}  // namespace sphereview
