#include "app/frame_changes.hpp"

#include <algorithm>

namespace sphereview {

std::vector<SphereChange> changes_between(const std::vector<Sphere>& file, const std::vector<Sphere>& shown) {
    std::vector<SphereChange> changes;
    for (std::size_t i = 0; i < std::min(file.size(), shown.size()); ++i) {
        SphereChange change{.number = static_cast<std::uint32_t>(i)};
        const SphereChange none = change;
        if (file[i].hidden != shown[i].hidden) change.hidden = shown[i].hidden;
        if (file[i].color != shown[i].color) change.color = shown[i].color;
        if (file[i].radius != shown[i].radius) change.radius = shown[i].radius;
        if (change != none) changes.push_back(change);
    }
    return changes;
}

void hide_and_light(Scene& frame, const FrameChanges& changes) {
    if (changes.light) frame.light = *changes.light;
    for (const SphereChange& change : changes.spheres) {
        if (change.number < frame.spheres.size() && change.hidden) frame.spheres[change.number].hidden = *change.hidden;
    }
}

void color_and_size(Scene& frame, const FrameChanges& changes) {
    for (const SphereChange& change : changes.spheres) {
        if (change.number >= frame.spheres.size()) continue;
        Sphere& sphere = frame.spheres[change.number];
        sphere.color = change.color.value_or(sphere.color);
        sphere.radius = change.radius.value_or(sphere.radius);
    }
}

}  // namespace sphereview
