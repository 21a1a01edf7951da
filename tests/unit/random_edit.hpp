// Edits that try to be applied wrongly, and a plain way to apply them.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "edit/edit.hpp"

namespace sphereview {

// A valid edit of the scene, of any kind: of none, the first, the last, some or all spheres; now and then one that changes
// nothing. The same random numbers give the same edit on every platform.
Edit random_edit(std::mt19937_64& random, const Scene& scene);

// Of `below`: none, the first, the last, some or all; ascending.
std::vector<std::uint32_t> random_numbers(std::mt19937_64& random, std::size_t below);

// The scene after the edit, worked out in the plainest way.
Scene edited(const Edit& edit, const Scene& scene);

}  // namespace sphereview
