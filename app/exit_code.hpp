// The program's exit statuses, as documented in --help and the README.
#pragma once

namespace sphereview {

// Of several the highest counts; 128 + signal when interrupted (base/interrupt.hpp).
enum class ExitCode : int {
    done = 0,
    differs = 1,      // the picture differs from the expected one
    bad_input = 2,    // wrong usage, a bad scene, a broken golden image
    no_renderer = 3,  // nothing here could render, or memory ran out
    no_output = 4,    // the output could not be written
};

}  // namespace sphereview
