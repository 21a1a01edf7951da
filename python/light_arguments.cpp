#include "python/light_arguments.hpp"

#include "base/number.hpp"
#include "python/errors.hpp"

namespace sphereview {

LightNumbers numbers_of(const Light& light) {
    if (!light.sun) return {light.lights, light.sky, light.key, std::nullopt, std::nullopt};
    const glm::dvec3& direction = light.sun->direction;
    return {light.lights, light.sky, light.key, std::array{direction.x, direction.y, direction.z}, light.sun->strength};
}

Light light_from(const LightNumbers& numbers) {
    const auto& [lights, sky, key, sun, strength] = numbers;
    Light light{lights, sky, key, {}};
    if (sun) light.sun = Sun{{(*sun)[0], (*sun)[1], (*sun)[2]}, strength};
    return light;
}

LightOptions light_options_from(const LightArguments& arguments) {
    const auto& [lights, sky, key, sun, strength] = arguments;
    if (lights && !is_light_count(*lights)) wrong_argument("lights", std::to_string(*lights), lights_syntax());
    if (sky && !is_part(*sky, most_sky)) wrong_argument("sky", shortest(*sky), part_syntax(most_sky));
    if (key && !is_part(*key, most_key)) wrong_argument("key", shortest(*key), part_syntax(most_key));
    if (strength && !is_sun_strength(*strength)) wrong_argument("sun_strength", shortest(*strength), sun_strength_syntax());
    LightOptions options;
    if (lights) options.lights = static_cast<int>(*lights);
    options.sky = sky;
    options.key = key;
    if (sun) {
        options.sun = parse_sun(*sun);
        if (!options.sun) wrong_argument("sun", *sun, std::string(sun_syntax));
    }
    options.sun_strength = strength;
    return options;
}

Light light_with(const Scene& scene, const LightArguments& arguments, Shading shading) {
    const LightOptions options = light_options_from(arguments);
    if (options.any() && !is_lit(shading)) {
        const char* first = options.lights ? "lights"
                            : options.sky  ? "sky"
                            : options.key  ? "key"
                            : options.sun  ? "sun"
                                           : "sun_strength";
        wrong_argument("shade", std::string(name_of(shading)), std::string("studio with ") + first);
    }
    if (options.sun_strength && !options.sun && !scene.light.sun) {
        throw InputError("sun_strength: the scene has no sun, expected sun as well");
    }
    return with_options(scene, options);
}

}  // namespace sphereview
