// Calling what may hang, crash or end the program.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace sphereview {

struct IsolatedResult {
    enum class End { returned, timed_out, crashed, exited };

    End end = End::returned;
    int code = 0;        // the signal's number or the exit status
    std::string value;   // what the call returned
    std::string errors;  // what came on standard error
};

// Calls `call` in a copy of this process, which must have one thread, and waits; kills the copy after `limit`. The copy ends with
// this process, however that ends. Where processes cannot be copied (Windows, or no memory is left) the call is made in this one.
IsolatedResult call_isolated(const std::function<std::string()>& call, std::chrono::milliseconds limit);

}  // namespace sphereview
