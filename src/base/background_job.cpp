#include "base/background_job.hpp"

#include <exception>
#include <thread>
#include <utility>

#include "base/parallel.hpp"

namespace sphereview {

BackgroundJob::BackgroundJob(std::function<void(WorkControl&)> work) : control_(std::make_shared<WorkControl>()) {
    std::promise<void> end;
    end_ = end.get_future();
    std::thread([control = control_, work = std::move(work), end = std::move(end)]() mutable {
        std::exception_ptr error;
        try {
            cancel_loops_by(&control->cancelled);
            work(*control);
        } catch (...) {
            error = std::current_exception();
        }
        work = nullptr;  // what it holds may be large: it goes here, not where the end is awaited
        if (error) {
            end.set_exception(std::move(error));
        } else {
            end.set_value();
        }
    }).detach();
}

BackgroundJob::~BackgroundJob() {
    if (control_) control_->cancelled = true;
}

}  // namespace sphereview
