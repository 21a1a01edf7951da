// Many things of one kind that are made several at once, and begun and delivered one after the other.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>

namespace sphereview {

// The steps of one thing, by its place from 0. What one of them throws ends the work.
struct OrderedWork {
    std::size_t count = 0;
    std::function<void(std::size_t)> begin;    // in order, one at a time: reading from a file
    std::function<void(std::size_t)> make;     // behind its `begin`; several at once
    std::function<bool(std::size_t)> deliver;  // behind its `make`; in order, one at a time. False ends the work
    std::function<void(std::size_t)> wait;     // now and then while the next to be delivered is not made, where deliver() is called
    std::function<std::size_t()> most_at_once;  // how many may be begun and not delivered, at least 1; asked before each `begin`
};

// Things that only one thread may do, as drawing in a context of GL, asked for by others.
class Errands {
public:
    // Returns when the serving thread has called `errand`, and throws what that throws. Throws Cancelled when that thread serves no
    // more.
    void ask(const std::function<void()>& errand);
    // Calls what is asked for, until close().
    void serve();
    void close();

private:
    // Belongs to who asks, and waits for its end.
    struct Errand {
        const std::function<void()>& act;
        std::exception_ptr error{};
        enum class State { waits, is_done, is_dropped } state = State::waits;
    };

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Errand*> asked_for_;
    bool closed_ = false;
};

// Does the work with `threads` that make, and one that delivers; meanwhile the calling one does their errands. The loops of threads
// that make end when the work does (base/parallel.hpp). False, and nothing is done, where the system allows no such threads. Throws
// what a step has thrown.
bool do_in_order(const OrderedWork& work, int threads, Errands& errands);

}  // namespace sphereview
