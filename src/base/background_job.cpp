#include "base/background_job.hpp"

#include <exception>
#include <system_error>
#include <thread>
#include <utility>

#include "base/error.hpp"

namespace sphereview {

BackgroundJob::BackgroundJob(std::function<void(WorkControl&)> work, WorkPriority priority)
    : control_(std::make_shared<WorkControl>()) {
    const auto end = std::make_shared<std::promise<void>>();
    end_ = end->get_future();
    auto run = [control = control_, work = std::move(work), priority, end]() mutable {
        std::exception_ptr error;
        try {
            if (priority == WorkPriority::gives_way) give_way();
            cancel_loops_by(&control->cancelled);
            work(*control);
        } catch (...) {
            error = std::current_exception();
        }
        work = nullptr;  // what it holds may be large: it goes here, not where the end is awaited
        if (error) {
            end->set_exception(std::move(error));
        } else {
            end->set_value();
        }
    };
    try {
        std::thread(std::move(run)).detach();
    } catch (const std::system_error&) {
        end->set_exception(std::make_exception_ptr(RenderError("the system allows no more threads")));
    }
}

BackgroundJob::~BackgroundJob() {
    if (control_) control_->cancelled = true;
}

}  // namespace sphereview
