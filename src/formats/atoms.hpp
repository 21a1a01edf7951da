// What the readers of atoms share.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "formats/elements.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

// The radius of an atom for which the file says none: the element's, or the given one. A virtual site stays small.
double radius_of(const Element& element, const DataOptions& options);

// Removes the spheres of these numbers, which ascend, with their names and values; the others move up.
void remove_spheres(Scene& scene, std::span<const std::size_t> numbers);

// Throws MemoryError when so many spheres, and what is needed beside each, do not fit.
void require_memory_for_spheres(const std::string& name, std::size_t count, std::size_t bytes_of_each = sizeof(Sphere));

// For a warning of a fault behind that many frames: the fault, and what is passed over.
std::string early_end(const std::string& fault, std::int64_t frames);

// Warns of rows of the file `name` without coordinates, if there are any: "1 vertex has no coordinates and is left out".
void warn_of_left_out(SphereData& data, std::size_t count, const std::string& name, const char* one, const char* several);

// Warns of the virtual sites of the file `name`, if there are any.
void warn_of_virtual_sites(SphereData& data, std::size_t count, const std::string& name, const DataOptions& options);

// The same, by the numbers of their spheres, which ascend; then makes those small that have radii of their own, none larger than
// the smallest atom, or removes all of them where `options` says so. Removes the spheres `left_out`, too, which are others.
void finish_virtual_sites(SphereData& data, std::span<const std::size_t> numbers, const std::string& name,
                          const DataOptions& options, std::span<const std::size_t> left_out = {});

}  // namespace sphereview
