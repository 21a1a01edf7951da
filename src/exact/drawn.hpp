// A scene as both renderers take it: floats relative to the eye, without what can never be seen.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "exact/filter.hpp"
#include "exact/rays.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Spheres in file order, without those that are hidden and without each that equals an earlier one in centre and radius
// (of equal hits the first is seen, so it never is). Renderers write indices into these vectors.
struct DrawnSpheres {
    // x, y, z: the centre relative to the eye, subtracted in double, times 2^scale. w: the radius likewise; negative when
    // the eye is inside, 0 when it lies exactly on the surface.
    std::vector<glm::vec4> center_radius;
    std::vector<std::int32_t> numbers;  // in the scene; empty when nothing was left out: index i is number i
    int scale = 0;                      // 0 unless the scene is very small or very large
    // The float filter proves nothing about some of the spheres, so every pixel is doubtful.
    bool beyond_float = false;

    std::size_t size() const { return center_radius.size(); }
    std::int32_t number(std::size_t index) const { return numbers.empty() ? static_cast<std::int32_t>(index) : numbers[index]; }
    EyeSide side(std::size_t index) const {
        const float w = center_radius[index].w;
        return w > 0.0F ? EyeSide::outside : w < 0.0F ? EyeSide::inside : EyeSide::on_surface;
    }
};

DrawnSpheres drawn_spheres(const Scene& scene);

// What a float renderer needs besides the spheres.
struct FloatView {
    RayFrame<float> rays;
    float error_scale = 0.0F;   // error_scale(kappa, unit) of exact/filter.hpp
    bool all_doubtful = false;  // the filter proves nothing here
};

// `unit` is the arithmetic's: gpu_unit or float_unit.
FloatView float_view(const DrawnSpheres& drawn, const Camera& camera, PictureSize size, double unit);

}  // namespace sphereview
