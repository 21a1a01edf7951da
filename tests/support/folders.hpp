// Where this checkout and its build are.
#pragma once

#include <string>

namespace sphereview::test {

// A file of the repository, as an absolute path; `name` as in "scenes/input1.txt".
std::string source_file(const std::string& name);

// A file of the build's folder.
std::string build_file(const std::string& name);

}  // namespace sphereview::test
