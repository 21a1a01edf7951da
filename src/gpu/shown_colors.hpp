// The drawn spheres' colours in a window, and which spheres are selected.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/drawn.hpp"
#include "gpu/scene_tables.hpp"
#include "scene/scene.hpp"
#include "shade/shading.hpp"

namespace sphereview {

// More selected spheres than this are tinted and outlined as one set: a line around each would hide the picture.
inline constexpr std::size_t most_outlined_alone = 200;

class ShownColors {
public:
    // Sets all colours anew.
    void set(const Scene& scene, const DrawnSpheres& drawn, Shading shading);

    // Follows edits: spheres may have been added at the end, the spheres `numbers` have changed, and with `order` numbers have
    // changed.
    void follow(const Scene& scene, const DrawnSpheres& drawn, Shading shading, std::span<const std::uint32_t> numbers, bool order);

    // Marks these numbers as selected, and no others.
    void mark(const std::vector<std::uint32_t>& numbers, const DrawnSpheres& drawn);
    bool are_marked(const std::vector<std::uint32_t>& numbers) const { return marks_known_ && numbers == marked_numbers_; }

    // Uploads all changes since the last upload.
    void upload(SceneTables& tables);

private:
    void change(std::size_t index, const ShownColor& color);

    std::vector<ShownColor> colors_;
    bool all_changed_ = true;             // since the last upload
    std::vector<std::uint32_t> changed_;  // or only these

    std::vector<std::uint32_t> marked_;  // indices
    std::vector<std::uint32_t> marked_numbers_;
    bool marks_known_ = false;  // marked_ are marked_numbers_
};

}  // namespace sphereview
