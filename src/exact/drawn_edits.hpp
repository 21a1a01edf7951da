// Drawn spheres that follow the edits of their scene, in proportion to what an edit touches.
#pragma once

#include <cstdint>
#include <span>

#include "exact/drawn.hpp"

namespace sphereview {

// Spheres came into the scene, or went out of it, with these numbers, ascending (ChangesSince::came and went): the others get the
// numbers that they have now. Those that went keep their index; drop() them first.
void renumber_for_came(DrawnSpheres& drawn, std::span<const std::uint32_t> numbers);
void renumber_for_went(DrawnSpheres& drawn, std::span<const std::uint32_t> numbers);

// A sphere is no longer drawn: its index becomes a gap.
void drop(DrawnSpheres& drawn, std::size_t index);

// A sphere comes that was not drawn, with that number now. Returns its index, a new one.
std::size_t append(DrawnSpheres& drawn, std::uint32_t number, const glm::vec4& center_radius);

}  // namespace sphereview
