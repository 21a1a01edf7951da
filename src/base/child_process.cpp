#include "base/child_process.hpp"

#ifndef _WIN32
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string_view>
#include <utility>

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

// Windows has no EGL or OSMesa to probe and no zenity; what asks for a child there does its work itself.
struct ChildProcess::State {};

ChildProcess::ChildProcess(const std::string&, const std::vector<std::string>&, Group) {}
ChildProcess::~ChildProcess() = default;
ChildResult ChildProcess::wait(std::optional<std::chrono::steady_clock::time_point>) {
    return {ChildResult::End::not_started, 0, "", "child processes are not supported here"};
}
void ChildProcess::kill() {}

ChildResult run_self(const std::vector<std::string>& arguments, std::chrono::milliseconds) {
    return ChildProcess("", arguments, ChildProcess::Group::ours).wait({});
}
std::string find_program(const std::string&) { return ""; }

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

// The two ends of a pipe, closed when done. No child gets them unless it is told to.
struct Pipe {
    std::array<int, 2> ends{-1, -1};

    Pipe() {
#ifdef __linux__
        if (pipe2(ends.data(), O_CLOEXEC) != 0) ends = {-1, -1};
#else
        if (pipe(ends.data()) != 0) ends = {-1, -1};
        for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
#endif
    }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    bool open() const { return ends[0] >= 0; }
    void close_end(std::size_t which) {
        if (ends[which] >= 0) close(ends[which]);
        ends[which] = -1;
    }
};

// Of posix_spawn, or 0.
int spawn(const std::string& program, const std::vector<std::string>& arguments, int output, int errors, bool own_group,
          pid_t& child) {
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    if (own_group) posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int error = posix_spawn(&child, program.c_str(), &actions, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

}  // namespace

struct ChildProcess::State {
    Pipe output;
    Pipe errors;
    Pipe killed;  // kill() closes the writing end
    pid_t child = 0;
    bool own_group = false;
    std::string why_not_started;
    std::mutex mutex;  // of what follows: once the system has forgotten the child, its number may be another's
    bool forgotten = true;

    // Whether it has ended; with `block`, waits for that.
    bool ended(bool block) {
        siginfo_t info{};
        const int options = WEXITED | WNOWAIT | (block ? 0 : WNOHANG);
        while (waitid(P_PID, static_cast<id_t>(child), &info, options) != 0) {
            if (errno != EINTR) return true;
        }
        return info.si_pid != 0;
    }
    void send_kill() { ::kill(own_group ? -child : child, SIGKILL); }
    bool drain(ChildResult& result, std::optional<Clock::time_point> deadline);
};

// Reads both pipes until they close, or the child has ended though something that it started has them still; false when
// `deadline` or kill() came first.
bool ChildProcess::State::drain(ChildResult& result, std::optional<Clock::time_point> deadline) {
    constexpr std::int64_t tick = 250;  // ms between looks at a child that says nothing
    std::array<char, 4096> buffer{};
    while (output.ends[0] >= 0 || errors.ends[0] >= 0) {
        std::int64_t left = tick;
        if (deadline) left = std::chrono::duration_cast<std::chrono::milliseconds>(*deadline - Clock::now()).count();
        if (left <= 0) return false;
        std::array<pollfd, 3> waiting = {{{output.ends[0], POLLIN, 0}, {errors.ends[0], POLLIN, 0}, {killed.ends[0], POLLIN, 0}}};
        const int ready = poll(waiting.data(), waiting.size(), static_cast<int>(std::min(left, tick)));
        if (ready < 0) {
            if (errno != EINTR) return false;
            continue;
        }
        if (ready == 0 && ended(false)) return true;
        if (waiting[2].revents != 0) return false;
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

ChildProcess::ChildProcess(const std::string& program, const std::vector<std::string>& arguments, Group group)
    : state_(std::make_unique<State>()) {
    state_->own_group = group == Group::own;
    if (!state_->output.open() || !state_->errors.open() || !state_->killed.open()) {
        state_->why_not_started = "no pipe can be made";
        return;
    }
    const int error = spawn(program, arguments, state_->output.ends[1], state_->errors.ends[1], state_->own_group, state_->child);
    state_->output.close_end(1);
    state_->errors.close_end(1);
    if (error != 0) {
        state_->why_not_started = std::strerror(error);
    } else {
        state_->forgotten = false;
    }
}

ChildProcess::~ChildProcess() {
    kill();
    if (!state_->forgotten) waitpid(state_->child, nullptr, 0);
}

void ChildProcess::kill() {
    const std::lock_guard lock(state_->mutex);
    if (!state_->forgotten) state_->send_kill();
    state_->killed.close_end(1);
}

ChildResult ChildProcess::wait(std::optional<std::chrono::steady_clock::time_point> deadline) {
    ChildResult result;
    if (state_->forgotten) {
        result.errors = state_->why_not_started;
        return result;
    }
    const bool finished = state_->drain(result, deadline);
    if (!finished) {
        const std::lock_guard lock(state_->mutex);
        state_->send_kill();
    }
    state_->ended(true);
    const std::lock_guard lock(state_->mutex);
    int status = 0;
    while (waitpid(state_->child, &status, 0) < 0 && errno == EINTR) {
    }
    state_->forgotten = true;
    const bool was_killed = state_->killed.ends[1] < 0;
    if (!finished && !was_killed) {
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

ChildResult run_self(const std::vector<std::string>& arguments, std::chrono::milliseconds limit) {
    const std::string program = own_path();
    if (program.empty()) return {ChildResult::End::not_started, 0, "", "the program cannot find itself"};
    return ChildProcess(program, arguments, ChildProcess::Group::ours).wait(Clock::now() + limit);
}

std::string find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::string_view folders = path == nullptr ? "" : path;
    while (!folders.empty()) {
        const std::size_t end = std::min(folders.find(':'), folders.size());
        // Only absolute ones: what runs must not depend on the current folder.
        std::string program = std::string(folders.substr(0, end)) + '/' + name;
        struct stat status {};
        if (program[0] == '/' && stat(program.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
            access(program.c_str(), X_OK) == 0) {
            return program;
        }
        folders.remove_prefix(std::min(end + 1, folders.size()));
    }
    return "";
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
