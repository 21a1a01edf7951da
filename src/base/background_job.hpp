// Work on a thread of its own, beside a loop that must not wait.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>

#include "base/parallel.hpp"

namespace sphereview {

// What a job and its owner tell each other; usable from any thread.
struct WorkControl {
    std::atomic<std::uint64_t> done = 0;   // bytes, or another unit of the work
    std::atomic<std::uint64_t> total = 0;  // in the same unit; 0 while unknown
    std::atomic<bool> cancelled = false;
    std::atomic<bool> writes = false;  // an output that is cancelled now may appear all the same

    // Throws Cancelled if the work is cancelled.
    void check() const {
        if (cancelled) throw Cancelled();
    }
    // Call before the first byte of an output: either this throws Cancelled, or the one who cancels sees `writes`.
    void begin_to_write() {
        writes = true;
        check();
    }
};

// Whether the work gets only processor time that others leave, as beside a window's loop, or as much as the process.
enum class WorkPriority { gives_way, usual };

class BackgroundJob {
public:
    // Begins at once. The work must own all that it touches, because it may outlive this object, as a read of a pipe without a
    // writer does. Cancelled work ends at its next check(), or in its next loop on all cores (base/parallel.hpp). If no thread can
    // be started the job has ended, and rethrow() throws RenderError.
    explicit BackgroundJob(std::function<void(WorkControl&)> work, WorkPriority priority = WorkPriority::gives_way);
    // Cancels without waiting.
    ~BackgroundJob();
    BackgroundJob(BackgroundJob&&) noexcept = default;
    BackgroundJob& operator=(BackgroundJob&&) = delete;
    BackgroundJob(const BackgroundJob&) = delete;
    BackgroundJob& operator=(const BackgroundJob&) = delete;

    const WorkControl& control() const { return *control_; }
    void cancel() { control_->cancelled = true; }
    // Whether the work has ended, also by an exception.
    bool ended() const { return wait_for(std::chrono::milliseconds(0)); }
    void wait() const { end_.wait(); }
    // Returns ended() after at most `time`.
    bool wait_for(std::chrono::milliseconds time) const { return end_.wait_for(time) == std::future_status::ready; }
    // Throws what the work threw. Only after its end.
    void rethrow() const { end_.get(); }

private:
    std::shared_ptr<WorkControl> control_;
    std::shared_future<void> end_;
};

}  // namespace sphereview
