// SHA-256 by the system's sha256sum, for pictures that are known by their sum.
#pragma once

#include <string>
#include <string_view>

namespace sphereview::test {

// The sum of the bytes as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace sphereview::test
