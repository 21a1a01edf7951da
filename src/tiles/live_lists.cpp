#include "tiles/live_lists.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <span>
#include <utility>

namespace sphereview {

namespace {

constexpr std::size_t most_twin_tests = 1 << 18;

void spell_out(std::vector<std::int32_t>& numbers, std::size_t count) {
    if (!numbers.empty()) return;
    numbers.reserve(count + DrawnSpheres::room_for_late);
    numbers.resize(count);
    std::iota(numbers.begin(), numbers.end(), 0);
}

// Gives each number of at least `first` another one; so many of the numbers are ascending.
template <typename Renumber>
void renumber(std::vector<std::int32_t>& numbers, std::size_t in_order, std::int32_t first, const Renumber& renumbered) {
    const auto end = numbers.begin() + static_cast<std::ptrdiff_t>(in_order);
    for (auto number = std::lower_bound(numbers.begin(), end, first); number != numbers.end(); ++number) {
        *number = *number >= first ? renumbered(*number) : *number;
    }
}

template <typename Renumber>
void renumber(DrawnSpheres& drawn, std::int32_t first, const Renumber& renumbered) {
    spell_out(drawn.numbers, drawn.size());
    renumber(drawn.numbers, drawn.numbers.size() - drawn.late, first, renumbered);
    renumber(drawn.twins, drawn.twins.size(), first, renumbered);
}

bool is_one_run(std::span<const std::uint32_t> numbers) { return numbers.back() - numbers.front() + 1 == numbers.size(); }

// Gives all other spheres their present numbers after spheres with these numbers, ascending, came into the scene
// (ChangesSince::came).
void renumber_for_came(DrawnSpheres& drawn, std::span<const std::uint32_t> numbers) {
    if (numbers.empty()) return;
    // At the end of a scene that is drawn as it is, nothing changes.
    if (drawn.numbers.empty() && numbers.front() >= drawn.size()) return;
    const auto first = static_cast<std::int32_t>(numbers.front());
    const auto count = static_cast<std::int32_t>(numbers.size());
    if (is_one_run(numbers)) {
        renumber(drawn, first, [=](std::int32_t number) { return number + count; });
        return;
    }
    // The i-th that came is before what was number numbers[i] - i.
    std::vector<std::int32_t> before;
    before.reserve(numbers.size());
    for (std::int32_t i = 0; i < count; ++i) before.push_back(static_cast<std::int32_t>(numbers[static_cast<std::size_t>(i)]) - i);
    renumber(drawn, first, [&](std::int32_t number) {
        return number + static_cast<std::int32_t>(std::ranges::upper_bound(before, number) - before.begin());
    });
}

// The same after they went out of it (ChangesSince::went).
void renumber_for_went(DrawnSpheres& drawn, std::span<const std::uint32_t> numbers) {
    if (numbers.empty()) return;
    std::erase_if(drawn.twins,
                  [&](std::int32_t number) { return std::ranges::binary_search(numbers, static_cast<std::uint32_t>(number)); });
    const auto first = static_cast<std::int32_t>(numbers.front());
    const auto count = static_cast<std::int32_t>(numbers.size());
    if (is_one_run(numbers)) {
        renumber(drawn, first, [=](std::int32_t number) { return std::max(number - count, first); });
        return;
    }
    renumber(drawn, first, [&](std::int32_t number) {
        const auto went = std::ranges::lower_bound(numbers, static_cast<std::uint32_t>(number)) - numbers.begin();
        return number - static_cast<std::int32_t>(went);
    });
}

// Ends the drawing of a sphere: its index becomes a gap.
void drop(DrawnSpheres& drawn, std::size_t index) {
    const auto gap = static_cast<std::uint32_t>(index);
    drawn.gone.insert(std::ranges::lower_bound(drawn.gone, gap), gap);
}

// Begins to draw the sphere that has the number now. Returns its index, which is new.
std::size_t append(DrawnSpheres& drawn, std::uint32_t number, const glm::vec4& center_radius) {
    const std::size_t index = drawn.size();
    if (!drawn.numbers.empty() || number != index) {
        spell_out(drawn.numbers, index);
        drawn.numbers.push_back(static_cast<std::int32_t>(number));
        ++drawn.late;
    }
    drawn.center_radius.push_back(center_radius);
    return index;
}

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
