// The program's entry and its only catch-all: errors become one line on stderr and the documented exit status.
#include <cstdio>
#include <cstdlib>

#include "app/command_line.hpp"
#include "app/failure.hpp"
#include "base/interrupt.hpp"

namespace {

using namespace sphereview;

int run_command_line(int argc, char** argv) {
    try {
        return static_cast<int>(parse_command_line(argc, argv)());
    } catch (...) {
        const Failure failure = describe_current_exception();
        std::fprintf(stderr, "%s\n", failure.message.c_str());
        return static_cast<int>(failure.code);
    }
}

}  // namespace

int main(int argc, char** argv) {
    install_interrupt_handlers();
    const int status = run_command_line(argc, argv);
#ifndef __SANITIZE_ADDRESS__
    // All output is written and checked; what drivers do at exit takes milliseconds and is where they crash.
    // Not all streams: a thread may still wait for standard input, with a lock on it.
    std::fflush(stdout);
    std::fflush(stderr);
    std::_Exit(status);
#endif
    return status;  // by way of the leak check
}
