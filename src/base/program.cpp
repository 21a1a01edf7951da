#include "base/program.hpp"

#ifdef _WIN32
#include <windows.h>
#else
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

#include "base/system_call.hpp"
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/path.hpp"

#ifndef _WIN32
extern char** environ;
#endif

namespace sphereview {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_errors = 4096;
constexpr std::size_t read_at_once = 4096;
constexpr int most_wait = 1000;  // milliseconds, for a program that was killed: one whose disk hangs stays

#ifdef _WIN32
constexpr char path_separator = ';';
constexpr const char* program_ending = ".exe";
#else
constexpr char path_separator = ':';
constexpr const char* program_ending = "";
#endif

bool is_program(const fs::path& file) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) return false;
#ifdef _WIN32
    return true;
#else
    return access(file.c_str(), X_OK) == 0;
#endif
}

}  // namespace

std::string find_program(const std::string& name) {
    const char* variable = std::getenv("PATH");
    std::string_view folders = variable == nullptr ? "" : variable;
    while (!folders.empty()) {
        const std::size_t end = std::min(folders.find(path_separator), folders.size());
        const fs::path file = path_from(std::string(folders.substr(0, end))) / path_from(name + program_ending);
        // An empty folder is the current one, from which nothing is started.
        if (end > 0 && is_program(file)) return text_from(file);
        folders.remove_prefix(std::min(end + 1, folders.size()));
    }
    return "";
}

#ifdef _WIN32

namespace {

// Quotes an argument so that other programs' run-time libraries read it back.
std::wstring quoted(const std::wstring& argument) {
    std::wstring text = L"\"";
    std::size_t backslashes = 0;
    for (const wchar_t c : argument) {
        if (c == L'"') text.append(backslashes + 1, L'\\');
        backslashes = c == L'\\' ? backslashes + 1 : 0;
        text += c;
    }
    return text.append(backslashes, L'\\') + L"\"";
}

void close_handle(HANDLE& handle) {
    if (handle != nullptr && handle != INVALID_HANDLE_VALUE) CloseHandle(handle);
    handle = nullptr;
}

}  // namespace

class ProgramProcess {
public:
    ProgramProcess(const std::string& path, const std::vector<std::string>& arguments, bool has_output) {
        std::wstring line = quoted(path_from(path).wstring());
        for (const std::string& argument : arguments) line += L" " + quoted(path_from(argument).wstring());
        SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
        STARTUPINFOW start{};
        start.cb = sizeof start;
        start.dwFlags = STARTF_USESTDHANDLES;
        bool good =
            CreatePipe(&start.hStdInput, &input_, &inherited, 0) != 0 && CreatePipe(&errors_, &start.hStdError, &inherited, 0) != 0;
        if (has_output) {
            good = good && CreatePipe(&output_, &start.hStdOutput, &inherited, 0) != 0;
        } else {
            start.hStdOutput = CreateFileW(L"NUL", GENERIC_WRITE, 0, &inherited, OPEN_EXISTING, 0, nullptr);
        }
        if (good) {
            for (HANDLE own : {input_, errors_, output_}) {
                if (own != nullptr) SetHandleInformation(own, HANDLE_FLAG_INHERIT, 0);
            }
            SetErrorMode(GetErrorMode() | SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);  // a crash ends it at once
            PROCESS_INFORMATION started{};
            // A group of its own: Ctrl+C is for this program, which then ends the other one.
            good = CreateProcessW(path_from(path).c_str(), line.data(), nullptr, nullptr, TRUE,
                                  CREATE_NO_WINDOW | CREATE_NEW_PROCESS_GROUP, nullptr, nullptr, &start, &started) != 0;
            if (good) CloseHandle(started.hThread);
            process_ = started.hProcess;
        }
        const auto error = static_cast<int>(GetLastError());
        for (HANDLE* its : {&start.hStdInput, &start.hStdOutput, &start.hStdError}) close_handle(*its);
        if (good) return;
        close_all();
        throw OutputError(path, "the program cannot be started", error);
    }
    ~ProgramProcess() { close_all(); }
    ProgramProcess(const ProgramProcess&) = delete;
    ProgramProcess& operator=(const ProgramProcess&) = delete;

    bool write(std::string_view bytes) const {
        while (!bytes.empty()) {
            DWORD count = 0;
            const auto most = static_cast<DWORD>(std::min(bytes.size(), std::size_t{1} << 20));
            if (WriteFile(input_, bytes.data(), most, &count, nullptr) == 0) return false;
            bytes.remove_prefix(count);
        }
        return true;
    }
    void end_input() { close_handle(input_); }

