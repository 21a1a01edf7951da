#include "random_scene.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace sphereview {

namespace {

// Not std::uniform_real_distribution: what it makes of the generator's bits differs between standard libraries.
double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

double radius_of(SceneSet set, std::size_t count) {
    const auto n = static_cast<double>(count);
    return set == SceneSet::volume ? std::clamp(130.0 / std::cbrt(n), 0.3, 60.0) : std::clamp(289.0 / std::sqrt(n), 0.25, 60.0);
}

}  // namespace

std::optional<SceneSet> scene_set_named(std::string_view name) {
    if (name == "volume") return SceneSet::volume;
    if (name == "half") return SceneSet::half;
    return std::nullopt;
}

Scene random_scene(SceneSet set, std::size_t count, std::uint64_t seed) {
    constexpr double near = 200.0;
    constexpr double far = 1000.0;
    constexpr double slope = 0.48;
    std::mt19937_64 random(seed);
    Scene scene;
    scene.spheres.resize(count);
    for (Sphere& sphere : scene.spheres) {
        // A frustum's cross-section grows with z squared, so the cube of z is uniform.
        const double z = std::cbrt(uniform(random, near * near * near, far * far * far));
        const double x = uniform(random, -slope * z, slope * z);
        const double y = uniform(random, -slope * z, slope * z);
        const std::uint64_t bits = random();
        sphere.center = {x, y, z};
        sphere.radius = radius_of(set, count);
        const auto channel = [bits](int shift) { return static_cast<std::uint8_t>(bits >> shift); };
        sphere.color = {channel(0), channel(8), channel(16)};
    }
    return scene;
}

}  // namespace sphereview
