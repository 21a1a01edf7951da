// Shares work among all cores.
#pragma once

#include <atomic>
#include <cstddef>

namespace sphereview {

// Thrown by cancelled work.
struct Cancelled {};

// The number of threads: one for each core that this process may use.
int worker_count();

// From now on this thread, and the loops that it begins, get only processor time that others leave, so that a window stays quick.
// This cannot be undone, which systems reserve for privileged processes. Does nothing where the system lacks it.
void give_way();

// Whether the loops that this thread begins from now on run on it alone: if each core has a thread with work of its own, sharing
// would only make them wait.
void keep_loops_on_this_thread(bool alone);

// From now on the loops that this thread begins end soon after `flag` is set, and throw Cancelled. nullptr: they run to
// their end.
void cancel_loops_by(const std::atomic<bool>* flag);

// Throws Cancelled if the loop in which this is called, or that this thread would begin, is to end. For a work(i) that may take
// long.
void check_cancelled();

namespace detail {

// Calls call(work, i) for every i below `count`.
void share_work(std::size_t count, void (*call)(const void* work, std::size_t i), const void* work);

}  // namespace detail

// Calls work(i) once for each i below `count`, on all cores and in any order, and waits for all. The first exception stops calls
// that have not begun, and is thrown here. Concurrent loops share the cores. Inside work() a loop runs on its thread alone.
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
