// Running this program again, at arm's length.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace sphereview {

struct ChildResult {
    enum class End { exited, killed_by_signal, timed_out, not_started };

    End end = End::not_started;
    int code = 0;        // the exit status or the signal's number
    std::string output;  // standard output
    std::string errors;  // standard error, or why it was not started
};

// Runs this very program with `arguments`, without standard input, and waits; kills it after `limit`. For its end with this
// process's, however that comes, the child calls end_with_parent().
ChildResult run_self(const std::vector<std::string>& arguments, std::chrono::milliseconds limit);

// Called by what run_self() started: from now on the system kills this process when its parent has ended. On Linux; elsewhere a
// child that hangs outlives a parent that is killed.
void end_with_parent();

}  // namespace sphereview
