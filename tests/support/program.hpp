// Running the shipped program, or another, as a person's shell would.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sphereview::test {

// Where the program's standard output goes.
enum class StandardOutput { captured, closed_pipe, full_disk };

using Environment = std::vector<std::pair<std::string, std::optional<std::string>>>;

// The words, and behind them others.
std::vector<std::string> all_words(std::vector<std::string> words, const std::vector<std::string>& more);

struct Command {
    std::vector<std::string> arguments;
    std::string program = "";       // "": the sphereview that this build made
    std::string folder = ".";       // where it runs
    std::string input = "";         // its standard input, through a pipe
    bool input_stays_open = false;  // until Running::close_input()
    // Changes to the environment; nothing removes a variable. SPHEREVIEW_BACKEND is removed unless it is named here.
    Environment environment = {};
    StandardOutput output = StandardOutput::captured;
    bool errors_to_terminal = false;      // standard error is a terminal
    bool obeys_permissions = false;       // also when the tests run as root
    bool ignores_interrupts = false;      // SIGINT is ignored when the program starts, as in a shell's background job
    rlim_t largest_file = RLIM_INFINITY;  // bytes that a file may grow to
    rlim_t most_memory = RLIM_INFINITY;   // bytes of address space
};

// How it ended. Exactly one of: an exit status, a signal, out of time (then it was killed).
struct Outcome {
    int status = -1;
    int signal = 0;
    bool out_of_time = false;
    std::string output;
    std::string errors;
};

// For messages of failed expectations.
std::ostream& operator<<(std::ostream& stream, const Outcome& outcome);

// A program that is running. Destruction kills it if it still does.
class Running {
public:
    // Returns when the program has started.
    explicit Running(const Command& command);
    ~Running();
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    void send(int signal_number) const;

    // Ends the program's input, after all of it was taken.
    void close_input();

    // Collects output until `text` has appeared so many times in standard error; false when the program ends or time runs
    // out first.
    bool wait_for_errors(const std::string& text, int times = 1);

    // Whether it has ended by itself; wait() says how.
    bool has_ended();

    // What standard error held so far, as far as a wait has collected it.
    const std::string& errors_so_far() const { return outcome_.errors; }

    // What it has used of the processors so far, in seconds (Linux).
    double processor_seconds() const;

    // Ends the input and, from the first time that the program reads it, lets it enter or leave so many system calls; then
    // it stands still until resume_with(). False when it ended before that. Only for a program of one thread whose input is
    // still open and that prints less than a pipe holds.
    bool stop_after_system_calls(int count);
    void resume_with(int signal_number) const;

    // Collects output until the program ends, then says how; kills it after a time that no healthy run needs.
    Outcome wait();

private:
    bool collect();
    void drop(int& descriptor);

    pid_t process_ = 0;
    std::optional<int> ended_;  // what waitpid said, if it was asked already
    int input_ = -1;
    int output_ = -1;
    int errors_ = -1;
    bool input_stays_open_;
    std::string unwritten_input_;
    Outcome outcome_;
};

// Starts a program and waits for its end.
Outcome run(const Command& command);

// Runs sphereview with these arguments and changes to the environment.
Outcome run(std::vector<std::string> arguments, Environment environment = {});

}  // namespace sphereview::test
