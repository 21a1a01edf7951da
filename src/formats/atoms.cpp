#include "formats/atoms.hpp"

#include <algorithm>
#include <utility>

#include "base/memory.hpp"
#include "base/text.hpp"

namespace sphereview {

double radius_of(const Element& element, const DataOptions& options) {
    if (!options.radius) return element.radius;
    return is_virtual(element) ? std::min(element.radius, *options.radius) : *options.radius;
}

void remove_spheres(Scene& scene, std::span<const std::size_t> numbers) {
    if (numbers.empty()) return;
    std::map<std::uint32_t, std::string> names;
    auto name = scene.names.begin();
    auto removed = numbers.begin();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const bool is_named = name != scene.names.end() && name->first == i;
        const auto own = is_named ? name++ : name;
        if (removed != numbers.end() && *removed == i) {
            ++removed;
            continue;
        }
        if (is_named) names.emplace_hint(names.end(), static_cast<std::uint32_t>(kept), std::move(own->second));
        scene.spheres[kept++] = scene.spheres[i];
    }
    scene.spheres.resize(kept);
    scene.names = std::move(names);
    if (scene.properties.empty()) return;
    const std::vector<std::uint32_t> gone(numbers.begin(), numbers.end());
    for (Property& property : scene.properties) remove_values(property, gone);
}

void require_memory_for_spheres(const std::string& name, std::size_t count, std::size_t bytes_of_each) {
    require_memory(count * bytes_of_each, name + ": " + in_groups(count) + " spheres need");
}

void warn_of_left_out(SphereData& data, std::size_t count, const std::string& name, const char* one, const char* several) {
    if (count == 0) return;
    data.warnings.push_back(name + ": " + in_groups(count) + " " + (count == 1 ? one : several) + (count == 1 ? " has" : " have") +
                            " no coordinates and " + (count == 1 ? "is" : "are") + " left out");
}

void warn_of_virtual_sites(SphereData& data, std::size_t count, const std::string& name, const DataOptions& options) {
    if (count == 0) return;
    data.warnings.push_back(
        name + ": found " + in_groups(count) +
        (count == 1 ? " virtual site or dummy, which is no atom; " : " virtual sites or dummies, which are no atoms; ") +
        (options.virtual_sites ? "shown small, or not with --no-virtual" : "left out"));
}

}  // namespace sphereview
