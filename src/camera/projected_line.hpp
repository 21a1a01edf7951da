// Lines of the scene in a picture: the part of each that the picture can show.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "scene/camera.hpp"

namespace sphereview {

// A straight line in a picture. Places are pixels from the top left corner; depths as of depth_of().
struct ProjectedLine {
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
    double from_depth = 1.0;
    double to_depth = 1.0;
    Projection projection = Projection::perspective;

    glm::dvec2 place_at(double part) const { return (1.0 - part) * from + part * to; }
    // How deep the point lies that the picture shows at place_at(part).
    double depth_at(double part) const;
    // Its length in the picture, in pixels.
    double pixels() const;
};

// The line from one point of the scene to another as a picture shows it: without what lies behind the eye (or, for parallel rays,
// behind the plane that they begin in), where a projection would turn it round, and without what lies beyond the picture's edges by
// more than `margin` of the picture's size. Nothing where nothing is left.
std::optional<ProjectedLine> projected_line(const Camera& camera, PictureSize size, const glm::dvec3& from, const glm::dvec3& to,
                                            double margin = 0.05);

}  // namespace sphereview
