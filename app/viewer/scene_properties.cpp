#include "viewer/scene_properties.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "base/text.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

std::array<double, 3> place_of(const std::vector<Sphere>& spheres, std::uint32_t number) {
    const glm::dvec3& center = spheres[number].center;
    return {center.x, center.y, center.z};
}

auto key_of(const std::vector<Sphere>& spheres, std::uint32_t number) { return std::pair(place_of(spheres, number), number); }

auto is_unread(const ViewerState& state) {
    return [&state](const std::string& name) { return find_property(state.scene().properties, name) == nullptr; };
}

// What is not read is no choice any more.
void forget_unread(ViewerState& state) {
    state.all_properties = false;
    std::erase_if(state.property_names, is_unread(state));
}

using Numbers = std::vector<std::uint32_t>;

// The spheres' numbers, sorted by place, then by number.
Numbers by_place(const std::vector<Sphere>& spheres) {
    Numbers numbers(spheres.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    std::ranges::sort(numbers, [&](std::uint32_t a, std::uint32_t b) { return key_of(spheres, a) < key_of(spheres, b); });
    return numbers;
}

// Makes the properties of a file's scene those of `spheres`, of which some have come, gone or got other numbers since the file was
// read: one that is where the file has one gets its values. Returns how many get none.
std::size_t give_to_spheres_of_file(Scene& file, const std::vector<Sphere>& spheres) {
    const Numbers theirs = by_place(file.spheres);
    const auto place_in_file = [&](std::uint32_t number) { return place_of(file.spheres, number); };
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    Numbers in_file(spheres.size(), none);
    auto next = theirs.begin();
    for (const std::uint32_t number : by_place(spheres)) {
        const auto place = place_of(spheres, number);
        next = std::find_if(next, theirs.end(), [&](std::uint32_t other) { return !(place_in_file(other) < place); });
        if (next == theirs.end()) break;
        if (place_in_file(*next) == place) in_file[number] = *next++;
    }
    Numbers found;
    Numbers without;
    for (std::uint32_t i = 0; i < in_file.size(); ++i) {
        if (in_file[i] == none) {
            without.push_back(i);
        } else {
            found.push_back(in_file[i]);
        }
    }
    for (Property& property : file.properties) {
        property = values_of(property, found);
        insert_values(property, without, nullptr);
    }
    return without.size();
}

}  // namespace

void note_properties(ViewerState& state, const LoadedScene& loaded) {
    state.property_names = loaded.property_names;
    state.file_order = state.document.order_revision();
}

bool has_unread_properties(const ViewerState& state) { return std::ranges::any_of(state.property_names, is_unread(state)); }

std::vector<std::string> told_properties(const ViewerState& state) {
    if (!state.panel_shown) return {};
    std::vector<std::string> names = state.side_panel.search.compared();
    if (const auto& shown = state.side_panel.look.shown) names.push_back(shown->property);
    return names;
}

void request_properties(ViewerState& state) {
    if (state.loading || state.saving || !has_unread_properties(state)) return;
    const auto refuse = [&state](const std::string& why) {
        forget_unread(state);
        announce(state, "The properties of the spheres cannot be read: " + why);
    };
    if (state.path.empty()) return refuse("the scene has no file");
    state.all_properties = true;
    const auto accept = [&state, refuse](LoadedScene loaded) {
        // The file's new content comes with its properties.
        if (file_states(state.path) != state.stamp) return look_at_file(state);
        const bool same =
            state.document.order_revision() == state.file_order && loaded.scene.spheres.size() == state.scene().spheres.size();
        if (!same) {
            const std::size_t without = give_to_spheres_of_file(loaded.scene, state.scene().spheres);
            if (without == state.scene().spheres.size()) return refuse("none of the spheres is where the file has one");
            if (without > 0) {
                announce(state, in_groups(without) + (without == 1 ? " sphere has" : " spheres have") +
                                    " no values: added or moved since the file was read");
            }
        }
        state.property_names = std::move(loaded.property_names);
        state.document.add_properties(std::move(loaded.scene.properties));
        forget_unread(state);
        state.all_properties = true;
    };
    start_loading(state, {.path = state.path,
                          .options = load_options(state, state.path, state.frame),
                          .accept = accept,
                          .fail = refuse,
                          .cancel = [&state] { forget_unread(state); }});
}

}  // namespace sphereview
