#include "support/sha256.hpp"

#include <stdexcept>

#include "support/program.hpp"

namespace sphereview::test {

std::string sha256(std::string_view bytes) {
    const std::string sum = run({.arguments = {"sha256sum"}, .program = "/usr/bin/env", .input = std::string(bytes)}).output;
    if (sum.find(' ') != 64) throw std::runtime_error("sha256sum gives no sum: " + sum);
    return sum.substr(0, 64);
}

}  // namespace sphereview::test
