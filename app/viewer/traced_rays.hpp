// Rays of a camera as lines in space: from where each begins to where it ends.
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

// As many as are drawn at once: more are neither seen apart nor quickly drawn.
inline constexpr std::size_t most_rays = 4000;

// The pixels whose rays are drawn: those that stand for the squares of a coarse picture (tiles/pixel_range.hpp), or of the row
// alone, which is in the picture. None for RaysShown::one.
std::vector<Pixel> pixels_of_rays(PictureSize size, const RayChoice& choice, int row);

// The least RayChoice::every() with which there are at most most_rays, and the one that makes a good drawing.
int least_every(PictureSize size, RaysShown shown);
int usual_every(PictureSize size, RaysShown shown);

struct TracedRay {
    Pixel pixel;
    std::int32_t visible = 0;  // the number of the sphere that it ends on, or visible_background
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0};
};

// Traces the rays of some pixels of a picture, on all cores: which sphere a ray hits first is decided exactly, and where is the
// exact point rounded once to the nearest doubles. A ray that hits nothing ends at `far_depth`, as of depth_of(). Of the scene only
// the spheres matter.
std::vector<TracedRay> trace_rays(const Scene& scene, const Camera& camera, PictureSize size, std::span<const Pixel> pixels,
                                  double far_depth);

}  // namespace sphereview
