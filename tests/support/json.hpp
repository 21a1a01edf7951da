// JSON as the program prints it.
#pragma once

#include <nlohmann/json.hpp>

// json.cpp has its code: a parser in each test's file would take most of the time that the tests compile.
extern template class nlohmann::basic_json<>;

namespace sphereview::test {

using Json = nlohmann::json;

}  // namespace sphereview::test
