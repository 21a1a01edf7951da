// Work on several cores, and beside the caller.
#include "base/parallel.hpp"

#include <gtest/gtest.h>
#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <atomic>
#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/background_job.hpp"
#include "base/error.hpp"
#include "support/eventually.hpp"
#include "support/no_threads.hpp"

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

#ifndef SPHEREVIEW_SANITIZED  // whose allocator may be locked in the copy
// Whatever other threads have locked while the copy is made.
TEST(Parallel, WorksInACopyOfAProcessThatIsAtWork) {
    const auto sum = [] {
        std::atomic<std::size_t> total = 0;
        parallel_for(100, [&](std::size_t i) { total += i; });
        return total == 4950;
    };
    std::atomic<bool> ended = false;
    std::vector<std::thread> busy(3);
    for (std::thread& thread : busy) {
        thread = std::thread([&] {
            while (!ended) sum();
        });
    }
    int status = 0;
    for (int trial = 0; trial < 100 && status == 0; ++trial) {
        const pid_t copy = fork();
        if (copy == 0) {
            alarm(60);  // ends a copy that waits for ever
            bool good = true;
            for (int i = 0; i < 20; ++i) good = sum() && good;
            _exit(good ? 0 : 1);
        }
        ASSERT_GT(copy, 0);
        EXPECT_EQ(waitpid(copy, &status, 0), copy);
        EXPECT_EQ(status, 0) << trial;
    }
    ended = true;
    for (std::thread& thread : busy) thread.join();
}
#endif

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

TEST(BackgroundJob, HasEndedAndSaysWhyWhereThereCanBeNoThread) {
    if (!test::NoThreads::possible) GTEST_SKIP() << "threads can always begin here";
    const test::NoThreads none;
    const BackgroundJob job([](WorkControl&) { FAIL(); });
    EXPECT_TRUE(job.ended());
    EXPECT_THROW(job.rethrow(), RenderError);
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

TEST(BackgroundJob, LeavesLongWorkThatAsksWhetherToEnd) {
    std::promise<void> begun;
    std::promise<void> left;
    {
        const BackgroundJob job([&](WorkControl&) {
            try {
                parallel_for(8, [&](std::size_t i) {
                    if (i == 0) begun.set_value();
                    while (true) check_cancelled();
                });
            } catch (const Cancelled&) {
                left.set_value();
            }
        });
        begun.get_future().wait();
    }
    EXPECT_EQ(left.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
    check_cancelled();  // of no loop: nothing happens
}

#ifdef __linux__
// A window draws and answers meanwhile, on the same cores.
TEST(BackgroundJob, GivesWayWithAllItsThreads) {
    const auto nicest = [] {  // of the threads that share a loop: each is met, since none takes two calls
        std::atomic<int> met = 0;
        std::atomic<int> nice = -20;
        parallel_for(static_cast<std::size_t>(worker_count()), [&](std::size_t) {
            int others = nice;
            const int own = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
            while (own > others && !nice.compare_exchange_weak(others, own)) {
            }
            ++met;
            test::eventually([&] { return met == worker_count(); });
        });
        return nice.load();
    };
    const int usual = nicest();
    int background = 0;
    BackgroundJob([&](WorkControl&) { background = nicest(); }).wait();
    constexpr int nicest_of_all = 19;
    EXPECT_EQ(background, std::min(usual + 10, nicest_of_all));
    EXPECT_EQ(nicest(), usual) << "the loop's own threads became slow";
}
#endif

}  // namespace

}  // namespace sphereview
