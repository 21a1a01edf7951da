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

// How deep, as of depth_of(), the ray through a place of the picture first meets the sphere in front of where it begins; nothing
// where it does not.
std::optional<double> hit_depth(const Camera& camera, PictureSize size, const glm::dvec2& place, const Sphere& sphere);

// Which sphere is in front is what the tracer has found for the picture: its numbers of visible spheres are asked, so that a line
// costs the same in front of four spheres and of a million. How deep that sphere is, its quadratic says. What is passed in must
// outlive it.
class HiddenParts {
public:
    HiddenParts(const Scene& scene, const Camera& view, PictureSize size, const SeenTexels& seen)
        : scene_(scene), view_(view), size_(size), seen_(seen) {}

    // Whether what lies that deep at a place of the picture is behind a sphere.
    bool hides(const glm::dvec2& place, double depth) const;

    // Calls run(begin, end, hidden) for the parts of a line that are wholly hidden or wholly not, in order; looked at in steps of
    // so many pixels. The first begins at 0, the last ends at 1.
    void for_each_run(const ProjectedLine& line, double step,
                      const std::function<void(double begin, double end, bool hidden)>& run) const;

private:
    // The number of the visible sphere; visible_background beside the picture, too.
    std::int32_t seen_at(const glm::dvec2& place) const;

    const Scene& scene_;
    const Camera& view_;
    PictureSize size_;
    const SeenTexels& seen_;
};

}  // namespace sphereview
