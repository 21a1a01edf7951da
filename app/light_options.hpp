// The command line's options for light, which replace the scene's.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "camera/fit.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct LightOptions {
    std::optional<int> lights;
    std::optional<double> sky;
    std::optional<double> key;
    std::optional<std::variant<glm::dvec3, ViewAxes>> sun;  // its direction, or the view that looks as the sun shines
    std::optional<double> sun_strength;

    bool any() const { return lights || sky || key || sun || sun_strength; }
};

// The scene's light with the options applied. Throws InputError for a sun's strength without a sun.
Light with_options(const Scene& scene, const LightOptions& options);

// The options' expected values, for messages and help. part_syntax(): of the sky and the key light.
std::string lights_syntax();
std::string part_syntax(double most);
std::string sun_strength_syntax();
inline constexpr std::string_view sun_syntax =
    "X,Y,Z, not all 0, from the scene to the sun, or AZIMUTH,ELEVATION in degrees, from where the sun shines as --view looks";

constexpr bool is_light_count(std::int64_t count) { return count >= fewest_lights && count <= most_lights; }
constexpr bool is_part(double strength, double most) { return strength >= 0.0 && strength <= most; }
constexpr bool is_sun_strength(double strength) { return strength >= weakest_sun && strength <= strongest_sun; }

// Reads a text of sun_syntax; nothing for another text.
std::optional<std::variant<glm::dvec3, ViewAxes>> parse_sun(std::string_view text);

}  // namespace sphereview
