// Compares a renderer's picture with the oracle's.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "oracle/scenes.hpp"

namespace sphereview::oracle {

// "" where both are the same; else how many pixels differ, the first of them with both answers, and the scene.
std::string difference(const Trial& trial, const std::string& source, const std::vector<std::int32_t>& expected,
                       const std::vector<std::int32_t>& found);

}  // namespace sphereview::oracle
