#include "base/piped_program.hpp"

#ifdef _WIN32
#include <windows.h>
#else
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <thread>

#include "base/error.hpp"
#include "base/path.hpp"

#ifndef _WIN32
extern char** environ;
#endif

namespace sphereview {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_errors = 4096;
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

// As the run-time libraries of other programs take a command line apart.
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

struct PipedProgram::Process {
    HANDLE process = nullptr;
    HANDLE input = nullptr;
    HANDLE errors_end = nullptr;
    std::thread reader{};
    std::string errors{};

    bool write(std::string_view bytes) const {
        while (!bytes.empty()) {
            DWORD count = 0;
            const auto most = static_cast<DWORD>(std::min(bytes.size(), std::size_t{1} << 20));
            if (WriteFile(input, bytes.data(), most, &count, nullptr) == 0) return false;
            bytes.remove_prefix(count);
        }
        return true;
    }
    bool read(std::array<char, 4096>& buffer, std::size_t& count) const {
        DWORD read = 0;
        const bool good = ReadFile(errors_end, buffer.data(), static_cast<DWORD>(buffer.size()), &read, nullptr) != 0;
        count = read;
        return good && read > 0;
    }
    void end_input() { close_handle(input); }
    void kill() const {
        TerminateProcess(process, 1);
        WaitForSingleObject(process, most_wait);
    }
    bool wait() {
        WaitForSingleObject(process, INFINITE);
        DWORD status = 1;
        GetExitCodeProcess(process, &status);
        return status == 0;
    }
    ~Process() {
        close_handle(process);
        close_handle(errors_end);
    }
};

PipedProgram::PipedProgram(const std::string& path, const std::vector<std::string>& arguments)
    : process_(std::make_unique<Process>()) {
    std::wstring line = quoted(path_from(path).wstring());
    for (const std::string& argument : arguments) line += L" " + quoted(path_from(argument).wstring());
    SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
    HANDLE its_input = nullptr;
    HANDLE its_errors = nullptr;
    HANDLE null = CreateFileW(L"NUL", GENERIC_WRITE, 0, &inherited, OPEN_EXISTING, 0, nullptr);
    bool good = CreatePipe(&its_input, &process_->input, &inherited, 0) != 0 &&
                CreatePipe(&process_->errors_end, &its_errors, &inherited, 0) != 0;
    if (good) {
        SetHandleInformation(process_->input, HANDLE_FLAG_INHERIT, 0);
        SetHandleInformation(process_->errors_end, HANDLE_FLAG_INHERIT, 0);
        STARTUPINFOW start{};
        start.cb = sizeof start;
        start.dwFlags = STARTF_USESTDHANDLES;
        start.hStdInput = its_input;
        start.hStdOutput = null;
        start.hStdError = its_errors;
        PROCESS_INFORMATION started{};
        // A group of its own: Ctrl+C is for this program, which then ends the other one.
        good = CreateProcessW(path_from(path).c_str(), line.data(), nullptr, nullptr, TRUE,
                              CREATE_NO_WINDOW | CREATE_NEW_PROCESS_GROUP, nullptr, nullptr, &start, &started) != 0;
        if (good) CloseHandle(started.hThread);
        process_->process = started.hProcess;
    }
    const auto error = static_cast<int>(GetLastError());
    close_handle(its_input);
    close_handle(its_errors);
    close_handle(null);
    if (!good) throw OutputError(path, "the program cannot be started", error);
    read_errors(path);
}

#else

struct PipedProgram::Process {
    pid_t process = -1;
    int input = -1;
    int errors_end = -1;
    std::thread reader{};
    std::string errors{};
    std::atomic<bool> ended = false;

    bool write(std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t count = ::write(input, bytes.data(), bytes.size());
            if (count < 0 && errno != EINTR) return false;
            bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        }
        return true;
    }
    bool read(std::array<char, 4096>& buffer, std::size_t& count) const {
        ssize_t got = -1;
        do {
            got = ::read(errors_end, buffer.data(), buffer.size());
        } while (got < 0 && errno == EINTR);
        count = static_cast<std::size_t>(std::max<ssize_t>(got, 0));
        return got > 0;
    }
    void end_input() {
        if (input >= 0) close(input);
        input = -1;
    }
    void kill() const {
        if (ended) return;
        ::kill(-process, SIGKILL);  // with what it has started: it may be a script
        // Until it is gone it may still make a file. It stays known to who waits for it.
        for (int waited = 0; waited < most_wait; ++waited) {
            siginfo_t end{};
            if (waitid(P_PID, static_cast<id_t>(process), &end, WEXITED | WNOHANG | WNOWAIT) != 0 || end.si_pid != 0) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    bool wait() {
        int status = 1;
        while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
        ended = true;
        return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }
    ~Process() {
        end_input();
        if (errors_end >= 0) close(errors_end);
    }
};

PipedProgram::PipedProgram(const std::string& path, const std::vector<std::string>& arguments)
    : process_(std::make_unique<Process>()) {
    std::array<int, 2> input{-1, -1};
    std::array<int, 2> errors{-1, -1};
    const bool piped = pipe(input.data()) == 0 && pipe(errors.data()) == 0;
    int error = piped ? 0 : errno;
    for (const int end : {input[0], input[1], errors[0], errors[1]}) fcntl(end, F_SETFD, FD_CLOEXEC);
    process_->input = input[1];
    process_->errors_end = errors[0];
    if (piped) {
        std::vector<char*> words{const_cast<char*>(path.c_str())};
        for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
        words.push_back(nullptr);
        posix_spawn_file_actions_t streams;
        posix_spawn_file_actions_init(&streams);
        posix_spawn_file_actions_adddup2(&streams, input[0], STDIN_FILENO);
        posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&streams, errors[1], STDERR_FILENO);
        // A group of its own: Ctrl+C is for this program, which then ends the other one. And signals as programs expect them.
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        sigset_t usual;
        sigemptyset(&usual);
        for (const int signal_number : {SIGPIPE, SIGXFSZ}) sigaddset(&usual, signal_number);
        posix_spawnattr_setsigdefault(&attributes, &usual);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
        error = posix_spawn(&process_->process, path.c_str(), &streams, &attributes, words.data(), environ);
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&streams);
    }
    for (const int end : {input[0], errors[1]}) {
        if (end >= 0) close(end);
    }
    if (error != 0) {
        process_->ended = true;
        throw OutputError(path, std::string("the program cannot be started: ") + std::strerror(error), error);
    }
    read_errors(path);
}

#endif

void PipedProgram::read_errors(const std::string& path) {
    try {
        process_->reader = std::thread([process = process_.get()] {
            std::array<char, 4096> buffer{};
            std::size_t count = 0;
            while (process->read(buffer, count))
                process->errors.append(buffer.data(), std::min(count, most_errors - process->errors.size()));
        });
    } catch (const std::system_error& error) {
        process_->kill();
        process_->end_input();
        process_->wait();
        throw OutputError(path, "the program cannot be started: the system allows no more threads", error.code().value());
    }
}

PipedProgram::~PipedProgram() {
    if (!process_->reader.joinable()) return;
    process_->kill();
    process_->end_input();
    process_->wait();
    process_->reader.join();
}

bool PipedProgram::write(std::string_view bytes) { return process_->write(bytes); }

bool PipedProgram::finish() {
    if (!process_->reader.joinable()) return done_;
    process_->end_input();
    process_->reader.join();
    done_ = process_->wait();
    return done_;
}

void PipedProgram::kill() { process_->kill(); }

const std::string& PipedProgram::errors() const { return process_->errors; }

}  // namespace sphereview
