// Radii by a property, and by element.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// Radii of atoms in angstrom. The table in sizes.cpp names its sources.
enum class RadiiKind { covalent, vdw, ionic };

// By their values.
inline constexpr std::array<std::string_view, 3> radii_names = {"covalent", "vdw", "ionic"};

std::optional<RadiiKind> radii_named(std::string_view name);

// `symbol`: in any letter case. Nothing for an element without a radius. Elements without an ionic radius, such as hydrogen and the
// noble gases, have the covalent one.
std::optional<double> radius_of_element(std::string_view symbol, RadiiKind kind);

// The result of sizing.
struct Sizing {
    double scale = 1.0;     // the radius of a value of 1
    std::size_t small = 0;  // spheres drawn small, because they have no number above 0
};

// The scale, to 3 digits, that makes the largest value half the median distance to the nearest neighbour, so that spheres touch and
// hide little. Nothing if the spheres or values do not determine one.
std::optional<double> usual_scale(const Scene& scene, const Property& values);

// Gives each sphere the radius scale times value; if that is no finite number above 0, a fiftieth of the largest radius.
Sizing size_by(std::vector<Sphere>& spheres, const Property& values, double scale);

// The part of the spheres with such radii, 0 to 1; of many spheres a sample is tested.
double part_with_sizes(const Scene& scene, const Property& values, double scale);

// Gives atoms the radii of their elements. Returns the number of spheres with an unknown element, which keep their radii.
std::size_t use_radii(std::vector<Sphere>& spheres, const Property& elements, RadiiKind kind);

// Multiplies every radius by `factor`, which is > 0. Results beyond doubles become the nearest double.
void scale_radii(std::vector<Sphere>& spheres, double factor);

}  // namespace sphereview
