// Other programs, started by this one.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace sphereview {

// The file of the program of that name in the folders of PATH, as a shell would find it; "" where there is none.
std::string find_program(const std::string& name);

// How a program ended that was waited for.
struct ProgramResult {
    enum class End { returned, timed_out, crashed, exited };

    End end = End::returned;  // exited: with another status than 0, or it wrote nothing
    unsigned code = 0;        // the signal's number (on Windows the exception's) or the exit status
    std::string output{};     // what it wrote to standard output
    std::string errors{};     // and to standard error
};

// A program that takes what is written to it.
class PipedProgram {
public:
    // Starts the program at `path`. Its standard output is thrown away. Throws OutputError that it cannot be started.
    PipedProgram(const std::string& path, const std::vector<std::string>& arguments);
    // Kills it, unless it has ended.
    ~PipedProgram();
    PipedProgram(const PipedProgram&) = delete;
    PipedProgram& operator=(const PipedProgram&) = delete;

    // False when it takes no more, for it has ended.
    bool write(std::string_view bytes);
    // Ends its input and waits for its end; whether it says that it has done its work. A second call returns the same.
    bool finish();
    // How it ended, after finish(); without what it wrote.
    const ProgramResult& result() const { return result_; }
    // From any thread.
    void kill();
    // What it wrote to standard error, after finish(): the beginning.
    const std::string& errors() const { return errors_; }

private:
    std::unique_ptr<class ProgramProcess> process_;
    std::string errors_{};
    ProgramResult result_{};
    std::thread reader_{};  // of its errors; last: it uses what is above
};

// Runs the program at `path` and waits for it; kills it after `limit`. Its standard input is empty, and ends when this process
// does, however that ends: end_with_input() then ends the program, too. Throws OutputError that it cannot be started.
ProgramResult run_program(const std::string& path, const std::vector<std::string>& arguments, std::chrono::milliseconds limit);

// From now on this process ends when its standard input does.
void end_with_input();

}  // namespace sphereview
