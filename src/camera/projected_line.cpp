#include "camera/projected_line.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "camera/navigation.hpp"

namespace sphereview {

namespace {

// A point before it is divided by its depth: along the camera's right and up, and what these are divided by.
struct Homogeneous {
    glm::dvec2 across{0.0};
    double divisor = 1.0;
    double depth = 1.0;
};

Homogeneous homogeneous(const Camera& camera, const glm::dvec3& point) {
    Homogeneous found;
    found.depth = depth_of(camera, point);
    found.across = across_screen(camera, (point - camera.eye) - found.depth * (camera.center - camera.eye));
    if (!camera.orthographic()) found.divisor = found.depth;
    return found;
}

// The part of a line, from 0 to 1, that is on the right side of some planes.
class Part {
public:
    // Keeps what is at least 0, of a value that is linear along the line.
    void keep(double at_begin, double at_end) {
        const double rise = at_end - at_begin;
        if (!(at_begin >= 0.0)) begin = at_end > 0.0 ? std::max(begin, -at_begin / rise) : 2.0;
        if (!(at_end >= 0.0)) end = at_begin > 0.0 ? std::min(end, -at_begin / rise) : -1.0;
    }

    double begin = 0.0;
    double end = 1.0;
};

}  // namespace

double ProjectedLine::depth_at(double part) const {
    if (projection == Projection::orthographic) return (1.0 - part) * from_depth + part * to_depth;
    // In a picture the reciprocals of depths are linear.
    return 1.0 / ((1.0 - part) / from_depth + part / to_depth);
}

double ProjectedLine::pixels() const { return glm::distance(from, to); }

std::optional<ProjectedLine> projected_line(const Camera& camera, PictureSize size, const glm::dvec3& from, const glm::dvec3& to,
                                            double margin) {
    const Homogeneous a = homogeneous(camera, from);
    const Homogeneous b = homogeneous(camera, to);
    const double m = size.shorter_side();
    const glm::dvec2 edge = (1.0 + 2.0 * margin) * glm::dvec2(size.width / m, size.height / m);
    Part part;
    // A depth of 0 has no place in the picture.
    const double nearest = 1e-12 * std::max(std::fabs(a.depth), std::fabs(b.depth));
    part.keep(a.depth - nearest, b.depth - nearest);
    for (int axis = 0; axis < 2; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            part.keep(edge[axis] * a.divisor - side * a.across[axis], edge[axis] * b.divisor - side * b.across[axis]);
        }
    }
    if (!(part.begin <= part.end)) return std::nullopt;
    const auto at = [&](double along) {
        const double divisor = (1.0 - along) * a.divisor + along * b.divisor;
        const glm::dvec2 across = ((1.0 - along) * a.across + along * b.across) / divisor;
        return glm::dvec2(0.5 * size.width + 0.5 * m * across.x, 0.5 * size.height - 0.5 * m * across.y);
    };
    const auto depth = [&](double along) { return (1.0 - along) * a.depth + along * b.depth; };
    const ProjectedLine line{at(part.begin), at(part.end), depth(part.begin), depth(part.end), camera.projection};
    const bool finite = std::isfinite(line.from.x) && std::isfinite(line.from.y) && std::isfinite(line.to.x) &&
                        std::isfinite(line.to.y) && line.from_depth > 0.0 && line.to_depth > 0.0;
    return finite ? std::optional(line) : std::nullopt;
}

}  // namespace sphereview
