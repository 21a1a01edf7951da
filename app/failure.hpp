// What a person is told of an error, and the exit status it gives.
#pragma once

#include <string>

#include "app/exit_code.hpp"

namespace sphereview {

struct Failure {
    ExitCode code = ExitCode::done;
    std::string message;  // one line, or a shader's log; safe to print
};

// Translates the exception being handled; call inside a catch. `scene` is the one that was being rendered, if any: errors that do
// not name a file of their own begin with it.
Failure describe_current_exception(const std::string& scene = "");

}  // namespace sphereview
