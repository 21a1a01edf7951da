// False colours that tell spheres apart.
#pragma once

#include <cstdint>

#include "scene/sphere.hpp"

namespace sphereview {

// Of the sphere of that number in the file. Integers only. Consecutive numbers are a golden section of the circle of hues apart;
// brightness and saturation differ too. No channel is below 30: no sphere is as dark as a black background.
constexpr Color id_color(std::uint32_t number) {
    const std::uint32_t around = number * 2654435769U;  // 2^32 / golden ratio
    const std::uint32_t hue = (around >> 16) * 6;       // 65,536 to each sixth of the circle
    const std::uint32_t mixed = (number ^ (number >> 7)) * 2246822519U;
    const std::uint32_t high = 255 - 45 * ((mixed >> 20) % 3);  // 255, 210, 165
    const std::uint32_t low = (mixed >> 24) % 2 == 0 ? 30 : 85;
    const std::uint32_t part = ((hue & 65535U) * (high - low)) >> 16;
    const auto h = static_cast<std::uint8_t>(high);
    const auto l = static_cast<std::uint8_t>(low);
    const auto up = static_cast<std::uint8_t>(low + part);
    const auto down = static_cast<std::uint8_t>(high - part);
    switch (hue >> 16) {
        case 0: return {h, up, l};
        case 1: return {down, h, l};
        case 2: return {l, h, up};
        case 3: return {l, down, h};
        case 4: return {up, l, h};
        default: return {h, l, down};
    }
}

}  // namespace sphereview
