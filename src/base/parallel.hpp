// Work shared by all cores.
#pragma once

#include <atomic>
#include <cstddef>

namespace sphereview {

// What cancelled work throws: nobody waits for it any more.
struct Cancelled {};

// How many threads share the work: one for each core that this process may use.
int worker_count();

// From now on this thread, and the loops that it begins, get the processor only where others leave it: a window that is used
// meanwhile stays as quick as without them. There is no way back, which systems reserve for privileged processes. Nothing where the
// system has no such thing.
void give_way();

// Whether the loops that this thread begins from now on run on it alone: where each core has a thread with work of its own, to
// share it would only make them wait for each other.
void keep_loops_on_this_thread(bool alone);

// From now on the loops that this thread begins end soon after `flag` is set, and throw Cancelled.
// nullptr: they always end by themselves.
void cancel_loops_by(const std::atomic<bool>* flag);

// Throws Cancelled when the loop is to end in which this is called, or that this thread would begin: for work(i) that may take
// long.
void check_cancelled();

namespace detail {

// Calls call(work, i) for every i below `count`.
void share_work(std::size_t count, void (*call)(const void* work, std::size_t i), const void* work);

}  // namespace detail

// Calls work(i) once for each i below `count`, on all cores and in any order, and returns when all calls have. The first
// exception stops what has not begun and is thrown here. Threads that are here at the same time share the cores. Inside work() it
// runs alone.
template <typename Work>
void parallel_for(std::size_t count, const Work& work) {
    detail::share_work(
        count, [](const void* w, std::size_t i) { (*static_cast<const Work*>(w))(i); }, &work);
}

// Calls work(begin, end) for pieces of [0, count) of at most `piece` each.
template <typename Work>
void parallel_pieces(std::size_t count, std::size_t piece, const Work& work) {
    parallel_for((count + piece - 1) / piece, [&](std::size_t i) {
        const std::size_t begin = i * piece;
        work(begin, count - begin < piece ? count : begin + piece);
    });
}

}  // namespace sphereview
