// The command line as typed -> options.
#pragma once

#include "app/options.hpp"

namespace sphereview {

// Reads the command line and SPHEREVIEW_BACKEND. Throws InputError with one line that says what is wrong.
Command parse_command_line(int argc, const char* const* argv);

// "1000x1000" or "1000,1000" as a size; both sides at least 1, together at most most_pixels. Throws InputError.
PictureSize parse_size(const std::string& text);

}  // namespace sphereview
