#include "base/isolated_call.hpp"

#ifdef _WIN32
#include <windows.h>

#include <array>
#else
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

#include "base/path.hpp"
#include "base/user_folders.hpp"

namespace sphereview {

#ifdef _WIN32

namespace {

// A pipe, whose writing end the started process inherits, and what came out of it.
struct Pipe {
    HANDLE read_end = nullptr;
    HANDLE write_end = nullptr;
    std::string text;

    Pipe() {
        SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
        if (CreatePipe(&read_end, &write_end, &inherited, 0) != 0) SetHandleInformation(read_end, HANDLE_FLAG_INHERIT, 0);
    }
    ~Pipe() {
        if (read_end != nullptr) CloseHandle(read_end);
        close_write_end();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_write_end() {
        if (write_end != nullptr) CloseHandle(write_end);
        write_end = nullptr;
    }
    // What is there now. Not up to the end: what the process starts in turn may keep the pipe open.
    void drain() {
        std::array<char, 4096> buffer{};
        DWORD count = 0;
        while (PeekNamedPipe(read_end, nullptr, 0, nullptr, &count, nullptr) != 0 && count > 0 &&
               ReadFile(read_end, buffer.data(), buffer.size(), &count, nullptr) != 0) {
            text.append(buffer.data(), count);
        }
    }
};

}  // namespace

IsolatedResult call_isolated(const std::function<std::string()>& call, std::chrono::milliseconds limit,
                             const std::vector<std::string>& arguments) {
    using End = IsolatedResult::End;
    Pipe value;
    Pipe errors;
    const std::wstring program = program_file().wstring();
    std::wstring line = L"\"" + program + L"\"";
    for (const std::string& argument : arguments) line += L" \"" + path_from(argument).wstring() + L"\"";
    STARTUPINFOW start{};
    start.cb = sizeof start;
    start.dwFlags = STARTF_USESTDHANDLES;
    start.hStdOutput = value.write_end;
    start.hStdError = errors.write_end;
    PROCESS_INFORMATION process{};
    SetErrorMode(GetErrorMode() | SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);  // a crash ends the started program at once
    if (arguments.empty() || value.write_end == nullptr || errors.write_end == nullptr ||
        CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, CREATE_NO_WINDOW, nullptr, nullptr, &start,
                       &process) == 0) {
        return {End::returned, 0, call(), ""};
    }
    CloseHandle(process.hThread);
    value.close_write_end();
    errors.close_write_end();
    constexpr DWORD a_while = 10;  // ms
    const auto deadline = std::chrono::steady_clock::now() + limit;
    bool ended = false;
    while (!ended && std::chrono::steady_clock::now() < deadline) {
        ended = WaitForSingleObject(process.hProcess, a_while) == WAIT_OBJECT_0;
        value.drain();
        errors.drain();
    }
    if (!ended) TerminateProcess(process.hProcess, 1);
    DWORD status = 0;
    GetExitCodeProcess(process.hProcess, &status);
    CloseHandle(process.hProcess);
    constexpr DWORD exceptions = 0x80000000;  // their numbers and above
    const End end = !ended                              ? End::timed_out
                    : status >= exceptions              ? End::crashed
                    : status != 0 || value.text.empty() ? End::exited
                                                        : End::returned;
    return {end, static_cast<unsigned>(status), value.text, errors.text};
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

IsolatedResult call_isolated(const std::function<std::string()>& call, std::chrono::milliseconds limit,
                             const std::vector<std::string>& /*arguments*/) {
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
        result.code = static_cast<unsigned>(WTERMSIG(status));
    } else if (WEXITSTATUS(status) != 0 || result.value.empty()) {
        result.end = IsolatedResult::End::exited;
        result.code = static_cast<unsigned>(WEXITSTATUS(status));
    }
    return result;
}

#endif

}  // namespace sphereview
