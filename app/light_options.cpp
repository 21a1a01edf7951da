#include "app/light_options.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/number.hpp"

namespace sphereview {

Light with_options(const Scene& scene, const LightOptions& options) {
    Light light = scene.light;
    if (options.sun) {
        const auto* view = std::get_if<ViewAxes>(&*options.sun);
        if (!light.sun) light.sun.emplace();
        light.sun->direction =
            view != nullptr ? -with_hand_of(axes_of(scene.camera), *view).ahead : std::get<glm::dvec3>(*options.sun);
    }
    if (options.lights) light.lights = options.lights;
    if (options.sky) light.sky = options.sky;
    if (options.key) light.key = *options.key;
    if (options.sun_strength) {
        if (!light.sun) throw InputError("sphereview: --sun-strength: the scene has no sun, expected --sun as well");
        light.sun->strength = options.sun_strength;
    }
    return light;
}

std::string lights_syntax() {
    return "a whole number from " + std::to_string(fewest_lights) + " to " + std::to_string(most_lights);
}

std::string part_syntax(double most) { return "a number from 0 to " + shortest(most); }

std::string sun_strength_syntax() { return "a number from " + shortest(weakest_sun) + " to " + shortest(strongest_sun); }

std::optional<std::variant<glm::dvec3, ViewAxes>> parse_sun(std::string_view text) {
    if (std::ranges::count(text, ',') == 1) {
        // Words such as "front" have no comma.
        return parse_view(text);
    }
    glm::dvec3 direction{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t end = std::min(text.find(','), text.size());
        const bool last = axis == 2;
        if ((end == text.size()) != last) return std::nullopt;
        if (parse_double(text.substr(0, end), direction[axis]) != NumberFault::none) return std::nullopt;
        text.remove_prefix(last ? end : end + 1);
    }
    if (direction == glm::dvec3(0.0)) return std::nullopt;
    return direction;
}

}  // namespace sphereview
