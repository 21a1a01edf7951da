// The scenes on which light is compared with the oracle's.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "oracle/scenes.hpp"
#include "scene/light.hpp"

namespace sphereview::oracle {

struct LitTrial {
    Trial trial;
    Light light;
    int side = 1;  // points along the side of a pixel; the trial's size is in points
};

// A few lights of the sky, and a sun in that direction.
Light sky_and_sun(const glm::dvec3& direction);

LitTrial with_light(Trial trial, std::uint64_t seed);

// The middle pixel sees the point (0, 0, 180), the light is in the direction (1, 0, -1).
Scene lit_middle();
inline constexpr glm::dvec3 slanting{1.0, 0.0, -1.0};

// What the definition leaves to chance: edges of shadows, tangent lines, normals at right angles, spheres that touch or hold
// others.
std::vector<LitTrial> light_edges();

// Ordinary spheres in the middle of the picture, among others that are farther away or larger by many orders of magnitude.
struct Surroundings {
    std::string name;
    Scene scene;
};
std::vector<Surroundings> surroundings(int spheres, int others);

// Spheres that each cover the whole plane of any light, before few that are seen; and spheres nearly in one place, or quite: lists
// that would be endless.
std::vector<LitTrial> light_crowds();

// Spheres so large and so near each other that double knows neither points nor shadows: balls and 106 bits decide nearly all, and
// integers what they must.
Trials hard_to_light(int spheres, PictureSize size);

}  // namespace sphereview::oracle
