// What the readers of atoms share.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "formats/elements.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

// The radius of an atom for which the file says none: the element's, or the given one. A virtual site stays small
// (settle_virtual_sites).
double radius_of(const Element& element, const DataOptions& options);

// Removes the spheres of these numbers, which ascend, with their names and values; the others move up.
void remove_spheres(Scene& scene, std::span<const std::size_t> numbers);

// Of the spheres of these numbers those that are left once others are `gone`, by the numbers that they then have. All ascend.
std::vector<std::size_t> numbers_without(std::span<const std::size_t> numbers, std::span<const std::size_t> gone);

// Throws MemoryError when so many spheres, and what is needed beside each, do not fit.
void require_memory_for_spheres(const std::string& name, std::size_t count, std::size_t bytes_of_each = sizeof(Sphere));

// For a warning of a fault behind that many frames: the fault, and what is passed over.
std::string early_end(const std::string& fault, std::int64_t frames);

// Warns of rows of the file `name` without coordinates, if there are any: "1 vertex has no coordinates and is left out".
void warn_of_left_out(SphereData& data, std::size_t count, const std::string& name, const char* one, const char* several);

// What becomes of the spheres that are virtual sites, whose numbers ascend: none is larger than an atom, whatever radius the file
// gives it; a warning, which begins with the file's `name`, says how many there are; and they are removed where options say so.
void settle_virtual_sites(SphereData& data, std::span<const std::size_t> sites, const std::string& name,
                          const DataOptions& options);

}  // namespace sphereview
