// Results that are made beside the window's loop, again and again.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "base/background_job.hpp"

namespace sphereview {

// A value that one thread hands to another.
template <typename Value>
class HandedOver {
public:
    explicit HandedOver(Value value = {}) : value_(std::move(value)) {}
    Value get() const {
        const std::lock_guard lock(mutex_);
        return value_;
    }
    void set(Value value) {
        const std::lock_guard lock(mutex_);
        value_ = std::move(value);
    }

private:
    mutable std::mutex mutex_;
    Value value_;
};

// Makes a result for inputs that go on changing. The latest result stays until there is a later one; a new job begins when the one
// before has ended, so a drag shows many results.
template <typename Asked, typename Made>
class MadeBeside {
public:
    using Make = std::function<Made(WorkControl&)>;

    // Begins the job that begin() returns, unless `asked` was begun last or a job still runs.
    void ask(const Asked& asked, const std::function<Make()>& begin) {
        if (job_ || begun_ == asked) return;
        begun_ = asked;
        making_ = std::make_shared<std::shared_ptr<const Made>>();
        job_ = std::make_unique<BackgroundJob>(
            [found = making_, make = begin()](WorkControl& control) { *found = std::make_shared<const Made>(make(control)); });
    }
    // Takes the result of a job that ends within `time`; a failed job leaves the former result. Returns whether a job has ended.
    bool take(std::chrono::milliseconds time = std::chrono::milliseconds(0)) {
        if (!job_ || !job_->wait_for(time)) return false;
        job_.reset();
        if (*making_) {
            made_ = *making_;
            made_of_ = begun_;
        }
        making_.reset();
        return true;
    }
    // Sets a result that was made elsewhere.
    void set(const Asked& asked, std::shared_ptr<const Made> made) {
        begun_ = asked;
        made_of_ = asked;
        made_ = std::move(made);
    }

    bool works() const { return job_ != nullptr; }
    // Null before the first.
    const std::shared_ptr<const Made>& made() const { return made_; }
    bool is_of(const Asked& asked) const { return made_ && made_of_ == asked; }

private:
    std::optional<Asked> begun_{};
    std::optional<Asked> made_of_{};
    std::shared_ptr<std::shared_ptr<const Made>> making_{};
    std::shared_ptr<const Made> made_{};
    std::unique_ptr<BackgroundJob> job_{};
};

}  // namespace sphereview
