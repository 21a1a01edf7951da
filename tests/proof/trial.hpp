// One ray and one sphere, random but chosen to be awkward.
#pragma once

#include <glm/vec3.hpp>
#include <random>
#include <string>

#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

using Random = std::mt19937_64;

// From 0 up to but not 1.
inline double random_unit(Random& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

inline double between(Random& random, double low, double high) { return low + (high - low) * random_unit(random); }

inline glm::dvec3 in_cube(Random& random) {
    return {between(random, -1.0, 1.0), between(random, -1.0, 1.0), between(random, -1.0, 1.0)};
}

// Each is a place where the filter might claim too much.
enum class Awkwardness { nothing, silhouette, beside_eye, inside, near_surface, through_center, on_surface, count };

struct Trial {
    Awkwardness awkwardness = Awkwardness::nothing;
    Camera camera;
    PictureSize size;
    Pixel pixel;
    Sphere sphere;
};

// A valid camera whose ray_condition() stays below largest_float_condition, for some near it, and a sphere that is awkward
// for the bound of an arithmetic with this unit.
Trial random_trial(Random& random, double unit);

// The trial with an orthographic camera that looks along the pixel's ray, and the sphere before where that begins.
Trial with_parallel_rays(Trial trial);

// All numbers, to repeat a trial by hand.
std::string to_string(const Trial& trial);

// From the environment variable SPHEREVIEW_SEED, or 1; printed, and recorded with the test.
std::uint64_t test_seed();

// How many trials to run: fewer where sanitizers make each ten times slower.
int trial_count(int in_release);

}  // namespace sphereview
