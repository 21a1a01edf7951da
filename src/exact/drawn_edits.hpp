// Drawn spheres that follow the edits of their scene, in proportion to what an edit touches.
#pragma once

#include <cstdint>
#include <span>

#include "exact/drawn.hpp"

namespace sphereview {

// Gives all other spheres their present numbers after spheres with these numbers, ascending, came into the scene or went out of it
// (ChangesSince::came and went). Call drop() first for the spheres that went.
void renumber_for_came(DrawnSpheres& drawn, std::span<const std::uint32_t> numbers);
void renumber_for_went(DrawnSpheres& drawn, std::span<const std::uint32_t> numbers);

// Ends the drawing of a sphere: its index becomes a gap.
void drop(DrawnSpheres& drawn, std::size_t index);

// Begins to draw the sphere that has the number now. Returns its index, which is new.
std::size_t append(DrawnSpheres& drawn, std::uint32_t number, const glm::vec4& center_radius);

}  // namespace sphereview
