// Whether a picture is there already.
#pragma once

#include <string>

namespace sphereview {

// Whether `path` is a PNG of that size that is not cut off: it begins with the head of one and ends with the end of one. What lies
// between is not looked at. False for what cannot be read.
bool is_whole_png(const std::string& path, int width, int height);

}  // namespace sphereview
