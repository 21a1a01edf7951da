#include "edit/shared_values.hpp"

#include <algorithm>
#include <cfloat>

namespace sphereview {

namespace {

std::size_t place_of(const Color& color) {
    return (std::size_t{color.r} << 16U) + (std::size_t{color.g} << 8U) + std::size_t{color.b};
}

}  // namespace

SharedValues shared_values(const std::vector<Sphere>& spheres, const std::vector<std::uint32_t>& numbers) {
    SharedValues shared;
    shared.count = numbers.size();
    if (numbers.empty()) return shared;
    const Sphere& first = spheres[numbers.front()];
    shared.ranges.fill({DBL_MAX, -DBL_MAX});
    bool one_color = true;
    for (const std::uint32_t number : numbers) {
        const Sphere& sphere = spheres[number];
        for (std::size_t i = 0; i < shared.ranges.size(); ++i) {
            const double value = value_of(sphere, static_cast<SphereValue>(i));
            shared.ranges[i].low = std::min(shared.ranges[i].low, value);
            shared.ranges[i].high = std::max(shared.ranges[i].high, value);
        }
        one_color = one_color && sphere.color == first.color;
        if (sphere.hidden) ++shared.hidden;
    }
    if (one_color) shared.color = first.color;
    return shared;
}

std::vector<std::uint32_t> colored_like(const std::vector<Sphere>& spheres, const std::vector<std::uint32_t>& numbers) {
    std::vector<bool> wanted(std::size_t{1} << 24U);  // each colour there is
    for (const std::uint32_t number : numbers) wanted[place_of(spheres[number].color)] = true;
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        if (wanted[place_of(spheres[i].color)]) found.push_back(static_cast<std::uint32_t>(i));
    }
    return found;
}

std::vector<std::uint32_t> hidden_ones(const std::vector<Sphere>& spheres) {
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        if (spheres[i].hidden) found.push_back(static_cast<std::uint32_t>(i));
    }
    return found;
}

}  // namespace sphereview
