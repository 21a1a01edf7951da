#include "tiles/live_lists.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "exact/drawn_edits.hpp"

namespace sphereview {

namespace {

constexpr std::size_t most_twin_tests = 1 << 18;

}  // namespace

LiveLists::LiveLists(DrawnSpheres drawn, EditedLists lists, const Camera& camera)
    : drawn_(std::move(drawn)), lists_(std::move(lists)), camera_(camera), built_size_(drawn_.size()) {}

void LiveLists::replace_lists(EditedLists lists, const Camera& camera) {
    assert(!edited_);
    lists_ = std::move(lists);
    camera_ = camera;
}

bool LiveLists::follow(const Scene& scene, const ChangesSince& changes) {
    edited_ = true;
    whole_ = whole_ && take_over(scene, changes);
    return whole_;
}

bool LiveLists::take_over(const Scene& scene, const ChangesSince& changes) {
    const std::size_t count = changes.spheres.size() + changes.came.size() + changes.went.size();
    if (count > most_changes || count * drawn_.twins.size() > most_twin_tests) return false;
    if (changes.order) {
        if (changes.came.empty() && changes.went.empty()) return false;
        if (!remove(scene, changes.went)) return false;
        renumber_for_came(drawn_, changes.came);
    }
    const auto taken_over = [&](std::uint32_t number) { return change(scene, number); };
    return std::ranges::all_of(changes.came, taken_over) && std::ranges::all_of(changes.spheres, taken_over) &&
           drawn_.gone.size() <= most_changes && drawn_.size() - built_size_ <= most_changes;
}

bool LiveLists::remove(const Scene& scene, const std::vector<std::uint32_t>& numbers) {
    std::vector<std::size_t> indices;
    for (const std::uint32_t number : numbers) {
        if (const auto index = drawn_.index_of(number)) indices.push_back(*index);
    }
    renumber_for_went(drawn_, numbers);
    for (const std::size_t index : indices) {
        if (!take_out(scene, index)) return false;
        drop(drawn_, index);
    }
    return true;
}

// Lists a sphere of the scene with the values that it has now.
bool LiveLists::change(const Scene& scene, std::uint32_t number) {
    const Sphere& sphere = scene.spheres[number];
    const auto index = drawn_.index_of(number);
    std::erase(drawn_.twins, static_cast<std::int32_t>(number));
    if (index && !take_out(scene, *index)) return false;
    if (sphere.hidden) {
        if (index) drop(drawn_, *index);
        return true;
    }
    const auto values = drawn_form(sphere, camera_, drawn_.scale);
    return values && put_in(scene, number, index, *values);
}

// Also false for a sphere that has hidden an equal one: that one can be seen now.
bool LiveLists::take_out(const Scene& scene, std::size_t index) {
    const glm::vec4& values = drawn_.center_radius[index];
    if (drawn_.beyond_float.contains(static_cast<std::uint32_t>(index))) return false;
    const bool has_twin = std::ranges::any_of(drawn_.twins, [&](std::int32_t number) {
        return drawn_form(scene.spheres[static_cast<std::size_t>(number)], camera_, drawn_.scale) == values;
    });
    return !has_twin && lists_.take_out(static_cast<std::uint32_t>(index), values);
}

// Also false for a sphere that equals another: only the first of the two is drawn.
bool LiveLists::put_in(const Scene& scene, std::uint32_t number, std::optional<std::size_t> index, const glm::vec4& values) {
    const Sphere& sphere = scene.spheres[number];
    const bool is_twin = lists_.any_like(values, [&](std::uint32_t other) {
        const Sphere& candidate = scene.spheres[static_cast<std::size_t>(drawn_.number(other))];
        return candidate.center == sphere.center && candidate.radius == sphere.radius;
    });
    if (is_twin) return false;
    if (index) {
        drawn_.center_radius[*index] = values;
    } else {
        index = append(drawn_, number, values);
    }
    changed_spheres_.push_back(static_cast<std::uint32_t>(*index));
    return lists_.put_in(static_cast<std::uint32_t>(*index), values);
}

LiveLists::Changed LiveLists::take_changed() {
    Changed changed{std::exchange(changed_spheres_, {}), lists_.take_changes()};
    std::ranges::sort(changed.spheres);
    changed.spheres.erase(std::unique(changed.spheres.begin(), changed.spheres.end()), changed.spheres.end());
    std::ranges::sort(changed.candidates, {}, &Places::first);
    return changed;
}

}  // namespace sphereview