    // Waits for more of its errors; false at their end.
    bool read_errors(std::string& text) const { return read(errors_, text); }
    // What is there now. Not up to the end: what the program starts in turn may keep the pipes open.
    void drain(std::string& output, std::string& errors) const {
        for (const auto& [pipe, text] : {std::pair(output_, &output), std::pair(errors_, &errors)}) {
            DWORD count = 0;
            while (PeekNamedPipe(pipe, nullptr, 0, nullptr, &count, nullptr) != 0 && count > 0 && read(pipe, *text)) {
            }
        }
    }

    void kill() const {
        TerminateProcess(process_, 1);
        WaitForSingleObject(process_, most_wait);
    }
    bool ends_within(int milliseconds) const {
        return WaitForSingleObject(process_, static_cast<DWORD>(milliseconds)) == WAIT_OBJECT_0;
    }
    // Waits for the end.
    ProgramResult result() const {
        WaitForSingleObject(process_, INFINITE);
        DWORD status = 1;
        GetExitCodeProcess(process_, &status);
        constexpr DWORD exceptions = 0x80000000;  // their numbers and above
        using End = ProgramResult::End;
        return {status >= exceptions ? End::crashed : status != 0 ? End::exited : End::returned, static_cast<unsigned>(status)};
    }

private:
    static bool read(HANDLE pipe, std::string& text) {
        std::array<char, read_at_once> buffer{};
        DWORD count = 0;
        const bool good = ReadFile(pipe, buffer.data(), static_cast<DWORD>(buffer.size()), &count, nullptr) != 0;
        text.append(buffer.data(), count);
        return good && count > 0;
    }
    void close_all() {
        for (HANDLE* handle : {&process_, &input_, &output_, &errors_}) close_handle(*handle);
    }

    HANDLE process_ = nullptr;
    HANDLE input_ = nullptr;
    HANDLE output_ = nullptr;
    HANDLE errors_ = nullptr;
};

#else

namespace {

struct Pipe {
    std::array<int, 2> ends = own_pipe();
    int error = ends[0] < 0 ? errno : 0;  // why there is none

    Pipe() = default;
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int operator[](std::size_t which) const { return ends[which]; }
    void close_end(std::size_t which) {
        if (ends[which] >= 0) close(ends[which]);
        ends[which] = -1;
    }
    // Waits for more; false at the end.
    bool read_into(std::string& text) const {
        std::array<char, read_at_once> buffer{};
        const ssize_t count = uninterrupted([&] { return read(ends[0], buffer.data(), buffer.size()); });
        text.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        return count > 0;
    }
};

}  // namespace

