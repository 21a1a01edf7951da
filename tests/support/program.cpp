#include "support/program.hpp"
#include "support/folders.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#ifdef __linux__
#include <linux/capability.h>
#include <sys/prctl.h>
#endif

namespace sphereview::test {

namespace {

constexpr std::chrono::seconds patience{300};  // generous: a sanitized program on a busy machine

struct Ends {
    int read = -1;
    int write = -1;
};

Ends make_pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe can be made");
    return {ends[0], ends[1]};
}

// A terminal: what is written into one end is read from the other.
Ends make_terminal() {
    const int reader = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (reader < 0 || grantpt(reader) != 0 || unlockpt(reader) != 0) throw std::runtime_error("no terminal can be made");
    const int writer = open(ptsname(reader), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios settings{};
    if (writer < 0 || tcgetattr(writer, &settings) != 0) throw std::runtime_error("the terminal cannot be opened");
    settings.c_oflag &= ~static_cast<tcflag_t>(OPOST);  // line ends stay as they are
    tcsetattr(writer, TCSANOW, &settings);
    return {reader, writer};
}

Ends make_output(StandardOutput kind) {
    if (kind == StandardOutput::full_disk) return {-1, open("/dev/full", O_WRONLY | O_CLOEXEC)};
    Ends ends = make_pipe();
    if (kind == StandardOutput::closed_pipe) close(std::exchange(ends.read, -1));
    return ends;
}

void limit(int resource, rlim_t most) {
    if (most == RLIM_INFINITY) return;
    const rlimit limits{most, most};
    setrlimit(static_cast<decltype(RLIMIT_FSIZE)>(resource), &limits);
}

// Between fork and exec. `failed` closes by itself when the program has started; else a byte says that it has not.
[[noreturn]] void become(const Command& command, const std::string& program, char** argv, const std::array<int, 3>& streams,
                         int failed) {
    for (int i = 0; i < 3; ++i) dup2(streams[static_cast<std::size_t>(i)], i);
    limit(RLIMIT_FSIZE, command.largest_file);
    limit(RLIMIT_AS, command.most_memory);
#ifdef __linux__
    // Without this capability root meets permissions like everyone; others do not have it anyway.
    if (command.obeys_permissions) prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0);
#endif
    std::signal(SIGINT, command.ignores_interrupts ? SIG_IGN : SIG_DFL);
    std::signal(SIGPIPE, SIG_DFL);
    unsetenv("SPHEREVIEW_BACKEND");
    for (const auto& [name, value] : command.environment) {
        value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
    }
    if (chdir(command.folder.c_str()) == 0) execv(program.c_str(), argv);
    [[maybe_unused]] const auto written = write(failed, "!", 1);
    _exit(127);
}

// Whether the traced process stands at the beginning of read(0, ...).
bool enters_a_read_of_input(pid_t process) {
    __ptrace_syscall_info info{};
    return ptrace(PTRACE_GET_SYSCALL_INFO, process, sizeof info, &info) > 0 && info.op == PTRACE_SYSCALL_INFO_ENTRY &&
           info.entry.nr == SYS_read && info.entry.args[0] == STDIN_FILENO;
}

}  // namespace

std::vector<std::string> all_words(std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::ostream& operator<<(std::ostream& stream, const Outcome& outcome) {
    if (outcome.out_of_time)
        stream << "it did not end in time";
    else if (outcome.signal != 0)
        stream << "it was ended by signal " << outcome.signal;
    else
        stream << "it exited with status " << outcome.status;
    const bool binary = outcome.output.find('\0') != std::string::npos;
    stream << "\nstdout: " << (binary ? std::to_string(outcome.output.size()) + " binary bytes" : outcome.output);
    return stream << "\nstderr: " << outcome.errors;
}

Running::Running(const Command& command) : input_stays_open_(command.input_stays_open), unwritten_input_(command.input) {
    const std::string program = command.program.empty() ? build_file("sphereview") : command.program;
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : command.arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);

    const Ends input = make_pipe();
    const Ends output = make_output(command.output);
    const Ends errors = command.errors_to_terminal ? make_terminal() : make_pipe();
    const Ends failed = make_pipe();
    process_ = fork();
    if (process_ < 0) throw std::runtime_error("no process can be started");
    if (process_ == 0) become(command, program, argv.data(), {input.read, output.write, errors.write}, failed.write);
    for (const int end : {input.read, output.write, errors.write, failed.write}) close(end);
    char byte = 0;
    const bool started = read(failed.read, &byte, 1) == 0;
    close(failed.read);
    if (!started) ADD_FAILURE() << program << " cannot be started in " << command.folder;
    input_ = input.write;
    output_ = output.read;
    errors_ = errors.read;
    fcntl(input_, F_SETFL, O_NONBLOCK);
    std::signal(SIGPIPE, SIG_IGN);  // a program need not read its input
}

