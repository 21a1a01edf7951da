// Shared by the readers of atoms.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "formats/elements.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

// The radius of an atom without one in the file: the element's, or that of the options. A virtual site stays small
// (settle_virtual_sites).
double radius_of(const Element& element, const DataOptions& options);

// Removes spheres, whose numbers ascend, with their names and values; the others move up.
void remove_spheres(Scene& scene, std::span<const std::size_t> numbers);

// The new numbers of these spheres once others are `gone`, without those that are gone themselves. All ascend.
std::vector<std::size_t> numbers_without(std::span<const std::size_t> numbers, std::span<const std::size_t> gone);

// Throws MemoryError if `count` spheres do not fit.
void require_memory_for_spheres(const std::string& name, std::size_t count, std::size_t bytes_of_each = sizeof(Sphere));

// The warning about a fault behind that many frames.
std::string early_end(const std::string& fault, std::int64_t frames);

// Warns of rows of the file `name` without coordinates, if there are any: "1 vertex has no coordinates and is left out".
void warn_of_left_out(SphereData& data, std::size_t count, const std::string& name, const char* one, const char* several);

// Makes the virtual sites, whose numbers ascend, no larger than atoms, whatever radius the file gives, or removes them if the
// options say so. A warning, which begins with the file's `name`, says how many there are.
void settle_virtual_sites(SphereData& data, std::span<const std::size_t> sites, const std::string& name,
                          const DataOptions& options);

}  // namespace sphereview
