#include "base/interrupt.hpp"

#include <atomic>
#include <csignal>
#include <cstdlib>

#ifdef _WIN32
#include <windows.h>

#include <mutex>
#include <utility>
#else
#include <unistd.h>

#include <array>

#include "base/system_call.hpp"
#endif

#include <chrono>
#include <system_error>
#include <thread>

namespace sphereview {

namespace {

std::atomic<int> interruption = 0;  // the signal's number
std::atomic<int> unfinished = 0;
std::atomic<bool> progress_bar_shown = false;

// When one was passed on; `timeout`, and who presses Ctrl+C twice, send two at once, which is one interruption.
using Clock = std::chrono::steady_clock;
constexpr auto never = Clock::time_point::max();
constexpr std::chrono::seconds of_one_interruption{1};
std::atomic<Clock::time_point> passed_at = never;

bool is_passed_already() {
    const Clock::time_point passed = passed_at;
    return passed != never && Clock::now() - passed < of_one_interruption;
}

#ifdef _WIN32
// What the first event is passed to.
// Never destroyed: events come also while the process ends.
std::mutex& act_mutex = *new std::mutex;
std::function<void(int)>& act_once = *new std::function<void(int)>;
#else
// Where the handler writes a signal's number to, once.
std::atomic<int> passing_pipe = -1;
#endif

[[noreturn]] void end() {
#ifdef _WIN32
    std::_Exit(128 + interruption);
#else
    constexpr char clear_line[] = "\r\x1b[K";
    [[maybe_unused]] const auto written = progress_bar_shown ? write(STDERR_FILENO, clear_line, sizeof clear_line - 1) : 0;
    _exit(128 + interruption);
#endif
}

// Otherwise the last of what is unfinished ends the process.
void end_unless_unfinished(int signal_number) {
    // In this order, the reverse of Unfinished's: one of the two sees the other.
    interruption = signal_number;
    if (unfinished == 0) end();
}

#ifdef _WIN32

// On a thread that Windows makes for the event. A console that is closed, and a session that ends, end the process when the handler
// returns, and some seconds later anyhow.
BOOL WINAPI on_event(DWORD event) {
    const bool pressed = event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT;
    const int signal_number = pressed ? SIGINT : SIGTERM;
    std::unique_lock lock(act_mutex);
    const auto act = std::exchange(act_once, nullptr);
    if (act) passed_at = Clock::now();
    lock.unlock();
    if (act) {
        act(signal_number);
    } else if (!is_passed_already()) {
        end_unless_unfinished(signal_number);
    }
    if (!pressed) Sleep(INFINITE);
    return TRUE;
}

#else

extern "C" void on_interrupt(int signal_number) {
    const int pipe_end = passing_pipe.exchange(-1);
    if (pipe_end >= 0) {
        passed_at = Clock::now();
        const auto number = static_cast<unsigned char>(signal_number);
        if (write(pipe_end, &number, 1) == 1) return;
        passed_at = never;
    }
    if (!is_passed_already()) end_unless_unfinished(signal_number);
}

void handle_unless_ignored(int signal_number) {
    if (std::signal(signal_number, on_interrupt) == SIG_IGN) std::signal(signal_number, SIG_IGN);
}

#endif

}  // namespace

void install_interrupt_handlers() {
#ifdef _WIN32
    SetConsoleCtrlHandler(on_event, TRUE);
#else
    handle_unless_ignored(SIGINT);
    handle_unless_ignored(SIGTERM);
    handle_unless_ignored(SIGHUP);
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
#endif
}

void pass_interrupts_to(std::function<void(int)> act) {
#ifdef _WIN32
    const std::lock_guard lock(act_mutex);
    act_once = std::move(act);
#else
    const std::array<int, 2> ends = own_pipe();
    if (ends[0] < 0) return;  // signals go on ending the process
    try {
        std::thread([read_end = ends[0], act = std::move(act)] {
            unsigned char number = 0;
            if (uninterrupted([&] { return read(read_end, &number, 1); }) == 1) act(number);
        }).detach();
    } catch (const std::system_error&) {  // the system allows no more threads: likewise
        for (const int pipe_end : ends) close(pipe_end);
        return;
    } catch (...) {
        for (const int pipe_end : ends) close(pipe_end);
        throw;
    }
    passing_pipe = ends[1];
#endif
}

void end_interrupted(int signal_number) {
    end_unless_unfinished(signal_number);
    while (true) std::this_thread::sleep_for(std::chrono::hours(1));
}

Unfinished::Unfinished() {
    if (unfinished++ == 0 && interruption != 0) end();
}

Unfinished::~Unfinished() {
    if (--unfinished == 0 && interruption != 0) end();
}

void set_progress_bar_shown(bool shown) { progress_bar_shown = shown; }

}  // namespace sphereview
