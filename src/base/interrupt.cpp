#include "base/interrupt.hpp"

#include <array>
#include <atomic>
#include <cassert>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

#ifndef _WIN32
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <thread>
#endif

namespace sphereview {

namespace {

// Written before the flag is set and read by the handler only while it is: no lock is allowed in a handler.
std::array<char, 4096> unfinished_path{};
std::atomic<bool> unfinished = false;
std::atomic<bool> progress_bar_shown = false;

#ifndef _WIN32
// Where the handler writes a signal's number to, once.
std::atomic<int> passing_pipe = -1;
#endif

extern "C" void on_interrupt(int signal_number) {
#ifdef _WIN32
    if (unfinished.load()) std::remove(unfinished_path.data());
    std::_Exit(128 + signal_number);
#else
    const int pipe_end = passing_pipe.exchange(-1);
    if (pipe_end >= 0) {
        const auto number = static_cast<unsigned char>(signal_number);
        if (write(pipe_end, &number, 1) == 1) return;
    }
    if (unfinished.load()) unlink(unfinished_path.data());
    if (progress_bar_shown.load()) {
        constexpr char clear_line[] = "\r\x1b[K";
        [[maybe_unused]] const auto written = write(STDERR_FILENO, clear_line, sizeof clear_line - 1);
    }
    _exit(128 + signal_number);
#endif
}

void handle_unless_ignored(int signal_number) {
    if (std::signal(signal_number, on_interrupt) == SIG_IGN) std::signal(signal_number, SIG_IGN);
}

}  // namespace

void install_interrupt_handlers() {
    handle_unless_ignored(SIGINT);
    handle_unless_ignored(SIGTERM);
#ifndef _WIN32
    handle_unless_ignored(SIGHUP);
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
#endif
}

void pass_interrupts_to(std::function<void(int)> act) {
#ifdef _WIN32
    static_cast<void>(act);
#else
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return;  // signals go on ending the process
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
    std::thread([read_end = ends[0], act = std::move(act)] {
        unsigned char number = 0;
        ssize_t count = 0;
        do {
            count = read(read_end, &number, 1);
        } while (count < 0 && errno == EINTR);
        if (count == 1) act(number);
    }).detach();
    passing_pipe.store(ends[1]);
#endif
}

UnfinishedFile::UnfinishedFile(const std::string& path) {
    assert(!unfinished.load());
    if (path.size() >= unfinished_path.size()) return;  // too long to be remembered: an interruption leaves the hidden file
    std::memcpy(unfinished_path.data(), path.c_str(), path.size() + 1);
    unfinished.store(true);
}

UnfinishedFile::~UnfinishedFile() { unfinished.store(false); }

void set_progress_bar_shown(bool shown) { progress_bar_shown.store(shown); }

}  // namespace sphereview
