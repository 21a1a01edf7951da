#include "formats/atoms.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/memory.hpp"
#include "base/text.hpp"
#include "scene/numbered.hpp"

namespace sphereview {

namespace {

// The spheres of these numbers become no larger than a virtual site, nor than the smallest of the others.
void make_small(std::vector<Sphere>& spheres, std::span<const std::size_t> numbers) {
    if (numbers.empty()) return;
    double most = virtual_site().radius;
    auto next = numbers.begin();
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        if (next != numbers.end() && *next == i) {
            ++next;
        } else {
            most = std::min(most, spheres[i].radius);
        }
    }
    for (const std::size_t number : numbers) spheres[number].radius = std::min(spheres[number].radius, most);
}

}  // namespace

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

void warn_of_virtual_sites(SphereData& data, std::size_t count, const std::string& name, const DataOptions& options) {
    if (count == 0) return;
    data.warnings.push_back(
        name + ": found " + in_groups(count) +
        (count == 1 ? " virtual site or dummy, which is no atom; " : " virtual sites or dummies, which are no atoms; ") +
        (options.virtual_sites ? "shown small, or not with --no-virtual" : "left out"));
}

void finish_virtual_sites(SphereData& data, std::span<const std::size_t> numbers, const std::string& name,
                          const DataOptions& options, std::span<const std::size_t> left_out) {
    warn_of_virtual_sites(data, numbers.size(), name, options);
    std::vector<std::size_t> gone(left_out.begin(), left_out.end());
    if (options.virtual_sites) {
        make_small(data.scene.spheres, numbers);
    } else {
        gone.clear();
        std::ranges::merge(numbers, left_out, std::back_inserter(gone));
    }
    remove_spheres(data.scene, gone);
}

}  // namespace sphereview
