// Light as Python passes it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

#include "app/light_options.hpp"
#include "scene/light.hpp"
#include "shade/shading.hpp"

namespace sphereview {

// How many lights, the strengths of sky and key light, the direction to the sun and its strength; none where nothing is said.
using LightNumbers =
    std::tuple<std::optional<int>, std::optional<double>, double, std::optional<std::array<double, 3>>, std::optional<double>>;

// The same in the order of LightNumbers, each instead of what is there; the sun as sun_syntax says.
using LightArguments = std::tuple<std::optional<std::int64_t>, std::optional<double>, std::optional<double>,
                                  std::optional<std::string>, std::optional<double>>;

LightNumbers numbers_of(const Light& light);
// Of numbers that numbers_of() has given.
Light light_from(const LightNumbers& numbers);

// Throws InputError for what is out of its range.
LightOptions light_options_from(const LightArguments& arguments);

// The scene's light with the arguments instead; its camera says where a view is. Throws InputError also for the strength of a sun
// that is not there, and for arguments in another shading than `studio`.
Light light_with(const Scene& scene, const LightArguments& arguments, Shading shading);

}  // namespace sphereview
