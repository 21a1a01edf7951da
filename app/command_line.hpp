// The command line as typed -> options.
#pragma once

#include "app/options.hpp"

namespace sphereview {

// Reads the command line and SPHEREVIEW_BACKEND. Throws InputError with one line that says what is wrong.
Command parse_command_line(int argc, const char* const* argv);

}  // namespace sphereview
