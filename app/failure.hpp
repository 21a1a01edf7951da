// The message and the exit status for an error.
#pragma once

#include <string>

namespace sphereview {

// The program's exit statuses, documented in --help and docs/command-line.md. Of several the highest counts; 128 + signal when
// interrupted (base/interrupt.hpp).
enum class ExitCode : int {
    done = 0,
    differs = 1,      // the picture differs from the expected one
    bad_input = 2,    // wrong usage, a bad scene, a broken golden image
    no_renderer = 3,  // nothing here could render, or memory ran out
    no_output = 4,    // the output could not be written
};

struct Failure {
    ExitCode code = ExitCode::done;
    std::string message;  // one line, or a shader's log; safe to print
};

// Translates the exception being handled; call inside a catch. `scene`: the scene being rendered, if any, which begins messages
// that name no file.
Failure describe_current_exception(const std::string& scene = "");

// Says that memory ran out and ends the program: a handler for `new`, where nothing catches exceptions.
[[noreturn]] void end_without_memory();

}  // namespace sphereview
