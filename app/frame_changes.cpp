#include "app/frame_changes.hpp"

namespace sphereview {

std::vector<SphereChange> changes_between(const std::vector<Sphere>& before, const std::vector<Sphere>& after) {
    std::vector<SphereChange> changes;
    for (std::size_t i = 0; i < after.size(); ++i) {
        SphereChange change{.number = static_cast<std::uint32_t>(i)};
        if (before[i].hidden != after[i].hidden) change.hidden = after[i].hidden;
        if (before[i].color != after[i].color) change.color = after[i].color;
        if (!same_bits(before[i].radius, after[i].radius)) change.radius = after[i].radius;
        if (change.hidden || change.color || change.radius) changes.push_back(change);
    }
    return changes;
}

void hide_and_light(Scene& frame, const FrameChanges& changes) {
    if (changes.light) frame.light = *changes.light;
    if (frame.spheres.size() != changes.frame_size) return;
    for (const SphereChange& change : changes.spheres) {
        if (change.hidden) frame.spheres[change.number].hidden = *change.hidden;
    }
}

void color_and_size(Scene& frame, const FrameChanges& changes) {
    if (frame.spheres.size() != changes.frame_size) return;
    for (const SphereChange& change : changes.spheres) {
        Sphere& sphere = frame.spheres[change.number];
        sphere.color = change.color.value_or(sphere.color);
        sphere.radius = change.radius.value_or(sphere.radius);
    }
}

}  // namespace sphereview
