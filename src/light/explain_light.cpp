#include "light/explain_light.hpp"

#include "light/hit_places.hpp"

namespace sphereview {

LightExplanation explain_light(const Scene& scene, const DrawnSpheres& drawn, PictureSize size, Pixel pixel, std::int32_t visible,
                               const glm::dvec3& direction) {
    const Sphere& sphere = scene.spheres[static_cast<std::size_t>(visible)];
    const std::optional<std::size_t> index = drawn.index_of(static_cast<std::uint32_t>(visible));
    const EyeSide side = drawn.side(*index);
    const ExactLitPoint point(scene.camera, size, pixel, sphere, side);
    LightExplanation explanation;
    explanation.facing = point.facing(direction);
    if (explanation.facing <= 0) return explanation;
    const HitPlaces places(scene.camera, size);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const std::int32_t number = drawn.number(i);
        if (number == visible || drawn.side(i) != EyeSide::outside) continue;
        const Sphere& other = scene.spheres[static_cast<std::size_t>(number)];
        if (!places.blocked(pixel, sphere, side, other, direction)) continue;
        explanation.blocker = number;
        explanation.signs = point.blocking(other, direction);
        break;
    }
    return explanation;
}

std::string in_words(const LightExplanation& explanation) {
    if (explanation.facing < 0) return "does not shine: n.L < 0, the surface faces away";
    if (explanation.facing == 0) return "does not shine: n.L = 0, the light is in the surface's tangent plane";
    if (!explanation.blocker) return "shines: n.L > 0, and no sphere is in the way";
    const std::string disc = explanation.signs.disc == 0 ? "= 0: the line to the light touches the sphere"
                                                         : "> 0: the line to the light goes through the sphere";
    return "does not shine: n.L > 0, but sphere " + std::to_string(*explanation.blocker) +
           " is in the way. With m from its centre to the point, m.L < 0: the centre lies towards the light; (m.L)^2 - L.L (m.m - "
           "r^2) " +
           disc;
}

}  // namespace sphereview
