#include "base/interrupt.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdio>
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

// Threads may write files at the same time. A path is written while its place is taken and read by the handler only while it
// is named: no lock is allowed in a handler.
enum class Place { free, taken, named };
struct Unfinished {
    std::atomic<Place> place = Place::free;
    std::array<char, 4096> path{};
};
std::array<Unfinished, 8> unfinished_files{};
std::atomic<bool> progress_bar_shown = false;

#ifndef _WIN32
// Where the handler writes a signal's number to, once.
std::atomic<int> passing_pipe = -1;
#endif

extern "C" void on_interrupt(int signal_number) {
#ifdef _WIN32
    for (const Unfinished& file : unfinished_files) {
        if (file.place.load() == Place::named) std::remove(file.path.data());
    }
    std::_Exit(128 + signal_number);
#else
    const int pipe_end = passing_pipe.exchange(-1);
    if (pipe_end >= 0) {
        const auto number = static_cast<unsigned char>(signal_number);
        if (write(pipe_end, &number, 1) == 1) return;
    }
    for (const Unfinished& file : unfinished_files) {
        if (file.place.load() == Place::named) unlink(file.path.data());
    }
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
    // Too long, or too many at once, to be remembered: an interruption leaves the hidden file.
    if (path.size() >= unfinished_files[0].path.size()) return;
    for (std::size_t i = 0; i < unfinished_files.size() && place_ < 0; ++i) {
        Unfinished& file = unfinished_files[i];
        Place expected = Place::free;
        if (!file.place.compare_exchange_strong(expected, Place::taken)) continue;
        std::memcpy(file.path.data(), path.c_str(), path.size() + 1);
        file.place.store(Place::named);
        place_ = static_cast<int>(i);
    }
}

UnfinishedFile::~UnfinishedFile() {
    if (place_ >= 0) unfinished_files[static_cast<std::size_t>(place_)].place.store(Place::free);
}

void set_progress_bar_shown(bool shown) { progress_bar_shown.store(shown); }

}  // namespace sphereview
