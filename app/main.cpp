// The program's entry and its last catch-all: errors become one line on stderr and the documented exit status.
#include <cstdio>
#include <new>

#include "app/command_line.hpp"
#include "app/failure.hpp"
#include "base/interrupt.hpp"
#include "base/standard_streams.hpp"

namespace {

using namespace sphereview;

#ifdef __GNUC__
// Libraries make constants before main(), where nothing would catch that memory runs out.
// 101: the first that a program may have.
__attribute__((constructor(101))) void expect_no_memory() { std::set_new_handler(end_without_memory); }
#endif

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
    std::set_new_handler(nullptr);
    install_interrupt_handlers();
    prepare_console();
    const int status = run_command_line(argc, argv);
    restore_console();
#ifndef __SANITIZE_ADDRESS__
    // All output is written and checked; what drivers do at exit takes milliseconds and is where they crash.
    // Not all streams: a thread may still wait for standard input, with a lock on it.
    std::fflush(stdout);
    std::fflush(stderr);
    std::_Exit(status);
#endif
    return status;  // by way of the leak check
}
