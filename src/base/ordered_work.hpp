// Makes many things several at once, but begins and delivers them in order.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>

namespace sphereview {

// The steps of one thing, by its place from 0. An exception of a step ends the work.
struct OrderedWork {
    std::size_t count = 0;
    std::function<void(std::size_t)> begin;     // in order, one at a time: reading from a file
    std::function<void(std::size_t)> make;      // after its `begin`; several at once
    std::function<bool(std::size_t)> deliver;   // after its `make`; in order, one at a time. False ends the work
    std::function<void(std::size_t)> wait;      // now and then, on deliver()'s thread, until the next is made
    std::function<std::size_t()> most_at_once;  // how many may be in progress, at least 1; asked before each `begin`
};

// Lets other threads ask one thread to act, such as to draw in its GL context.
class Errands {
public:
    // Waits until the serving thread has called `errand`, and throws what that threw. Throws Cancelled if that thread has stopped
    // serving.
    void ask(const std::function<void()>& errand);
    // Calls the errands, until close().
    void serve();
    void close();

private:
    // On the stack of the asking thread.
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

// Does the work with `threads` threads that make and one that delivers; the calling thread serves the errands. When the work ends,
// loops in `make` end too (base/parallel.hpp). False, and nothing is done, if the threads cannot be started. Throws what a step
// threw.
bool do_in_order(const OrderedWork& work, int threads, Errands& errands);

}  // namespace sphereview
