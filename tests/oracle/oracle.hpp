// The exact picture by its definition alone: rational arithmetic for every pixel and every sphere, no floating point, no
// filter. Shares no code with src/exact, and compares roots in another way, so that a mistake is not made twice.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview::oracle {

// The choices in the definition of the picture. All but the defaults are wrong; the tests show that they are noticed.
struct Rules {
    bool first_of_equals = true;         // else the last
    bool tangent_hits = true;            // else a discriminant of 0 is a miss
    bool zero_is_positive = false;       // a root at the eye itself
    bool near_root_from_inside = false;  // the smaller root, also where it lies behind the eye
    bool origins_in_plane = true;        // else orthographic rays, too, begin in the eye
    bool side_of_eye = false;            // the root that counts for the eye itself, not for where an orthographic ray begins
};

// For each pixel, row by row, the number of the visible sphere; -1 where none is.
std::vector<std::int32_t> picture(const Scene& scene, PictureSize size, const Rules& rules = {});

// The same for some of the pixels, or one.
std::vector<std::int32_t> pixels(const Scene& scene, PictureSize size, const std::vector<Pixel>& some, const Rules& rules = {});
std::int32_t pixel(const Scene& scene, PictureSize size, Pixel one);

// The sign of |C - eye|^2 - r^2: 1 when the eye is outside, 0 on the surface, -1 inside.
int eye_side(const Sphere& sphere, const glm::dvec3& eye);

// Whether the eye of the camera lies outside: of an orthographic one, the whole plane that its rays begin in.
bool eye_is_outside(const Sphere& sphere, const Camera& camera);

// The sign of the discriminant of the pixel's ray and the sphere.
int discriminant_sign(const Camera& camera, PictureSize size, Pixel pixel, const Sphere& sphere);

}  // namespace sphereview::oracle
