#include "viewer/hidden_parts.hpp"

#include <algorithm>
#include <cmath>

#include "camera/navigation.hpp"
#include "panels/panel_context.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// A line that ends on a sphere is not hidden by that point of it.
constexpr double on_surface = 1e-7;  // of a depth

}  // namespace

std::optional<double> hit_depth(const Camera& camera, PictureSize size, const glm::dvec2& place, const Sphere& sphere) {
    const glm::dvec3 origin = point_at(camera, size, place, 0.0);
    const glm::dvec3 to_screen = point_at(camera, size, place, 1.0) - origin;
    const glm::dvec3 ray = unit(to_screen);
    const glm::dvec3 to_center = sphere.center - origin;
    // Where the ray is nearest to the centre, and how far that is.
    const double along = dot(to_center, ray);
    const glm::dvec3 beside = to_center - along * ray;
    const double inside = sphere.radius * sphere.radius - dot(beside, beside);
    if (!(inside >= 0.0)) return std::nullopt;
    const double near = along - std::sqrt(inside);
    const double distance = near > 0.0 ? near : along + std::sqrt(inside);
    return distance > 0.0 ? std::optional(distance / length_of(to_screen)) : std::nullopt;
}

std::int32_t HiddenParts::seen_at(const glm::dvec2& place) const {
    if (!(place.x >= 0.0 && place.y >= 0.0 && place.x < size_.width && place.y < size_.height)) return visible_background;
    const std::size_t column = static_cast<std::size_t>(place.x) / static_cast<std::size_t>(seen_.step);
    const std::size_t row = static_cast<std::size_t>(place.y) / static_cast<std::size_t>(seen_.step);
    const std::size_t texel = row * static_cast<std::size_t>(seen_.width) + column;
    return texel < seen_.numbers.size() ? seen_.numbers[texel] : visible_background;
}

bool HiddenParts::hides(const glm::dvec2& place, double depth) const {
    const std::int32_t number = seen_at(place);
    if (!has_sphere(scene_, number)) return false;
    const auto surface = hit_depth(view_, size_, place, scene_.spheres[static_cast<std::size_t>(number)]);
    return surface && depth > *surface * (1.0 + on_surface);
}

void HiddenParts::for_each_run(const ProjectedLine& line, double step,
                               const std::function<void(double begin, double end, bool hidden)>& run) const {
    const int pieces = std::max(1, static_cast<int>(std::ceil(line.pixels() / step)));
    double begin = 0.0;
    bool hidden = false;
    for (int i = 0; i < pieces; ++i) {
        const double middle = (i + 0.5) / pieces;
        const bool here = hides(line.place_at(middle), line.depth_at(middle));
        if (i > 0 && here != hidden) {
            const double border = static_cast<double>(i) / pieces;
            run(begin, border, hidden);
            begin = border;
        }
        hidden = here;
    }
    run(begin, 1.0, hidden);
}

}  // namespace sphereview
