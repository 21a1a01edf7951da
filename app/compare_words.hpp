// The result of `compare` in words, for the command and for the window.
#pragma once

#include <string>
#include <vector>

#include "mistakes/diagnosis.hpp"

namespace sphereview {

// For a picture that differs: the likeliest mistake, what speaks for it and against it, and which others it could be, a line each.
// For a picture that is only shaded or smoothed: that it is so.
std::vector<std::string> verdict_in_words(const Diagnosis& diagnosis);

// "pixel 3,4: found 255 0 0 (sphere 2), expected 0 0 255 (sphere 1)"
std::string in_words(const Scene& scene, const DifferingPixel& example);

}  // namespace sphereview