class ProgramProcess {
public:
    ProgramProcess(const std::string& path, const std::vector<std::string>& arguments, bool has_output) {
        std::vector<char*> words{const_cast<char*>(path.c_str())};
        for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
        words.push_back(nullptr);
        posix_spawn_file_actions_t streams;
        posix_spawn_file_actions_init(&streams);
        posix_spawn_file_actions_adddup2(&streams, input_[0], STDIN_FILENO);
        if (has_output) {
            posix_spawn_file_actions_adddup2(&streams, output_[1], STDOUT_FILENO);
        } else {
            posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        }
        posix_spawn_file_actions_adddup2(&streams, errors_[1], STDERR_FILENO);
        // A group of its own: Ctrl+C is for this program, which then ends the other one. And signals as programs expect them.
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        sigset_t usual;
        sigemptyset(&usual);
        for (const int signal_number : {SIGPIPE, SIGXFSZ}) sigaddset(&usual, signal_number);
        posix_spawnattr_setsigdefault(&attributes, &usual);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
        int error = std::max({input_.error, output_.error, errors_.error});
        if (error == 0) error = posix_spawn(&process_, path.c_str(), &streams, &attributes, words.data(), environ);
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&streams);
        input_.close_end(0);
        output_.close_end(1);
        errors_.close_end(1);
        if (error != 0) throw OutputError(path, std::string("the program cannot be started: ") + std::strerror(error), error);
    }

    bool write(std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t count = uninterrupted([&] { return ::write(input_[1], bytes.data(), bytes.size()); });
            if (count < 0) return false;
            bytes.remove_prefix(static_cast<std::size_t>(count));
        }
        return true;
    }
    void end_input() { input_.close_end(1); }

    // Waits for more of its errors; false at their end.
    bool read_errors(std::string& text) const { return errors_.read_into(text); }
    // What is there now. Not up to the end: what the program starts in turn may keep the pipes open.
    void drain(std::string& output, std::string& errors) const {
        for (const auto& [pipe, text] : {std::pair(&output_, &output), std::pair(&errors_, &errors)}) {
            pollfd ready{(*pipe)[0], POLLIN, 0};
            while (poll(&ready, 1, 0) > 0 && pipe->read_into(*text)) {
            }
        }
    }

    void kill() const {
        if (ended_) return;
        ::kill(-process_, SIGKILL);  // with what it has started: it may be a script
        ends_within(most_wait);      // until it is gone it may still make a file
    }
    // The ended process stays known, for whoever waits for it.
    bool ends_within(int milliseconds) const {
        for (int waited = 0;; ++waited) {
            siginfo_t end{};
            if (waitid(P_PID, static_cast<id_t>(process_), &end, WEXITED | WNOHANG | WNOWAIT) != 0 || end.si_pid != 0) return true;
            if (waited == milliseconds) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    // Waits for the end; once.
    ProgramResult result() {
        int status = 1;
        uninterrupted([&] { return waitpid(process_, &status, 0); });
        ended_ = true;
        using End = ProgramResult::End;
        if (WIFSIGNALED(status)) return {End::crashed, static_cast<unsigned>(WTERMSIG(status))};
        return {WEXITSTATUS(status) != 0 ? End::exited : End::returned, static_cast<unsigned>(WEXITSTATUS(status))};
    }

private:
    pid_t process_ = -1;
    Pipe input_{};
    Pipe output_{};
    Pipe errors_{};
    std::atomic<bool> ended_ = false;
};

#endif

PipedProgram::PipedProgram(const std::string& path, const std::vector<std::string>& arguments)
    : process_(std::make_unique<ProgramProcess>(path, arguments, false)) {
    const auto give_up = [&] {
        process_->kill();
        process_->end_input();
        process_->result();
    };
    try {
        // The thread itself allocates nothing: nobody could be told that memory has run out.
        std::string more;
        more.reserve(read_at_once);
        errors_.reserve(most_errors);
        reader_ = std::thread([this, more = std::move(more)]() mutable {
            while (process_->read_errors(more)) {
                errors_.append(more, 0, most_errors - std::min(most_errors, errors_.size()));
                more.clear();
            }
        });
    } catch (const std::system_error& error) {
        give_up();
        throw OutputError(path, "the program cannot be started: the system allows no more threads", error.code().value());
    } catch (...) {
        give_up();
        throw;
    }
}

PipedProgram::~PipedProgram() {
    if (!reader_.joinable()) return;
    process_->kill();
    finish();
}

bool PipedProgram::write(std::string_view bytes) { return process_->write(bytes); }

bool PipedProgram::finish() {
    if (reader_.joinable()) {
        process_->end_input();
        reader_.join();
        result_ = process_->result();
    }
    return result_.end == ProgramResult::End::returned;
}

void PipedProgram::kill() { process_->kill(); }

ProgramResult run_program(const std::string& path, const std::vector<std::string>& arguments, std::chrono::milliseconds limit) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds a_while{5};
    ProgramProcess process(path, arguments, true);
    std::string output;
    std::string errors;
    const auto deadline = Clock::now() + limit;
    bool in_time = false;
    std::chrono::milliseconds left = limit;
    while (!in_time && left.count() >= 0) {
        in_time = process.ends_within(static_cast<int>(std::min(left, a_while).count()));
        process.drain(output, errors);
        left = std::chrono::floor<std::chrono::milliseconds>(deadline - Clock::now());
    }
    if (!in_time) process.kill();
    ProgramResult result = process.result();
    if (!in_time) result.end = ProgramResult::End::timed_out;
    if (result.end == ProgramResult::End::returned && output.empty()) result.end = ProgramResult::End::exited;
    result.output = std::move(output);
    result.errors = std::move(errors);
    return result;
}

void end_with_input() {
    std::thread([] {
        std::array<char, 64> ignored{};
#ifdef _WIN32
        DWORD count = 0;
        while (ReadFile(GetStdHandle(STD_INPUT_HANDLE), ignored.data(), ignored.size(), &count, nullptr) != 0 && count > 0) {
        }
#else
        while (uninterrupted([&] { return read(STDIN_FILENO, ignored.data(), ignored.size()); }) > 0) {
        }
#endif
        std::_Exit(1);
    }).detach();
}

}  // namespace sphereview
