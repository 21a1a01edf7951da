// Rays of a camera as lines in space.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "panels/rays_panel.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// The most rays that are drawn at once: more could not be told apart, nor drawn quickly.
inline constexpr std::size_t most_rays = 4000;

// The pixels whose rays are drawn: those that stand for the squares of a coarse picture (tiles/pixel_range.hpp), or those of the
// given row. None for RaysShown::one.
std::vector<Pixel> pixels_of_rays(PictureSize size, const RayChoice& choice, int row);

// The least RayChoice::every with at most most_rays rays, and the one for a good drawing.
int least_every(PictureSize size, RaysShown shown);
int usual_every(PictureSize size, RaysShown shown);

struct TracedRay {
    Pixel pixel;
    std::int32_t visible = 0;  // the number of the sphere at its end, or visible_background
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0};
};

// Traces the rays of some pixels, on all cores. The first sphere of a ray is decided exactly; the hit is the exact point, rounded
// once. A ray that hits nothing ends at `far_depth`, as of depth_of().
std::vector<TracedRay> trace_rays(const Scene& scene, const Camera& camera, PictureSize size, std::span<const Pixel> pixels,
                                  double far_depth);

}  // namespace sphereview
