#include "base/child_process.hpp"

#ifndef _WIN32
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <string_view>

#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif
#ifdef __linux__
#include <sys/prctl.h>
#endif

extern char** environ;  // NOLINT(readability-redundant-declaration): glibc declares it, POSIX does not
#endif

namespace sphereview {

#ifdef _WIN32

// Windows has no EGL or OSMesa to probe; what asks for a child there does its work itself.
ChildResult run_self(const std::vector<std::string>&, std::chrono::milliseconds) {
    return {ChildResult::End::not_started, 0, "", "child processes are not supported here"};
}

#else

namespace {

using Clock = std::chrono::steady_clock;

std::string own_path() {
    std::array<char, 4096> path{};
#ifdef __APPLE__
    auto size = static_cast<std::uint32_t>(path.size());
    return _NSGetExecutablePath(path.data(), &size) == 0 ? path.data() : "";
#else
    const ssize_t length = readlink("/proc/self/exe", path.data(), path.size() - 1);
    return length > 0 ? std::string(path.data(), static_cast<std::size_t>(length)) : "";
#endif
}

// The two ends of a pipe, closed when done.
struct Pipe {
    std::array<int, 2> ends{-1, -1};
    bool open = pipe(ends.data()) == 0;

    Pipe() {
        for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
    }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_end(std::size_t which) {
        if (ends[which] >= 0) close(ends[which]);
        ends[which] = -1;
    }
};

// Reads both pipes until they close; false when `deadline` came first.
bool drain(Pipe& output, Pipe& errors, ChildResult& result, Clock::time_point deadline) {
    std::array<char, 4096> buffer{};
    while (output.ends[0] >= 0 || errors.ends[0] >= 0) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) return false;
        std::array<pollfd, 2> waiting = {{{output.ends[0], POLLIN, 0}, {errors.ends[0], POLLIN, 0}}};
        if (poll(waiting.data(), waiting.size(), static_cast<int>(left)) < 0 && errno != EINTR) return false;
        const std::array<std::pair<Pipe*, std::string*>, 2> streams = {{{&output, &result.output}, {&errors, &result.errors}}};
        for (std::size_t i = 0; i < streams.size(); ++i) {
            if (waiting[i].revents == 0) continue;
            const ssize_t count = read(waiting[i].fd, buffer.data(), buffer.size());
            if (count > 0) {
                streams[i].second->append(buffer.data(), static_cast<std::size_t>(count));
            } else {
                streams[i].first->close_end(0);
            }
        }
    }
    return true;
}

}  // namespace

ChildResult run_self(const std::vector<std::string>& arguments, std::chrono::milliseconds limit) {
    ChildResult result;
    const std::string program = own_path();
    Pipe output;
    Pipe errors;
    if (program.empty() || !output.open || !errors.open) {
        result.errors = "the program cannot find or connect to itself";
        return result;
    }
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output.ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors.ends[1], STDERR_FILENO);
    pid_t child = 0;
    const int error = posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        result.errors = std::strerror(error);
        return result;
    }
    output.close_end(1);
    errors.close_end(1);

    const auto deadline = Clock::now() + limit;
    const bool finished = drain(output, errors, result, deadline);
    if (!finished) kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!finished) {
        result.end = ChildResult::End::timed_out;
    } else if (WIFSIGNALED(status)) {
        result.end = ChildResult::End::killed_by_signal;
        result.code = WTERMSIG(status);
    } else {
        result.end = ChildResult::End::exited;
        result.code = WEXITSTATUS(status);
    }
    return result;
}

#endif

#ifdef __linux__
void end_with_parent() {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    // A parent that ended before that sends no signal, but has left nobody to read what we write.
    pollfd output{STDOUT_FILENO, 0, 0};
    if (poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0) _exit(128 + SIGKILL);
}
#else
void end_with_parent() {}
#endif

}  // namespace sphereview
