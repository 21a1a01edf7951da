// Things that are made several at once come in order.
#include "base/ordered_work.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/background_job.hpp"
#include "support/no_threads.hpp"

namespace sphereview {

namespace {

std::vector<std::size_t> up_to(std::size_t count) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers.push_back(i);
    return numbers;
}

// The steps of each thing, noted.
struct Noted {
    std::vector<std::size_t> begun{};
    std::vector<std::size_t> delivered{};
    std::atomic<std::size_t> on_the_way = 0;
    std::atomic<std::size_t> most_on_the_way = 0;
    std::size_t last = 1000;  // to be delivered

    OrderedWork work(std::size_t count, std::size_t at_once) {
        return {count,
                [this](std::size_t place) {
                    begun.push_back(place);
                    most_on_the_way = std::max<std::size_t>(most_on_the_way, ++on_the_way);
                },
                // The earlier ones take longer.
                [](std::size_t place) {
                    for (std::size_t i = place % 4; i < 4; ++i) std::this_thread::yield();
                },
                [this](std::size_t place) {
                    delivered.push_back(place);
                    --on_the_way;
                    return place != last;
                },
                [](std::size_t) {}, [at_once] { return at_once; }};
    }
};

}  // namespace

TEST(OrderedWork, BeginsAndDeliversInOrder) {
    for (const std::size_t at_once : {1, 2, 5}) {
        Noted noted;
        Errands errands;
        EXPECT_TRUE(do_in_order(noted.work(100, at_once), 3, errands));
        EXPECT_EQ(noted.begun, up_to(100));
        EXPECT_EQ(noted.delivered, up_to(100));
        EXPECT_LE(noted.most_on_the_way, at_once);
    }
}

TEST(OrderedWork, MakesSeveralAtOnce) {
    // Each waits for the other.
    std::atomic<int> there = 0;
    Noted noted;
    OrderedWork work = noted.work(2, 2);
    work.make = [&](std::size_t) {
        ++there;
        while (there < 2) std::this_thread::yield();
    };
    Errands errands;
    EXPECT_TRUE(do_in_order(work, 2, errands));
    EXPECT_EQ(noted.delivered, up_to(2));
}

TEST(OrderedWork, EndsWhenToldAndAtTheFirstError) {
    Noted noted;
    noted.last = 3;
    Errands errands;
    EXPECT_TRUE(do_in_order(noted.work(100, 2), 2, errands));
    EXPECT_EQ(noted.delivered, up_to(4));
    EXPECT_LE(noted.begun.size(), 6U);

    Noted failing;
    OrderedWork work = failing.work(100, 2);
    work.make = [](std::size_t place) {
        if (place == 7) throw std::runtime_error("the seventh");
    };
    Errands others;
    EXPECT_THROW(do_in_order(work, 2, others), std::runtime_error);
    EXPECT_LE(failing.delivered.size(), 7U);
}

// Nobody waits for ever, whichever step it is.
TEST(OrderedWork, EndsWhereAStepIsCancelled) {
    const auto cancel = [](std::size_t place) {
        if (place == 7) throw Cancelled();
    };
    Noted noted;
    OrderedWork begins = noted.work(100, 2);
    begins.begin = cancel;
    OrderedWork makes = noted.work(100, 2);
    makes.make = cancel;
    OrderedWork delivers = noted.work(100, 2);
    delivers.deliver = [&](std::size_t place) {
        cancel(place);
        return true;
    };
    for (const OrderedWork& work : {begins, makes, delivers}) {
        Errands errands;
        EXPECT_THROW(do_in_order(work, 2, errands), Cancelled);
    }
}

TEST(OrderedWork, ErrandsAreDoneByWhoWaits) {
    const std::thread::id here = std::this_thread::get_id();
    std::atomic<int> done = 0;
    Errands errands;
    Noted noted;
    OrderedWork work = noted.work(20, 4);
    work.make = [&](std::size_t) {
        errands.ask([&] { done += std::this_thread::get_id() == here ? 1 : 0; });
        EXPECT_THROW(errands.ask([] { throw std::runtime_error("an errand's"); }), std::runtime_error);
    };
    EXPECT_TRUE(do_in_order(work, 3, errands));
    EXPECT_EQ(done, 20);
    EXPECT_THROW(errands.ask([] {}), Cancelled);
}

// Who waits for an errand that is never done waits no longer when the work ends.
TEST(OrderedWork, EndsWhileErrandsWait) {
    for (int run = 0; run < 200; ++run) {
        Noted noted;
        noted.last = 0;
        std::atomic<int> asked = 0;
        std::atomic<bool> ends = false;
        Errands errands;
        OrderedWork work = noted.work(8, 8);
        work.make = [&](std::size_t place) {
            if (place == 0) return;
            ++asked;
            errands.ask([&] {
                while (!ends) std::this_thread::yield();
            });
        };
        work.deliver = [&](std::size_t) {
            while (asked < 3) std::this_thread::yield();
            ends = true;
            return false;
        };
        EXPECT_TRUE(do_in_order(work, 4, errands));
    }
}

TEST(OrderedWork, IsNotBegunWithoutThreads) {
    if (!test::NoThreads::possible) GTEST_SKIP() << "threads can always begin here";
    const test::NoThreads none;
    Noted noted;
    Errands errands;
    EXPECT_FALSE(do_in_order(noted.work(3, 2), 2, errands));
    EXPECT_TRUE(noted.begun.empty());
}

}  // namespace sphereview
