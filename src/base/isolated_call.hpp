// Calling what may hang, crash or end the program.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace sphereview {

struct IsolatedResult {
    enum class End { returned, timed_out, crashed, exited };

    End end = End::returned;
    unsigned code = 0;   // the signal's number (on Windows the exception's) or the exit status
    std::string value;   // what the call returned
    std::string errors;  // what came on standard error
};

// Calls `call` in a copy of this process, which must have one thread, and waits; kills the copy after `limit`. The copy ends with
// this process, however that ends. Windows cannot copy a process: there this program is started with `arguments`, at which it must
// write to standard output what `call` returns. Where that cannot be done, or no memory is left, the call is made in this process.
IsolatedResult call_isolated(const std::function<std::string()>& call, std::chrono::milliseconds limit,
                             const std::vector<std::string>& arguments = {});

}  // namespace sphereview
