// Radii by what a file holds of each sphere, and by element.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// Radii of atoms in angstrom. The sources are named beside the table (sizes.cpp).
enum class RadiiKind { covalent, vdw, ionic };

// By their values.
inline constexpr std::array<std::string_view, 3> radii_names = {"covalent", "vdw", "ionic"};

std::optional<RadiiKind> radii_named(std::string_view name);

// By the element's symbol, in any letter case. Nothing for an element of which the table has none; those without an ionic radius,
// as hydrogen and the noble gases, have the covalent one.
std::optional<double> radius_of_element(std::string_view symbol, RadiiKind kind);

// How sizes were made.
struct Sizing {
    double scale = 1.0;     // the radius of a value of 1
    std::size_t small = 0;  // how many spheres are drawn small, as they have no number above 0
};

// So that the largest of the values becomes half the median distance to the nearest neighbour: spheres touch, and hide little. To 3
// digits. Nothing where the spheres or the values do not say.
std::optional<double> usual_scale(const Scene& scene, const Property& values);

// Each sphere's radius becomes the scale times its value; where that is no finite number above 0, a fiftieth of the largest one.
Sizing size_by(std::vector<Sphere>& spheres, const Property& values, double scale);

// Which part of the spheres have such radii, from 0 to 1: looked at for some of them, where there are many.
double part_with_sizes(const Scene& scene, const Property& values, double scale);

// Gives atoms the radii of their elements. Returns how many spheres keep theirs, as their element is not known.
std::size_t use_radii(std::vector<Sphere>& spheres, const Property& elements, RadiiKind kind);

// Every radius, times so much: > 0. What is beyond a double becomes the nearest one.
void scale_radii(std::vector<Sphere>& spheres, double factor);

}  // namespace sphereview
