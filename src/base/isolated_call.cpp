#include "base/isolated_call.hpp"

#ifndef _WIN32
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <thread>
#endif

namespace sphereview {

#ifdef _WIN32

IsolatedResult call_isolated(const std::function<std::string()>& call, std::chrono::milliseconds) {
    return {IsolatedResult::End::returned, 0, call(), ""};
}

#else

namespace {

using Clock = std::chrono::steady_clock;

// Both ends are closed when done, and in programs that the process starts.
struct Pipe {
    std::array<int, 2> ends{-1, -1};

    Pipe() {
        if (pipe(ends.data()) != 0) ends = {-1, -1};
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
    // What is there, up to a page; false at the end.
    bool read_into(std::string& text) {
        std::array<char, 4096> buffer{};
        const ssize_t count = read(ends[0], buffer.data(), buffer.size());
        if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
        return count > 0 || (count < 0 && errno == EINTR);
    }
};

struct Pipes {
    Pipe value, errors;
    Pipe parent;  // its writing end closes when the parent ends
};

[[noreturn]] void be_the_copy(const std::function<std::string()>& call, Pipes& pipes) {
    pipes.parent.close_end(1);
    try {
        std::thread([&pipes] {
            std::string nothing;
            while (pipes.parent.read_into(nothing)) continue;
            _exit(1);
        }).detach();
        const int null = open("/dev/null", O_RDWR);
        dup2(null, STDIN_FILENO);
        dup2(null, STDOUT_FILENO);
        dup2(pipes.errors.ends[1], STDERR_FILENO);
        const std::string value = call();
        for (std::size_t done = 0; done < value.size();) {
            const ssize_t count = write(pipes.value.ends[1], value.data() + done, value.size() - done);
            if (count < 0 && errno != EINTR) break;
            done += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
        }
    } catch (const std::exception&) {
        _exit(1);
    }
    _exit(0);
}

// Until the copy has ended; false when `deadline` came first.
bool drain(Pipes& pipes, IsolatedResult& result, Clock::time_point deadline) {
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) return false;
        std::array<pollfd, 2> waiting = {{{pipes.value.ends[0], POLLIN, 0}, {pipes.errors.ends[0], POLLIN, 0}}};
        if (poll(waiting.data(), waiting.size(), static_cast<int>(std::min<std::int64_t>(left, 1'000'000))) < 0) continue;
        if (waiting[1].revents != 0 && !pipes.errors.read_into(result.errors))
            pipes.errors.close_end(0);
        else if (waiting[0].revents != 0 && !pipes.value.read_into(result.value))
            return true;
    }
}

}  // namespace

IsolatedResult call_isolated(const std::function<std::string()>& call, std::chrono::milliseconds limit) {
    const auto deadline = Clock::now() + limit;
    Pipes pipes;
    const pid_t copy = pipes.parent.ends[0] < 0 ? -1 : fork();
    if (copy < 0) return {IsolatedResult::End::returned, 0, call(), ""};
    if (copy == 0) be_the_copy(call, pipes);
    pipes.value.close_end(1);
    pipes.errors.close_end(1);
    IsolatedResult result;
    const bool in_time = drain(pipes, result, deadline);
    if (!in_time) kill(copy, SIGKILL);
    int status = 0;
    while (waitpid(copy, &status, 0) < 0 && errno == EINTR) continue;
    if (!in_time) {
        result.end = IsolatedResult::End::timed_out;
    } else if (WIFSIGNALED(status)) {
        result.end = IsolatedResult::End::crashed;
        result.code = WTERMSIG(status);
    } else if (WEXITSTATUS(status) != 0 || result.value.empty()) {
        result.end = IsolatedResult::End::exited;
        result.code = WEXITSTATUS(status);
    }
    return result;
}

#endif

}  // namespace sphereview
