// What a window knows of the drawn spheres besides where they are: their colours, and which are selected.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/drawn.hpp"
#include "gpu/scene_tables.hpp"
#include "scene/scene.hpp"
#include "shade/shading.hpp"

namespace sphereview {

// Where more spheres than this are selected they are outlined as one set, and tinted: a line around each would hide the picture.
inline constexpr std::size_t most_outlined_alone = 200;

class ShownColors {
public:
    // All anew.
    void set(const Scene& scene, const DrawnSpheres& drawn, Shading shading);

    // Edits were followed: spheres may have come, at the end; these got other values, and with `order` others have other numbers.
    void follow(const Scene& scene, const DrawnSpheres& drawn, Shading shading, std::span<const std::uint32_t> numbers, bool order);

    // Marks these, given by their numbers, as selected, and no others.
    void mark(const std::vector<std::uint32_t>& numbers, const DrawnSpheres& drawn);
    bool are_marked(const std::vector<std::uint32_t>& numbers) const { return marks_known_ && numbers == marked_numbers_; }

    // Uploads what is not uploaded yet.
    void upload(SceneTables& tables);

private:
    void change(std::size_t index, const ShownColor& color);

    std::vector<ShownColor> colors_;
    bool all_changed_ = true;             // since the last upload
    std::vector<std::uint32_t> changed_;  // or only these

    std::vector<std::uint32_t> marked_;  // indices
    std::vector<std::uint32_t> marked_numbers_;
    bool marks_known_ = false;  // marked_numbers_ are theirs
};

}  // namespace sphereview
