#include "support/folders.hpp"

namespace sphereview::test {

std::string source_file(const std::string& name) { return SOURCE_DIR "/" + name; }
std::string build_file(const std::string& name) { return BINARY_DIR "/" + name; }

}  // namespace sphereview::test
