// Work that takes long, while Python's other threads and signals go on.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "base/background_job.hpp"

namespace sphereview {

// Returns work(control), done on a thread of its own without Python's lock (GIL). When a signal's handler raises meanwhile, as
// Ctrl+C's does with KeyboardInterrupt, cancels the work and throws that, without waiting for the work's end. So the work must own
// all that it touches, and touch nothing of Python's.
template <typename Work>
auto beside_python(Work work) {
    using Result = std::invoke_result_t<Work&, WorkControl&>;
    const auto result = std::make_shared<std::optional<Result>>();
    const auto owned = std::make_shared<Work>(std::move(work));  // std::function wants what can be copied
    {
        const pybind11::gil_scoped_release others_may_run;
        const BackgroundJob job([result, owned](WorkControl& control) { result->emplace((*owned)(control)); }, WorkPriority::usual);
        while (!job.wait_for(std::chrono::milliseconds(50))) {
            const pybind11::gil_scoped_acquire one_moment;
            if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
        }
        job.rethrow();
    }
    return std::move(**result);
}

}  // namespace sphereview
