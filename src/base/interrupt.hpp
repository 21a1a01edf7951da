// Interruptions by a person or the system, which must leave nothing unfinished behind.
#pragma once

#include <functional>

namespace sphereview {

// From now on SIGINT, SIGTERM and SIGHUP (on Windows Ctrl+C, and the end of the console or the session) clear the progress bar and
// end the process at once with status 128 + signal, wherever it is, also inside a driver. A signal that was ignored stays ignored.
// Writing beyond a file-size limit or to a closed pipe becomes an ordinary error. Call once, at the start of main.
void install_interrupt_handlers();

// From now on calls `act` with the number of the first of these signals, on a thread of its own, so that a program can keep unsaved
// work. A signal a second later or more ends the process as above; earlier ones are ignored as repetitions. Call once.
void pass_interrupts_to(std::function<void(int)> act);

// For `act`: ends the process as above, once no Unfinished lives. The caller must hold no lock that one of these waits for.
[[noreturn]] void end_interrupted(int signal_number);

// Interruptions wait for the end of such an object, so that its work is finished. For a few milliseconds of work, on any thread.
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
