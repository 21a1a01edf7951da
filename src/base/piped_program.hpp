// Another program that takes what is written to it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace sphereview {

// The file of the program of that name in the folders of PATH, as a shell would find it; "" where there is none.
std::string find_program(const std::string& name);

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
    // Ends its input and waits for its end; whether it says that it has done its work. Again: what it said.
    bool finish();
    // From any thread.
    void kill();
    // What it wrote to standard error, after finish(): the beginning.
    const std::string& errors() const;

private:
    struct Process;
    // On a thread of its own, until the program ends. Throws OutputError, and the program is gone.
    void read_errors(const std::string& path);

    std::unique_ptr<Process> process_;
    bool done_ = false;
};

}  // namespace sphereview
