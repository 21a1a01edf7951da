#include "base/interrupt.hpp"

#include <array>
#include <atomic>
#include <cassert>
#include <csignal>
#include <cstdlib>
#include <cstring>

#ifndef _WIN32
#include <unistd.h>
#endif

namespace sphereview {

namespace {

// Written before the flag is set and read by the handler only while it is: no lock is allowed in a handler.
std::array<char, 4096> unfinished_path{};
std::atomic<bool> unfinished = false;
std::atomic<bool> progress_bar_shown = false;

extern "C" void on_interrupt(int signal_number) {
#ifdef _WIN32
    if (unfinished.load()) std::remove(unfinished_path.data());
    std::_Exit(128 + signal_number);
#else
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

UnfinishedFile::UnfinishedFile(const std::string& path) {
    assert(!unfinished.load());
    if (path.size() >= unfinished_path.size()) return;  // too long to be remembered: an interruption leaves the hidden file
    std::memcpy(unfinished_path.data(), path.c_str(), path.size() + 1);
    unfinished.store(true);
}

UnfinishedFile::~UnfinishedFile() { unfinished.store(false); }

void set_progress_bar_shown(bool shown) { progress_bar_shown.store(shown); }

}  // namespace sphereview
