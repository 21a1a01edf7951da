// The errors that a person can cause or meet, each with an exit status (app/failure.hpp). A programmer's mistake asserts.
#pragma once

#include <stdexcept>
#include <string>

namespace sphereview {

// The command line, an option's value, a scene or a golden image is wrong. The message is complete:
// "FILE:LINE:COLUMN: what was found, what was expected" for a scene.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A file that cannot be read or written, and why: in words that follow its name, and as an errno.
struct FileFault {
    std::string file;
    std::string why;
    int number;
};

// An input file cannot be read at all, whatever its content.
struct ReadError : InputError {
    ReadError(const std::string& file, const std::string& why, int number)
        : InputError(file + ": cannot be read: " + why), fault{file, "cannot be read: " + why, number} {}

    FileFault fault;
};

// Why a renderer does not work, as far as a person can do something about it.
enum class RenderFault { other, no_library, no_driver, old_opengl, little_memory, no_answer, crash, exit };

// Nothing here can render what was asked, and why.
struct RenderError : std::runtime_error {
    explicit RenderError(const std::string& why, RenderFault what = RenderFault::other) : std::runtime_error(why), fault(what) {}

    RenderFault fault;
};

// What was asked does not fit in memory; the message has the figures.
struct MemoryError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// An output could not be written, and why.
struct OutputError : std::runtime_error {
    OutputError(const std::string& file, const std::string& why, int number)
        : std::runtime_error(file + ": cannot be written: " + why), fault{file, "cannot be written: " + why, number} {}

    FileFault fault;
};

}  // namespace sphereview
