#include "base/background_job.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "base/parallel.hpp"

namespace sphereview {

struct BackgroundJob::Shared {
    WorkControl control;
    std::mutex mutex;
    std::condition_variable end;
    bool ended = false;
    std::exception_ptr error;
};

BackgroundJob::BackgroundJob(std::function<void(WorkControl&)> work) : shared_(std::make_shared<Shared>()) {
    std::thread([shared = shared_, work = std::move(work)]() mutable {
        std::exception_ptr error;
        try {
            cancel_loops_by(&shared->control.cancelled);
            work(shared->control);
        } catch (...) {
            error = std::current_exception();
        }
        work = nullptr;  // what it holds may be large: it goes here, not where the end is awaited
        {
            const std::lock_guard lock(shared->mutex);
            shared->ended = true;
            shared->error = std::move(error);
        }
        shared->end.notify_all();
    }).detach();
}

BackgroundJob::~BackgroundJob() {
    if (shared_) shared_->control.cancelled = true;
}

const WorkControl& BackgroundJob::control() const { return shared_->control; }

bool BackgroundJob::ended() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->ended;
}

void BackgroundJob::wait() const {
    std::unique_lock lock(shared_->mutex);
    shared_->end.wait(lock, [this] { return shared_->ended; });
}

bool BackgroundJob::wait_for(std::chrono::milliseconds time) const {
    std::unique_lock lock(shared_->mutex);
    return shared_->end.wait_for(lock, time, [this] { return shared_->ended; });
}

void BackgroundJob::rethrow() const {
    if (shared_->error) std::rethrow_exception(shared_->error);
}

}  // namespace sphereview
