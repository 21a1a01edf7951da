#include "formats/atoms.hpp"

#include <algorithm>
#include <utility>

#include "base/memory.hpp"
#include "base/text.hpp"
#include "scene/numbered.hpp"

namespace sphereview {

double radius_of(const Element& element, const DataOptions& options) {
    if (!options.radius) return element.radius;
    return is_virtual(element) ? std::min(element.radius, *options.radius) : *options.radius;
}

void remove_spheres(Scene& scene, std::span<const std::size_t> numbers) {
    if (numbers.empty()) return;
    const std::vector<std::uint32_t> gone(numbers.begin(), numbers.end());
    std::map<std::uint32_t, std::string> names;
    std::size_t before = 0;  // of those that go
    for (auto& [number, name] : scene.names) {
        while (before < gone.size() && gone[before] < number) ++before;
        const bool stays = before == gone.size() || gone[before] != number;
        if (stays) names.emplace_hint(names.end(), number - static_cast<std::uint32_t>(before), std::move(name));
    }
    scene.names = std::move(names);
    take_out(scene.spheres, gone);
    for (Property& property : scene.properties) remove_values(property, gone);
}

std::vector<std::size_t> numbers_without(std::span<const std::size_t> numbers, std::span<const std::size_t> gone) {
    std::vector<std::size_t> left;
    std::size_t before = 0;  // of those that go
    for (const std::size_t number : numbers) {
        while (before < gone.size() && gone[before] < number) ++before;
        if (before == gone.size() || gone[before] != number) left.push_back(number - before);
    }
    return left;
}

void require_memory_for_spheres(const std::string& name, std::size_t count, std::size_t bytes_of_each) {
    require_memory(count * bytes_of_each, name + ": " + in_groups(count) + " spheres need");
}

std::string early_end(const std::string& fault, std::int64_t frames) {
    return fault + "; what follows frame " + std::to_string(frames - 1) + " is passed over";
}

void warn_of_left_out(SphereData& data, std::size_t count, const std::string& name, const char* one, const char* several) {
    if (count == 0) return;
    data.warnings.push_back(name + ": " + in_groups(count) + " " + (count == 1 ? one : several) + (count == 1 ? " has" : " have") +
                            " no coordinates and " + (count == 1 ? "is" : "are") + " left out");
}

void settle_virtual_sites(SphereData& data, std::span<const std::size_t> sites, const std::string& name,
                          const DataOptions& options) {
    if (sites.empty()) return;
    const bool is_one = sites.size() == 1;
    data.warnings.push_back(
        name + ": found " + in_groups(sites.size()) +
        (is_one ? " virtual site or dummy, which is no atom; " : " virtual sites or dummies, which are no atoms; ") +
        (options.virtual_sites ? "shown small, or not with --no-virtual" : "left out"));
    if (!options.virtual_sites) {
        remove_spheres(data.scene, sites);
        return;
    }
    std::vector<Sphere>& spheres = data.scene.spheres;
    double most = virtual_site().radius;
    std::size_t before = 0;  // of the sites
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const bool is_site = before < sites.size() && sites[before] == i;
        if (is_site) ++before;
        if (!is_site) most = std::min(most, spheres[i].radius);
    }
    for (const std::size_t site : sites) spheres[site].radius = std::min(spheres[site].radius, most);
}

}  // namespace sphereview
