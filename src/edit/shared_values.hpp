// What several spheres have in common, and finding those that have something in common.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/sphere.hpp"

namespace sphereview {

// The numbers of a sphere that a slider changes.
enum class SphereValue { x, y, z, radius };

inline double& value_of(Sphere& sphere, SphereValue value) {
    return value == SphereValue::radius ? sphere.radius : sphere.center[static_cast<int>(value)];
}
inline double value_of(const Sphere& sphere, SphereValue value) {
    return value == SphereValue::radius ? sphere.radius : sphere.center[static_cast<int>(value)];
}

struct SharedValues {
    struct Range {
        double low = 0.0;
        double high = 0.0;
    };

    std::size_t count = 0;
    std::array<Range, 4> ranges{};  // of each SphereValue; low == high where all have the same
    std::optional<Color> color;     // that all have
    std::size_t hidden = 0;         // how many are

    const Range& range(SphereValue value) const { return ranges[static_cast<std::size_t>(value)]; }
};

// Of the spheres with these numbers, which `spheres` has.
SharedValues shared_values(const std::vector<Sphere>& spheres, const std::vector<std::uint32_t>& numbers);

// Every sphere that has the colour of one of those; ascending.
std::vector<std::uint32_t> colored_like(const std::vector<Sphere>& spheres, const std::vector<std::uint32_t>& numbers);

// Every hidden sphere; ascending.
std::vector<std::uint32_t> hidden_ones(const std::vector<Sphere>& spheres);

}  // namespace sphereview
