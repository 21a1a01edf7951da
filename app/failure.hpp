// What a person is told of an error, and the exit status it gives.
#pragma once

#include <string>

#include "app/exit_code.hpp"

namespace sphereview {

struct Failure {
    ExitCode code = ExitCode::done;
    std::string message;  // one line, or a shader's log
};

// Translates the exception being handled; call inside a catch.
Failure describe_current_exception();

}  // namespace sphereview
