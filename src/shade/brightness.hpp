// The brightness of a surface, and the part of its colour that shows. docs/shading.md has the formulae. Twin: shaders/surface.frag.
#pragma once

#include "light/light_set.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

// About the brightness of a free surface under a sky, for moving pictures, which have no shadows. `normal`: of length 1, in the
// view's right, up and toward the eye.
inline double brightness_of_free_sky(const Light& light, const glm::dvec3& normal) {
    const double x = 0.5 + 0.5 * dot(normal, unit(key_in_view));
    return sky_of(light) * (sky_light + key_light * light.key * x * x * (0.5 + 0.5 * x));
}

// The part of its own colour that a surface of this brightness shows; above 1 if it is brighter than white.
constexpr double shown_part(double brightness) { return 1.8 * brightness / (0.8 + brightness); }

}  // namespace sphereview
