#include "exact/drawn.hpp"

#include <algorithm>
#include <cmath>

namespace sphereview {

std::size_t count_drawn(const Scene& scene) {
    return static_cast<std::size_t>(
        std::count_if(scene.spheres.begin(), scene.spheres.end(), [](const Sphere& s) { return !s.hidden; }));
}

DrawnSpheres drawn_spheres(const Scene& scene) {
    DrawnSpheres drawn;
    const std::size_t count = count_drawn(scene);
    drawn.center_radius.reserve(count);
    if (count != scene.spheres.size()) drawn.numbers.reserve(count);
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere& sphere = scene.spheres[i];
        if (sphere.hidden) continue;
        drawn.center_radius.emplace_back(glm::vec3(sphere.center - scene.camera.eye), static_cast<float>(sphere.radius));
        if (count != scene.spheres.size()) drawn.numbers.push_back(static_cast<std::int32_t>(i));
    }
    return drawn;
}

void to_scene_numbers(const DrawnSpheres& spheres, std::span<std::int32_t> visible) {
    if (spheres.numbers.empty()) return;
    for (std::int32_t& number : visible) {
        if (number >= 0) number = spheres.numbers[static_cast<std::size_t>(number)];
    }
}

RayFrame ray_frame(const Camera& camera, PictureSize size) {
    // A quarter first: the difference of two doubles, or its product with a side's mantissa, may overflow.
    int side_exponent = 0;
    const double side = std::frexp(size.shorter_side(), &side_exponent);
    const glm::dvec3 axis = side * (camera.center * 0.25 - camera.eye * 0.25);
    int exponent = 0;
    std::frexp(std::max({std::fabs(axis.x), std::fabs(axis.y), std::fabs(axis.z)}), &exponent);
    const auto scaled = [](const glm::dvec3& v, int by) {
        return glm::vec3(std::ldexp(v.x, by), std::ldexp(v.y, by), std::ldexp(v.z, by));
    };
    // Only powers of two besides the side's mantissa: for the default camera nothing is rounded.
    const int edges = -exponent - side_exponent - 2;
    return {scaled(axis, -exponent), scaled(camera.right, edges), scaled(camera.up, edges)};
}

}  // namespace sphereview
