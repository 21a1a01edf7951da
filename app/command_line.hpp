// The command line as typed -> the command to run.
#pragma once

#include <functional>

#include "app/failure.hpp"

namespace sphereview {

// Runs a command; returns the exit status, or throws before it has done anything.
using Run = std::function<ExitCode()>;

// Reads the command line and SPHEREVIEW_BACKEND. Throws InputError with one line that says what is wrong.
Run parse_command_line(int argc, const char* const* argv);

}  // namespace sphereview
