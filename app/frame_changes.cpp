#include "app/frame_changes.hpp"

#include <algorithm>

namespace sphereview {

namespace {

template <typename T>
void note_other(std::optional<T>& other, const T& before, const T& after) {
    if (!(before == after)) other = after;
}

}  // namespace

bool FrameChanges::go_beyond(std::size_t size) const {
    return (!spheres.empty() && spheres.back().number >= size) || (!names.empty() && names.rbegin()->first >= size);
}

void FrameChanges::add_beyond(std::size_t size, const FrameChanges& others) {
    const std::size_t within = changes_within(others, size).size();
    spheres.insert(spheres.end(), others.spheres.begin() + static_cast<std::ptrdiff_t>(within), others.spheres.end());
    for (const auto& [number, name] : others.names) {
        if (number >= size) names[number] = name;
    }
}

FrameChanges changes_between(const Scene& before, const Scene& after) {
    FrameChanges changes;
    for (std::size_t i = 0; i < after.spheres.size(); ++i) {
        const Sphere& was = before.spheres[i];
        const Sphere& is = after.spheres[i];
        SphereChange change{.number = static_cast<std::uint32_t>(i)};
        if (was.hidden != is.hidden) change.hidden = is.hidden;
        if (was.color != is.color) change.color = is.color;
        if (!same_bits(was.radius, is.radius)) change.radius = is.radius;
        if (change.hidden || change.color || change.radius) changes.spheres.push_back(change);
    }
    for (const auto& [number, name] : before.names) {
        if (!after.names.contains(number)) changes.names[number] = "";
    }
    for (const auto& [number, name] : after.names) {
        const auto was = before.names.find(number);
        if (was == before.names.end() || was->second != name) changes.names[number] = name;
    }
    note_other(changes.background, before.background, after.background);
    note_other(changes.camera, before.camera, after.camera);
    note_other(changes.light, before.light, after.light);
    note_other(changes.views, before.views, after.views);
    return changes;
}

std::span<const SphereChange> changes_within(const FrameChanges& changes, std::size_t size) {
    const auto end = std::ranges::lower_bound(changes.spheres, size, {}, &SphereChange::number);
    return {changes.spheres.begin(), end};
}

void hide_and_light(Scene& frame, const FrameChanges& changes) {
    if (changes.light) frame.light = *changes.light;
    for (const SphereChange& change : changes_within(changes, frame.spheres.size())) {
        if (change.hidden) frame.spheres[change.number].hidden = *change.hidden;
    }
}

void color_and_size(Scene& frame, const FrameChanges& changes) {
    for (const SphereChange& change : changes_within(changes, frame.spheres.size())) {
        Sphere& sphere = frame.spheres[change.number];
        sphere.color = change.color.value_or(sphere.color);
        sphere.radius = change.radius.value_or(sphere.radius);
    }
}

}  // namespace sphereview
