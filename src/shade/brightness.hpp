// How bright light makes a surface, and what of its colour that shows. docs/shading.md has the formulae. Twin:
// shaders/surface.frag.
#pragma once

#include "light/light_set.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

// How bright a sky makes a free surface, nearly: for what moves, which has no shadows. `normal`: of length 1, in the view's
// directions right, up and toward the eye.
inline double brightness_of_free_sky(const Light& light, const glm::dvec3& normal) {
    const double x = 0.5 + 0.5 * dot(normal, unit(key_in_view));
    return sky_of(light) * (sky_light + key_light * light.key * x * x * (0.5 + 0.5 * x));
}

// Which part of its own colour a surface shows that is so bright; above 1 where it is brighter than white can be.
constexpr double shown_part(double brightness) { return 1.8 * brightness / (0.8 + brightness); }

}  // namespace sphereview
