// Random numbers that are the same on every machine; the standard's distributions are not.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>

namespace sphereview::oracle {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    std::uint64_t bits() { return engine_(); }
    // In [0, 1).
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    glm::dvec3 in_cube(double half_side) {
        const double x = between(-half_side, half_side);
        const double y = between(-half_side, half_side);
        return {x, y, between(-half_side, half_side)};
    }
    // In low .. high, both included.
    int whole(int low, int high) { return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1)); }
    bool chance(double probability) { return unit() < probability; }
    // Any size alike: the logarithm is uniform. Both > 0.
    double of_size(double low, double high) { return std::exp2(between(std::log2(low), std::log2(high))); }

private:
    std::mt19937_64 engine_;
};

}  // namespace sphereview::oracle