Running::~Running() {
    if (process_ > 0 && !ended_) {
        send(SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    for (int* descriptor : {&input_, &output_, &errors_}) drop(*descriptor);
}

void Running::send(int signal_number) const { kill(process_, signal_number); }

bool Running::has_ended() {
    int status = 0;
    if (!ended_ && waitpid(process_, &status, WNOHANG) == process_) ended_ = status;
    return ended_.has_value();
}

double Running::processor_seconds() const {
    std::ifstream file("/proc/" + std::to_string(process_) + "/stat");
    std::string line;
    std::getline(file, line);
    std::istringstream fields(line.substr(line.rfind(')') + 1));  // the name before it may hold anything
    std::string skipped;
    for (int i = 0; i < 11; ++i) fields >> skipped;
    long user = 0;
    long system = 0;
    fields >> user >> system;
    return static_cast<double>(user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

void Running::close_input() {
    input_stays_open_ = false;
    while (!unwritten_input_.empty() && collect()) {
    }
    drop(input_);
}

void Running::drop(int& descriptor) {
    if (descriptor >= 0) close(std::exchange(descriptor, -1));
}

// Moves what can be moved through the pipes; false when standard output and error have ended or nothing came for long.
bool Running::collect() {
    if (unwritten_input_.empty() && !input_stays_open_) drop(input_);
    if (output_ < 0 && errors_ < 0) return false;
    const int writable = unwritten_input_.empty() ? -1 : input_;
    std::array<pollfd, 3> waiting = {{{output_, POLLIN, 0}, {errors_, POLLIN, 0}, {writable, POLLOUT, 0}}};
    if (poll(waiting.data(), waiting.size(), 1000 * static_cast<int>(patience.count())) <= 0) {
        outcome_.out_of_time = true;
        return false;
    }
    std::array<char, 65536> buffer{};
    const auto take = [&](const pollfd& from, int& descriptor, std::string& into) {
        if (from.revents == 0) return;
        const ssize_t count = read(descriptor, buffer.data(), buffer.size());
        if (count > 0)
            into.append(buffer.data(), static_cast<std::size_t>(count));
        else
            drop(descriptor);  // also EIO: how a terminal ends
    };
    take(waiting[0], output_, outcome_.output);
    take(waiting[1], errors_, outcome_.errors);
    if (waiting[2].revents != 0) {
        const ssize_t count = write(input_, unwritten_input_.data(), unwritten_input_.size());
        if (count >= 0) {
            unwritten_input_.erase(0, static_cast<std::size_t>(count));
        } else if (errno != EAGAIN) {
            unwritten_input_.clear();
        }
    }
    return true;
}

bool Running::wait_for_errors(const std::string& text, int times) {
    std::size_t after = 0;
    for (int found = 0; found < times;) {
        const std::size_t at = outcome_.errors.find(text, after);
        if (at != std::string::npos) {
            after = at + text.size();
            ++found;
        } else if (!collect()) {
            return false;
        }
    }
    return true;
}

bool Running::stop_after_system_calls(int count) {
    if (ptrace(PTRACE_SEIZE, process_, nullptr, PTRACE_O_TRACESYSGOOD) != 0 ||
        ptrace(PTRACE_INTERRUPT, process_, nullptr, nullptr) != 0) {
        ADD_FAILURE() << "the program cannot be traced";
        return false;
    }
    close_input();
    bool reading = false;
    int status = 0;
    while (waitpid(process_, &status, 0) > 0) {
        if (!WIFSTOPPED(status)) {
            ended_ = status;
            return false;
        }
        reading = reading || enters_a_read_of_input(process_);
        if (reading && count-- == 0) return true;
        ptrace(PTRACE_SYSCALL, process_, nullptr, nullptr);
    }
    return false;
}

void Running::resume_with(int signal_number) const {
    send(signal_number);
    ptrace(PTRACE_DETACH, process_, nullptr, nullptr);
}

Outcome Running::wait() {
    while (collect()) {
    }
    if (outcome_.out_of_time) send(SIGKILL);
    int status = ended_.value_or(0);
    while (!ended_ && waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    if (outcome_.out_of_time) return outcome_;
    if (WIFEXITED(status)) outcome_.status = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome_.signal = WTERMSIG(status);
    return outcome_;
}

Outcome run(const Command& command) { return Running(command).wait(); }

Outcome run(std::vector<std::string> arguments, Environment environment) {
    return run(Command{.arguments = std::move(arguments), .environment = std::move(environment)});
}

}  // namespace sphereview::test
