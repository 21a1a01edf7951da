#include "unit/random_edit.hpp"

#include <algorithm>
#include <utility>

#include "unit/random_scene.hpp"

namespace sphereview {

namespace {

using Random = std::mt19937_64;

std::uint32_t random_number(Random& random, std::size_t count) {
    switch (below(random, 4)) {
        case 0: return 0;
        case 1: return static_cast<std::uint32_t>(count - 1);
        default: return static_cast<std::uint32_t>(below(random, count));
    }
}

std::string name_at(const Scene& scene, std::uint32_t number) {
    const auto name = scene.names.find(number);
    return name == scene.names.end() ? "" : name->second;
}

// A sphere, perhaps with a name, as a random scene has it.
NamedSphere random_sphere(Random& random) {
    while (true) {
        const Scene scene = random_scene(random);
        if (scene.spheres.empty() || scene.spheres.size() > 10) continue;
        const std::uint32_t number = random_number(random, scene.spheres.size());
        return {scene.spheres[number], name_at(scene, number)};
    }
}

// Another value for a sphere: another one altogether, a little different, or the same.
Sphere random_change(Random& random, Sphere sphere) {
    switch (below(random, 5)) {
        case 0: return sphere;
        case 1: sphere.color.g = static_cast<std::uint8_t>(random()); return sphere;
        case 2: sphere.hidden = !sphere.hidden; return sphere;
        case 3: sphere.center.y = -sphere.center.y; return sphere;  // 0 to -0, too
        default: return random_sphere(random).sphere;
    }
}

ChangeSpheres random_changes(Random& random, const Scene& scene) {
    ChangeSpheres edit{random_numbers(random, scene.spheres.size()), {}};
    for (const std::uint32_t number : edit.numbers) edit.spheres.push_back(random_change(random, scene.spheres[number]));
    return edit;
}

InsertSpheres random_insertion(Random& random, const Scene& scene) {
    const std::size_t count = one_in(random, 4) ? scene.spheres.size() + 1 : below(random, 4);
    InsertSpheres edit;
    const std::size_t end = scene.spheres.size() + count;
    while (edit.numbers.size() < count) {
        const std::uint32_t number = random_number(random, end);
        const auto place = std::ranges::lower_bound(edit.numbers, number);
        if (place == edit.numbers.end() || *place != number) edit.numbers.insert(place, number);
    }
    for (std::size_t i = 0; i < count; ++i) edit.spheres.push_back(random_sphere(random));
    return edit;
}

Light random_light(Random& random) {
    Light light;
    if (one_in(random, 2)) light.lights = static_cast<int>(16 + below(random, 3));
    if (one_in(random, 2)) light.sky = one_in(random, 2) ? 0.0 : 0.5;
    if (one_in(random, 2)) light.key = one_in(random, 2) ? -0.0 : 0.25;
    if (one_in(random, 2)) light.sun = Sun{{1.0, one_in(random, 2) ? 0.0 : -0.0, 0.0}, one_in(random, 2) ? 1.0 : 2.0};
    return light;
}

struct Edited {
    Scene scene;

    // Names beside the spheres, so that they go along by themselves.
    std::vector<NamedSphere> list() const {
        std::vector<NamedSphere> all;
        for (std::uint32_t i = 0; i < scene.spheres.size(); ++i) all.push_back({scene.spheres[i], name_at(scene, i)});
        return all;
    }
    void set(const std::vector<NamedSphere>& all) {
        scene.spheres.clear();
        scene.names.clear();
        for (const NamedSphere& sphere : all) {
            if (!sphere.name.empty()) scene.names[static_cast<std::uint32_t>(scene.spheres.size())] = sphere.name;
            scene.spheres.push_back(sphere.sphere);
        }
    }

    void operator()(const ChangeSpheres& edit) {
        for (std::size_t i = 0; i < edit.numbers.size(); ++i) scene.spheres[edit.numbers[i]] = edit.spheres[i];
    }
    void operator()(const InsertSpheres& edit) {
        auto all = list();
        for (std::size_t i = 0; i < edit.numbers.size(); ++i) all.insert(all.begin() + edit.numbers[i], edit.spheres[i]);
        set(all);
    }
    void operator()(const RemoveSpheres& edit) {
        auto all = list();
        for (std::size_t i = edit.numbers.size(); i-- > 0;) all.erase(all.begin() + edit.numbers[i]);
        set(all);
    }
    void operator()(const ReorderSphere& edit) {
        auto all = list();
        const NamedSphere moved = all[edit.from];
        all.erase(all.begin() + edit.from);
        all.insert(all.begin() + edit.to, moved);
        set(all);
    }
    void operator()(const RenameSphere& edit) {
        auto all = list();
        all[edit.number].name = edit.name;
        set(all);
    }
    void operator()(const ChangeCamera& edit) { scene.camera = edit.camera; }
    void operator()(const ChangeBackground& edit) { scene.background = edit.background; }
    void operator()(const ChangeLight& edit) { scene.light = edit.light; }
    void operator()(const ChangeViews& edit) { scene.views = edit.views; }
    void operator()(const ReplaceScene& edit) { scene = edit.scene; }
};

}  // namespace

std::vector<std::uint32_t> random_numbers(std::mt19937_64& random, std::size_t count) {
    if (count == 0) return {};
    std::vector<std::uint32_t> numbers;
    switch (below(random, 6)) {
        case 0: return {};
        case 1: return {0};
        case 2: return {static_cast<std::uint32_t>(count - 1)};
        case 3:
            for (std::uint32_t i = 0; i < count; ++i) numbers.push_back(i);
            return numbers;
        default:
            for (std::uint32_t i = 0; i < count; ++i) {
                if (one_in(random, 2)) numbers.push_back(i);
            }
            return numbers;
    }
}

Edit random_edit(std::mt19937_64& random, const Scene& scene) {
    const std::size_t count = scene.spheres.size();
    switch (below(random, 18)) {
        case 0:
        case 1: return random_insertion(random, scene);
        case 2:
        case 3: return RemoveSpheres{random_numbers(random, count)};
        case 4:
            if (count == 0) return RemoveSpheres{};
            return ReorderSphere{random_number(random, count), random_number(random, count)};
        case 5:
        case 6: {
            if (count == 0) return InsertSpheres{};
            const std::uint32_t number = random_number(random, count);
            return RenameSphere{number, one_in(random, 4) ? name_at(scene, number) : random_sphere(random).name};
        }
        case 7: return ChangeCamera{one_in(random, 4) ? scene.camera : random_scene(random).camera};
        case 8: return ChangeBackground{random_scene(random).background};
        case 9: {
            if (one_in(random, 2)) return ReplaceScene{random_scene(random)};
            // As an editor leaves a file: much is as it was.
            Scene other = edited(random_changes(random, scene), scene);
            if (one_in(random, 2)) other.names.clear();
            if (one_in(random, 2)) other.light = random_light(random);
            return ReplaceScene{std::move(other)};
        }
        case 10: return ChangeLight{one_in(random, 4) ? scene.light : random_light(random)};
        case 11: return ChangeViews{one_in(random, 4) ? scene.views : random_scene(random).views};
        default: return random_changes(random, scene);
    }
}

Scene edited(const Edit& edit, const Scene& scene) {
    Edited result{scene};
    std::visit(result, edit);
    return std::move(result.scene);
}

}  // namespace sphereview
