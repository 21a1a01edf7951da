// What a person changed in one frame of a file, for all of its frames.
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

// A change of one sphere. Empty fields stay as they are.
struct SphereChange {
    std::uint32_t number = 0;
    std::optional<bool> hidden{};
    std::optional<Color> color{};
    std::optional<double> radius{};

    bool operator==(const SphereChange&) const = default;
};

struct FrameChanges {
    // By number, ascending. A change holds in each frame that has a sphere of that number.
    std::vector<SphereChange> spheres{};
    std::map<std::uint32_t, std::string> names{};  // "": none any more
    // For all frames.
    std::optional<Background> background{};
    std::optional<Camera> camera{};
    std::optional<Light> light{};
    std::optional<std::vector<SavedView>> views{};

    bool operator==(const FrameChanges&) const = default;
    bool any() const { return !spheres.empty() || !names.empty() || background || camera || light || views; }
    // Whether a frame of `size` spheres lacks some of the changed spheres.
    bool go_beyond(std::size_t size) const;
    // Adds those changes of `others` whose spheres a frame of `size` spheres lacks. Must have no changes of such spheres before.
    void add_beyond(std::size_t size, const FrameChanges& others);
};

// How `after` differs from `before`, places apart. Both have the same number of spheres in the same order.
FrameChanges changes_between(const Scene& before, const Scene& after);

// The changes of those spheres that a frame of `size` spheres has.
std::span<const SphereChange> changes_within(const FrameChanges& changes, std::size_t size);

// Apply the changes that pictures show; pictures have a camera and a background of their own. hide_and_light() comes before the
// look, whose ranges leave hidden spheres out, and color_and_size() after it.
void hide_and_light(Scene& frame, const FrameChanges& changes);
void color_and_size(Scene& frame, const FrameChanges& changes);

}  // namespace sphereview
