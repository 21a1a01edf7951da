// The visible parts of lines of the scene in a picture.
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
    // The depth of the point that the picture shows at place_at(part).
    double depth_at(double part) const;
    // The length in the picture, in pixels.
    double pixels() const;
};

// A line of the scene as a picture shows it, without the parts behind the eye (or, for parallel rays, behind the plane in which
// they begin), which a projection would turn round, and without the parts outside the picture by more than `margin` of its size.
// Nothing if nothing is left.
std::optional<ProjectedLine> projected_line(const Camera& camera, PictureSize size, const glm::dvec3& from, const glm::dvec3& to,
                                            double margin = 0.05);

}  // namespace sphereview
