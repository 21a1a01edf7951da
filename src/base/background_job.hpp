// Work on a thread of its own, for a loop that must not wait for it.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>

#include "base/parallel.hpp"

namespace sphereview {

// What the work and who waits for it tell each other; from any thread.
struct WorkControl {
    std::atomic<std::uint64_t> done = 0;   // bytes, or what the work counts in
    std::atomic<std::uint64_t> total = 0;  // likewise; 0 when nobody knows
    std::atomic<bool> cancelled = false;
    std::atomic<bool> writes = false;  // what is cancelled now may be written all the same

    // Throws Cancelled when it is.
    void check() const {
        if (cancelled) throw Cancelled();
    }
    // To be called before the first byte of an output: either this throws Cancelled or who cancels sees `writes`.
    void begin_to_write() {
        writes = true;
        check();
    }
};

// Whether work gets the processor only where others leave it, as what a window does beside its loop, or as the process itself does.
enum class WorkPriority { gives_way, usual };

class BackgroundJob {
public:
    // Begins at once. The work owns what it touches: it may outlive this object, as a read of a pipe that nobody writes to
    // does. Cancelled, it ends at its next check(), or in its next loop on all cores (base/parallel.hpp). When there can be no
    // thread it has ended at once, and rethrow() throws RenderError.
    explicit BackgroundJob(std::function<void(WorkControl&)> work, WorkPriority priority = WorkPriority::gives_way);
    // Cancels, and waits for nothing.
    ~BackgroundJob();
    BackgroundJob(BackgroundJob&&) noexcept = default;
    BackgroundJob& operator=(BackgroundJob&&) = delete;
    BackgroundJob(const BackgroundJob&) = delete;
    BackgroundJob& operator=(const BackgroundJob&) = delete;

    const WorkControl& control() const { return *control_; }
    void cancel() { control_->cancelled = true; }
    // Whether it ended, by itself or by an exception.
    bool ended() const { return wait_for(std::chrono::milliseconds(0)); }
    void wait() const { end_.wait(); }
    // Returns ended() after that time at most.
    bool wait_for(std::chrono::milliseconds time) const { return end_.wait_for(time) == std::future_status::ready; }
    // Throws what the work threw; once it has ended.
    void rethrow() const { end_.get(); }

private:
    std::shared_ptr<WorkControl> control_;
    std::shared_future<void> end_;
};

}  // namespace sphereview
