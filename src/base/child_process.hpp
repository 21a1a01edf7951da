// Running a program, this one or another, at arm's length.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
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

// A program that runs beside this one, without standard input.
class ChildProcess {
public:
    // `ours`: Ctrl+C in the terminal reaches it. `own`: it does not, and kill() also ends what the program has started.
    enum class Group { ours, own };

    // Starts `program`, a path; no shell sees the arguments. Where that fails, wait() says so.
    ChildProcess(const std::string& program, const std::vector<std::string>& arguments, Group group);
    ~ChildProcess();  // kills it if it still runs
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    // Waits until it has ended; kills it at `deadline`, if there is one. Call once.
    ChildResult wait(std::optional<std::chrono::steady_clock::time_point> deadline);

    // From any thread, also while another waits: that then returns soon.
    void kill();

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Runs this very program with `arguments`, without standard input, and waits; kills it after `limit`. For its end with this
// process's, however that comes, the child calls end_with_parent().
ChildResult run_self(const std::vector<std::string>& arguments, std::chrono::milliseconds limit);

// Called by what run_self() started: from now on the system kills this process when its parent has ended. On Linux; elsewhere a
// child that hangs outlives a parent that is killed.
void end_with_parent();

// The path of the program that a shell would run for `name`, by $PATH; "" if there is none, and where child processes are not
// supported.
std::string find_program(const std::string& name);

}  // namespace sphereview
