// The program's entry and its only catch-all: errors become one line on stderr and the documented exit status.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <variant>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/failure.hpp"
#include "base/input_file.hpp"
#include "base/interrupt.hpp"
#include "base/output_file.hpp"

namespace {

using namespace sphereview;

ExitCode run(const ViewOptions& options) { return run_view(options); }
ExitCode run(const RenderOptions& options) { return run_render(options); }
ExitCode run(const ConvertOptions& options) { return run_convert(options); }
ExitCode run(const ExplainOptions& options) { return run_explain(options); }
ExitCode run(const DoctorOptions& options) { return run_doctor(options); }
ExitCode run(const PrintText& command) {
    write_output(std::string(standard_stream), command.text);
    return ExitCode::done;
}

}  // namespace

namespace {

int run_command_line(int argc, char** argv) {
    try {
        const Command command = parse_command_line(argc, argv);
        return static_cast<int>(std::visit([](const auto& options) { return run(options); }, command));
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
