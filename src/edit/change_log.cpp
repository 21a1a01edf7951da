#include "edit/change_log.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "scene/scene.hpp"

namespace sphereview {

namespace {

// The spheres that two scenes have under the same number with different values: the old ones.
ChangeSpheres differing(const std::vector<Sphere>& before, const std::vector<Sphere>& now) {
    ChangeSpheres old;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (same_bits(before[i], now[i])) continue;
        old.numbers.push_back(static_cast<std::uint32_t>(i));
        old.spheres.push_back(before[i]);
    }
    return old;
}

// Notes the change of `old` values; `scene` has the new ones.
void note_spheres(const ChangeSpheres& old, const Scene& scene, LoggedChange& change) {
    if (old.numbers.size() <= ChangeLog::most_spheres) {
        change.spheres = old;
        return;
    }
    change.many = true;
    for (std::size_t i = 0; i < old.numbers.size() && !change.many_geometry; ++i) {
        change.many_geometry = !same_geometry(old.spheres[i], scene.spheres[old.numbers[i]]);
    }
}

// Adds the spheres that differ from their old values. `changes`: one after another, the oldest first. Of a sphere that changed
// several times, the first has the old value.
void compare_spheres(const std::vector<const ChangeSpheres*>& changes, const Scene& scene, ChangesSince& result) {
    const auto compare = [&](std::uint32_t number, const Sphere& before) {
        const Sphere& now = scene.spheres[number];
        if (same_bits(before, now)) return;
        result.spheres.push_back(number);
        result.geometry = result.geometry || !same_geometry(before, now);
    };
    // The usual one needs no sorting.
    if (changes.size() == 1) {
        const ChangeSpheres& only = *changes.front();
        for (std::size_t i = 0; i < only.numbers.size(); ++i) compare(only.numbers[i], only.spheres[i]);
        return;
    }
    std::vector<std::pair<std::uint32_t, const Sphere*>> all;
    for (const ChangeSpheres* change : changes) {
        for (std::size_t i = 0; i < change->numbers.size(); ++i) all.emplace_back(change->numbers[i], &change->spheres[i]);
    }
    std::ranges::stable_sort(all, {}, [](const auto& one) { return one.first; });
    // Not std::ranges::unique, which Clang 14 cannot compile with the library of GCC 12.
    const auto same_number = [](const auto& a, const auto& b) { return a.first == b.first; };
    all.erase(std::unique(all.begin(), all.end(), same_number), all.end());
    for (const auto& [number, before] : all) compare(number, *before);
}

}  // namespace

LoggedChange change_undone_by(const Edit& inverse, const Scene& scene) {
    LoggedChange change;
    if (const auto* spheres = std::get_if<ChangeSpheres>(&inverse)) {
        note_spheres(*spheres, scene, change);
    } else if (const auto* camera = std::get_if<ChangeCamera>(&inverse)) {
        change.camera = camera->camera;
    } else if (const auto* background = std::get_if<ChangeBackground>(&inverse)) {
        change.background = background->background;
    } else if (const auto* light = std::get_if<ChangeLight>(&inverse)) {
        change.light = light->light;
    } else if (const auto* replace = std::get_if<ReplaceScene>(&inverse)) {
        change.camera = replace->scene.camera;
        change.background = replace->scene.background;
        change.light = replace->scene.light;
        change.order = replace->scene.spheres.size() != scene.spheres.size();
        if (!change.order) note_spheres(differing(replace->scene.spheres, scene.spheres), scene, change);
    } else {
        change.order = !std::holds_alternative<RenameSphere>(inverse) && !std::holds_alternative<ChangeViews>(inverse);
        const auto* insert = std::get_if<InsertSpheres>(&inverse);
        const auto* remove = std::get_if<RemoveSpheres>(&inverse);
        if (insert != nullptr && insert->numbers.size() <= ChangeLog::most_spheres) change.went = insert->numbers;
        if (remove != nullptr && remove->numbers.size() <= ChangeLog::most_spheres) change.came = remove->numbers;
    }
    return change;
}

std::size_t ChangeLog::weight(const LoggedChange& change) {
    return change.spheres.numbers.size() + change.came.size() + change.went.size();
}

void ChangeLog::add(std::uint64_t revision, LoggedChange change) {
    sphere_count_ += weight(change);
    entries_.push_back({revision, std::move(change)});
    while (entries_.size() > most_changes || sphere_count_ > most_spheres) {
        sphere_count_ -= weight(entries_.front().change);
        entries_.pop_front();
    }
}

ChangesSince ChangeLog::since(std::uint64_t revision, const Scene& scene) const {
    const auto first = std::ranges::lower_bound(entries_, revision, {}, &Entry::revision);
    if (first == entries_.end() || first->revision != revision) {
        ChangesSince everything;
        everything.order = everything.geometry = everything.camera = everything.background = everything.light = true;
        return everything;
    }
    ChangesSince result;
    const Camera* old_camera = &scene.camera;
    const Background* old_background = &scene.background;
    const Light* old_light = &scene.light;
    bool many = false;
    bool many_geometry = false;
    std::vector<const ChangeSpheres*> sphere_changes;
    const LoggedChange* order = nullptr;  // the change of the order, where there is one only
    int order_changes = 0;
    for (auto entry = entries_.end(); entry != first;) {
        const LoggedChange& change = (--entry)->change;
        if (change.order) {
            order = &change;
            ++order_changes;
        }
        if (change.camera) old_camera = &*change.camera;
        if (change.background) old_background = &*change.background;
        if (change.light) old_light = &*change.light;
        many = many || change.many;
        many_geometry = many_geometry || change.many_geometry;
        if (change.spheres.numbers.empty()) continue;
        // A drag changes the same spheres again and again: what is older says all.
        if (!sphere_changes.empty() && sphere_changes.back()->numbers == change.spheres.numbers) sphere_changes.pop_back();
        sphere_changes.push_back(&change.spheres);
    }
    result.order = order_changes > 0;
    if (order_changes == 1 && sphere_changes.empty() && !many) {
        result.came = order->came;
        result.went = order->went;
    }
    result.camera = !same_bits(*old_camera, scene.camera);
    result.background = *old_background != scene.background;
    result.light = !same_bits(*old_light, scene.light);
    result.geometry = result.order;
    std::ranges::reverse(sphere_changes);
    if (!result.order && !sphere_changes.empty()) compare_spheres(sphere_changes, scene, result);
    if (!result.order && many) {
        result.geometry = result.geometry || many_geometry;
        result.spheres.resize(scene.spheres.size());
        std::iota(result.spheres.begin(), result.spheres.end(), 0U);
    }
    return result;
}

}  // namespace sphereview
