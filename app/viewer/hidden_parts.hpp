// Which parts of lines in space lie behind the spheres of a picture.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>

#include "camera/projected_line.hpp"
#include "gpu/live_picture.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// The depth, as of depth_of(), at which the ray through a place of the picture first meets the sphere; nothing where the ray misses
// it.
std::optional<double> hit_depth(const Camera& camera, PictureSize size, const glm::dvec2& place, const Sphere& sphere);

// Takes the visible sphere of each pixel from the traced picture, so a line costs the same before four spheres and a million, and
// the sphere's depth from its quadratic. The references must outlive this object.
class HiddenParts {
public:
    HiddenParts(const Scene& scene, const Camera& view, PictureSize size, const SeenTexels& seen)
        : scene_(scene), view_(view), size_(size), seen_(seen) {}

    // Whether a sphere hides a point at this depth and place of the picture.
    bool hides(const glm::dvec2& place, double depth) const;

    // Calls run(begin, end, hidden) in order for the hidden and the visible parts of a line, from 0 to 1, tested every `step`
    // pixels.
    void for_each_run(const ProjectedLine& line, double step,
                      const std::function<void(double begin, double end, bool hidden)>& run) const;

private:
    // The number of the visible sphere; visible_background also outside the picture.
    std::int32_t seen_at(const glm::dvec2& place) const;

    const Scene& scene_;
    const Camera& view_;
    PictureSize size_;
    const SeenTexels& seen_;
};

}  // namespace sphereview
