// A scene in the form for both renderers: floats relative to the eye, without spheres that can never be seen.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <unordered_map>
#include <vector>

#include "exact/filter.hpp"
#include "exact/rays.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Spheres in file order, without hidden ones and without those that equal an earlier one in centre and radius, which are never seen
// because the first of equal hits is. Renderers write indices into these vectors.
struct DrawnSpheres {
    // x, y, z: the centre relative to the eye, subtracted in double, times 2^scale. w: the radius likewise; negative when
    // the eye is inside or, in an orthographic picture, the sphere meets the plane that rays begin in; 0 when the eye lies exactly
    // on the surface. All 0: beyond float, see below.
    std::vector<glm::vec4> center_radius;
    std::vector<std::int32_t> numbers;  // in the scene, ascending; empty if index i is number i
    std::vector<std::int32_t> twins;    // the numbers of spheres that equal an earlier one, ascending
    int scale = 0;                      // 0 unless most of the scene is very small or very large
    bool orthographic = false;          // relative to such an eye
    // The spheres too small or large for the float filter. They are uploaded as zeros, for which the filter finds "perhaps hit, at
    // 0 or farther": every pixel that tries one is doubtful.
    std::unordered_map<std::uint32_t, EyeSide> beyond_float;

    // Traces of edits (tiles/live_lists.cpp). A sphere keeps its index; removed ones leave gaps. There is room for so many added
    // spheres.
    static constexpr std::size_t room_for_late = 4096;
    std::vector<std::uint32_t> gone;  // the gaps, ascending; in no list
    std::size_t late = 0;             // so many at the end were added: their numbers are in no order

    std::size_t size() const { return center_radius.size(); }
    std::int32_t number(std::size_t index) const { return numbers.empty() ? static_cast<std::int32_t>(index) : numbers[index]; }
    // The index of a drawn sphere; nothing for one that was left out.
    std::optional<std::size_t> index_of(std::uint32_t number) const;
    // The eye's side of a sphere, also of one beyond float.
    EyeSide side(std::size_t index) const;
};

DrawnSpheres drawn_spheres(const Scene& scene);
// By another camera than the scene's; only its eye matters (see same_eye()).
DrawnSpheres drawn_spheres(const Scene& scene, const Camera& camera);
// By another eye than `drawn`, which is of the same scene without edits. Which spheres can be seen does not depend on the eye.
DrawnSpheres drawn_again(const Scene& scene, const Camera& camera, const DrawnSpheres& drawn);

// Whether drawn spheres are the same for both cameras: the eyes, and for orthographic cameras the planes through the eye, are.
bool same_eye(const Camera& a, const Camera& b);

// The sphere's DrawnSpheres::center_radius; nothing for a sphere beyond float.
std::optional<glm::vec4> drawn_form(const Sphere& sphere, const Camera& camera, int scale);

// A float renderer's data besides the spheres.
struct FloatView {
    RayBasis<float> rays;
    float error_scale = 0.0F;   // error_scale(kappa, unit) of exact/filter.hpp
    bool all_doubtful = false;  // the filter proves nothing here
};

// `unit` is the arithmetic's: gpu_unit or float_unit. `scale`: the drawn spheres'.
FloatView float_view(const Camera& camera, PictureSize size, int scale, double unit);

}  // namespace sphereview
