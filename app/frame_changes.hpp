// What a person has changed in one frame of a file, for all of its frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// Of the sphere with that number; what is not said stays as it is.
struct SphereChange {
    std::uint32_t number = 0;
    std::optional<bool> hidden{};
    std::optional<Color> color{};
    std::optional<double> radius{};

    bool operator==(const SphereChange&) const = default;
};

struct FrameChanges {
    // By number, ascending, for each frame that has a sphere of that number, however many others it has.
    std::vector<SphereChange> spheres{};
    std::map<std::uint32_t, std::string> names{};  // "": none any more
    // For all frames.
    std::optional<Background> background{};
    std::optional<Camera> camera{};
    std::optional<Light> light{};
    std::optional<std::vector<SavedView>> views{};

    bool operator==(const FrameChanges&) const = default;
    bool any() const { return !spheres.empty() || !names.empty() || background || camera || light || views; }
    // Whether a frame of so many spheres lacks some that were changed.
    bool go_beyond(std::size_t size) const;
    // Takes from `others` what they have for spheres that a frame of so many lacks; this has nothing for those.
    void add_beyond(std::size_t size, const FrameChanges& others);
};

// In what the frame differs from what it was; its places are its own. Of as many spheres in the same order.
FrameChanges changes_between(const Scene& before, const Scene& after);

// Those of the spheres that a frame of so many has.
std::span<const SphereChange> changes_within(const FrameChanges& changes, std::size_t size);

// Each makes its part of what pictures show of the changes, by a camera and before a background of their own: the first before the
// look, whose ranges count no hidden spheres, the other after it.
void hide_and_light(Scene& frame, const FrameChanges& changes);
void color_and_size(Scene& frame, const FrameChanges& changes);

}  // namespace sphereview
