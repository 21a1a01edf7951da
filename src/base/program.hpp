// Starts other programs.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace sphereview {

// The program's file in the folders of PATH, as a shell would find it; "" for none.
std::string find_program(const std::string& name);

// How a program ended.
struct ProgramResult {
    enum class End { returned, timed_out, crashed, exited };

    End end = End::returned;  // exited: with a status other than 0, or without output
    unsigned code = 0;        // the signal's number (on Windows the exception's) or the exit status
    std::string output{};     // its standard output
    std::string errors{};     // its standard error
};

// A program that reads from a pipe.
class PipedProgram {
public:
    // Starts the program at `path` and discards its standard output. Throws OutputError if it cannot be started.
    PipedProgram(const std::string& path, const std::vector<std::string>& arguments);
    // Kills it, unless it has ended.
    ~PipedProgram();
    PipedProgram(const PipedProgram&) = delete;
    PipedProgram& operator=(const PipedProgram&) = delete;

    // False if the program has ended.
    bool write(std::string_view bytes);
    // Closes the input and waits for the program's end. Returns whether its status is 0. A second call returns the same.
    bool finish();
    // After finish(): how the program ended, without its output.
    const ProgramResult& result() const { return result_; }
    // From any thread.
    void kill();
    // After finish(): the beginning of its standard error.
    const std::string& errors() const { return errors_; }

private:
    std::unique_ptr<class ProgramProcess> process_;
    std::string errors_{};
    ProgramResult result_{};
    std::thread reader_{};  // of its errors; declared last: it uses the members above
};

// Runs the program at `path` and waits for it; kills it after `limit`. Its standard input is empty and is closed when this process
// ends in any way, so that end_with_input() ends the program, too. Throws OutputError if it cannot be started.
ProgramResult run_program(const std::string& path, const std::vector<std::string>& arguments, std::chrono::milliseconds limit);

// From now on this process ends when its standard input does.
void end_with_input();

}  // namespace sphereview
