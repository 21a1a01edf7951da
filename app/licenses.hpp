// The licences of this program and of the libraries in it.
#pragma once

#include <string>

namespace sphereview {

// Written by packaging/parts.py when the program is built, without an end of line behind the last line.
std::string licenses();

}  // namespace sphereview
