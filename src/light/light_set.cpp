#include "light/light_set.hpp"

#include <array>
#include <bit>
#include <cmath>

#include "base/square_root.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr std::size_t many_spheres = 300'000;
constexpr int usual_lights = 256;
constexpr int few_lights = 64;

// The golden angle, by which each direction of the set is turned from the one before.
constexpr double golden_cosine = -0.7373688780783197;
constexpr double golden_sine = 0.6754902942615238;

// Components are whole multiples of 1 / this.
constexpr double direction_unit = 32767.0;

// Rotations in no particular order, as quaternions of whole numbers; the first turns nothing.
constexpr std::array<std::array<int, 4>, turned_sets> turns = {{
    {1, 0, 0, 0},
    {7, 3, -2, 5},
    {5, -6, 4, 1},
    {3, 1, 8, -4},
    {9, -2, -3, -6},
    {4, 7, 1, 6},
    {6, 2, 5, 7},
    {8, -5, 3, 2},
    {2, 6, -7, 3},
    {7, -4, -6, 1},
    {5, 3, 2, -8},
    {9, 5, -1, -2},
    {3, -8, 2, 5},
    {6, 4, -5, -3},
    {4, -1, 6, 9},
    {8, 1, 7, -5},
}};

// The vector, turned by a quaternion. Quarter turns and no turn at all are exact.
glm::dvec3 turned(const glm::dvec3& v, const std::array<int, 4>& turn) {
    const auto [w, x, y, z] = std::array<double, 4>{static_cast<double>(turn[0]), static_cast<double>(turn[1]),
                                                    static_cast<double>(turn[2]), static_cast<double>(turn[3])};
    const double square = w * w + x * x + y * y + z * z;
    const glm::dvec3 first{w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)};
    const glm::dvec3 second{2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)};
    const glm::dvec3 third{2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z};
    return glm::dvec3{dot(first, v), dot(second, v), dot(third, v)} / square;
}

double whole(double value) { return std::floor(value + 0.5); }

LightVector share(const glm::dvec3& direction, double strength) {
    const glm::dvec3 l = unit(direction);
    const auto part = [&](double component) { return static_cast<std::int32_t>(whole(light_one * (strength * component))); };
    return {part(l.x), part(l.y), part(l.z)};
}

// A spiral over half of the sphere, from the equator up: by equal steps of height, which cut equal areas.
std::vector<glm::dvec3> half_spiral(int lights) {
    std::vector<glm::dvec3> spiral;
    double cosine = 1.0;
    double sine = 0.0;
    for (int i = 0; 2 * i < lights; ++i) {
        const double height = (2.0 * i + 1.0) / lights;
        const double across = square_root(1.0 - height * height);
        spiral.emplace_back(across * cosine, height, across * sine);
        const double next = cosine * golden_cosine - sine * golden_sine;
        sine = cosine * golden_sine + sine * golden_cosine;
        cosine = next;
    }
    return spiral;
}

std::uint32_t reversed(std::uint32_t value, int bits) {
    std::uint32_t result = 0;
    for (int bit = 0; bit < bits; ++bit) result |= (value >> bit & 1U) << (bits - 1 - bit);
    return result;
}

}  // namespace

glm::dvec3 key_direction(const CameraAxes& axes) {
    return unit(key_in_view.x * axes.right + key_in_view.y * axes.up - key_in_view.z * axes.ahead);
}

int sky_lights(const Light& light, std::size_t spheres, int samples) {
    return light.lights.value_or(samples > 1 || spheres > many_spheres ? few_lights : usual_lights);
}

std::vector<DirectedLight> light_set(const Light& light, int lights, const Camera& camera, int set) {
    std::vector<DirectedLight> all;
    const auto add = [&](const glm::dvec3& direction, const LightVector& its_share) {
        if (its_share != LightVector{}) all.push_back({direction, its_share});
    };
    if (light.sun) add(light.sun->direction, share(light.sun->direction, sun_strength_of(light)));
    const glm::dvec3 key = light.toward_key ? *light.toward_key : key_direction(camera_axes(camera));
    const auto add_sky = [&](const glm::dvec3& direction) {
        const double towards_key = dot(unit(direction), key);
        const double lobe = towards_key > 0.0 ? (towards_key * towards_key) * (towards_key * towards_key) : 0.0;
        add(direction, share(direction, sky_of(light) * (4.0 * sky_light + 12.0 * (light.key * key_light) * lobe) / lights));
    };
    // Pairs of opposite directions, in the order of the reversed bits of their numbers.
    const std::vector<glm::dvec3> spiral = half_spiral(lights);
    const auto bits = static_cast<int>(std::bit_width(spiral.size() - 1));
    for (std::uint32_t k = 0; k < 1U << bits; ++k) {
        const std::uint32_t i = reversed(k, bits);
        if (i >= spiral.size()) continue;
        const glm::dvec3 v = direction_unit * turned(spiral[i], turns.at(static_cast<std::size_t>(set)));
        const glm::dvec3 direction{whole(v.x), whole(v.y), whole(v.z)};
        add_sky(direction);
        if (2 * i + 1 < static_cast<std::uint32_t>(lights)) add_sky(-direction);
    }
    return all;
}

std::vector<std::vector<DirectedLight>> light_sets(const Light& light, std::size_t spheres, const Camera& camera, int side) {
    const int lights = sky_lights(light, spheres, side * side);
    std::vector<std::vector<DirectedLight>> sets;
    for (int set = 0; set < side * side; ++set) sets.push_back(light_set(light, lights, camera, set));
    return sets;
}

}  // namespace sphereview
