// What must not be left behind when a person or the system interrupts the program.
#pragma once

#include <functional>

namespace sphereview {

// From now on SIGINT, SIGTERM and SIGHUP (on Windows Ctrl+C, and the end of the console or the session) clear the progress bar and
// end the process at once with status 128 + signal, wherever it is, also inside a driver. A signal that was ignored stays ignored.
// Writing beyond a file-size limit or to a closed pipe becomes an ordinary error. Call once, at the start of main.
void install_interrupt_handlers();

// From now on the first of these signals is passed to `act`, called with the signal's number on a thread of its own, so that a
// program with unsaved work can keep that; one that comes a second later or more ends the process as above, and those before are
// the same interruption said again. Call once.
void pass_interrupts_to(std::function<void(int)> act);

// For who was passed a signal: ends the process as above, once no Unfinished lives. The caller holds no lock that one of them waits
// for.
[[noreturn]] void end_interrupted(int signal_number);

// While such an object lives, interruptions wait for its end: what is begun is not left unfinished. For a few milliseconds of work,
// and from any thread.
class Unfinished {
public:
    Unfinished();
    ~Unfinished();
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;
};

// Whether a progress bar stands on the terminal's last line.
void set_progress_bar_shown(bool shown);

}  // namespace sphereview
