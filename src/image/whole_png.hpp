// Finds out whether a picture exists already.
#pragma once

#include <string>

namespace sphereview {

// Whether `path` is a PNG of that size that is not cut off: it has a PNG's head and end; what is between is not read. False for
// unreadable files.
bool is_whole_png(const std::string& path, int width, int height);

}  // namespace sphereview
