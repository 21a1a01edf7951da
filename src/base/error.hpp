// The errors a person can cause or meet. Each type has one exit status (app/exit_code.hpp); a programmer's mistake asserts.
#pragma once

#include <stdexcept>
#include <string>

namespace sphereview {

// The command line, an option's value, a scene or a golden image is wrong. The message is complete:
// "FILE:LINE:COLUMN: what was found, what was expected" for a scene.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Nothing here can render what was asked, and why.
struct RenderError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// What was asked does not fit in memory; the message has the figures.
struct MemoryError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// An output could not be written, and why.
struct OutputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace sphereview
