// A scene as both renderers take it: floats relative to the eye, without what can never be seen.
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

// Spheres in file order, without those that are hidden and without each that equals an earlier one in centre and radius
// (of equal hits the first is seen, so it never is). Renderers write indices into these vectors.
struct DrawnSpheres {
    // x, y, z: the centre relative to the eye, subtracted in double, times 2^scale. w: the radius likewise; negative when
    // the eye is inside or, in an orthographic picture, the sphere meets the plane that rays begin in; 0 when the eye lies exactly
    // on the surface. All 0: beyond float, see below.
    std::vector<glm::vec4> center_radius;
    std::vector<std::int32_t> numbers;  // in the scene, ascending; empty when nothing was left out: index i is number i
    std::vector<std::int32_t> twins;    // the numbers of those that equal an earlier one, ascending
    int scale = 0;                      // 0 unless most of the scene is very small or very large
    bool orthographic = false;          // seen by such an eye
    // The spheres so small or large that the float filter proves nothing about them. They are uploaded as zeros, for which the
    // filter finds "perhaps hit, at 0 or farther": every pixel that tries one is doubtful.
    std::unordered_map<std::uint32_t, EyeSide> beyond_float;

    // What edits leave behind (tiles/live_lists.cpp). An index stays a sphere's own; those that went leave a gap. There is room in
    // memory for so many that come.
    static constexpr std::size_t room_for_late = 4096;
    std::vector<std::uint32_t> gone;  // the gaps, ascending; in no list
    std::size_t late = 0;             // so many at the end came later: their numbers are in no order

    std::size_t size() const { return center_radius.size(); }
    std::int32_t number(std::size_t index) const { return numbers.empty() ? static_cast<std::int32_t>(index) : numbers[index]; }
    // The place of a sphere that is drawn; none for one that was left out.
    std::optional<std::size_t> index_of(std::uint32_t number) const;
    // The eye's side of a sphere, also of one that is beyond float.
    EyeSide side(std::size_t index) const;
};

DrawnSpheres drawn_spheres(const Scene& scene);
// As another camera than the scene's sees them; only its eye matters (see same_eye()).
DrawnSpheres drawn_spheres(const Scene& scene, const Camera& camera);
// As another eye sees those that were drawn of the same scene, without any edits. Which spheres can be seen does not depend on it.
DrawnSpheres drawn_again(const Scene& scene, const Camera& camera, const DrawnSpheres& drawn);

// Whether the drawn spheres are the same for both: the eye, and of an orthographic camera the plane through it.
bool same_eye(const Camera& a, const Camera& b);

// One of DrawnSpheres::center_radius; none for a sphere that is beyond float.
std::optional<glm::vec4> drawn_form(const Sphere& sphere, const Camera& camera, int scale);

// What a float renderer needs besides the spheres.
struct FloatView {
    RayBasis<float> rays;
    float error_scale = 0.0F;   // error_scale(kappa, unit) of exact/filter.hpp
    bool all_doubtful = false;  // the filter proves nothing here
};

// `unit` is the arithmetic's: gpu_unit or float_unit. `scale`: the drawn spheres'.
FloatView float_view(const Camera& camera, PictureSize size, int scale, double unit);

}  // namespace sphereview
