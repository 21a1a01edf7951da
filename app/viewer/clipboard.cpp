#include "viewer/clipboard.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "formats/scene_format.hpp"
#include "panels/math_text.hpp"
#include "viewer/command_table.hpp"
#include "viewer/perform.hpp"

namespace sphereview {

namespace {

// An X server takes no more at once, and drops a longer text without a word.
constexpr std::size_t most_copied = 15'000'000;  // bytes

Scene selected_spheres(const ViewerState& state) {
    Scene copied;
    for (const std::uint32_t number : state.selection.numbers()) {
        const std::string name = name_of(state.scene(), number);
        if (!name.empty()) copied.names[static_cast<std::uint32_t>(copied.spheres.size())] = name;
        copied.spheres.push_back(state.scene().spheres[number]);
    }
    for (const Property& property : state.scene().properties) {
        copied.properties.push_back(values_of(property, state.selection.numbers()));
    }
    return copied;
}

using Place = std::array<double, 4>;

Place place_of(const Sphere& sphere, const glm::dvec3& by = {}) {
    return {sphere.center.x + by.x, sphere.center.y + by.y, sphere.center.z + by.z, sphere.radius};
}

// How far to the right the spheres are to be moved together, so that none has the centre and the radius of one that is there
// already: of two such spheres one is never seen.
glm::dvec3 way_to_free_places(const ViewerState& state, const std::vector<Sphere>& pasted) {
    std::vector<Place> taken;
    taken.reserve(state.scene().spheres.size());
    for (const Sphere& sphere : state.scene().spheres) taken.push_back(place_of(sphere));
    std::ranges::sort(taken);
    double step = 0.0;
    for (const Sphere& sphere : pasted) step = std::max(step, sphere.radius);
    const glm::dvec3 right = camera_axes(state.camera).right;
    constexpr int most_steps = 1000;
    for (int i = 0; i < most_steps; ++i) {
        const glm::dvec3 by = i * step * right;
        const auto is_taken = [&](const Sphere& sphere) { return std::ranges::binary_search(taken, place_of(sphere, by)); };
        if (std::ranges::none_of(pasted, is_taken)) return by;
    }
    return {};
}

}  // namespace

bool copy_selected(ViewerState& state) {
    const Scene copied = selected_spheres(state);
    const SceneFormat& format = lost_in(copied, SceneFormat::text).empty() ? SceneFormat::text : SceneFormat::toml;
    const std::string text = write_scene(copied, format);
    if (text.size() > most_copied) {
        announce(state, "Not copied: " + counted(copied.spheres.size(), "sphere") + " are too many for the clipboard.");
        return false;
    }
    state.clipboard.set_text(text);
    announce(state, "Copied " + title_of(state.scene(), state.selection.numbers()) + " as text.");
    return true;
}

void cut_selected(ViewerState& state) {
    if (copy_selected(state)) run_command(state, CommandId::remove);
}

void paste(ViewerState& state) {
    const std::string text = state.clipboard.text();
    Scene pasted;
    try {
        if (!text.empty()) pasted = parse_scene(text, "clipboard");
    } catch (const InputError& error) {
        announce(state, std::string("Nothing to paste: ") + error.what());
        return;
    } catch (const MemoryError& error) {
        announce(state, std::string("Nothing to paste: ") + error.what());
        return;
    }
    if (pasted.spheres.empty()) {
        announce(state, text.empty() ? "Nothing to paste: the clipboard holds no text." : "Nothing to paste: no sphere.");
        return;
    }
    const glm::dvec3 by = way_to_free_places(state, pasted.spheres);
    InsertSpheres insert;
    auto next = static_cast<std::uint32_t>(state.scene().spheres.size());
    for (std::uint32_t i = 0; i < pasted.spheres.size(); ++i) {
        NamedSphere added{pasted.spheres[i], name_of(pasted, i)};
        added.sphere.center += by;
        insert.numbers.push_back(next++);
        insert.spheres.push_back(std::move(added));
    }
    insert.properties = std::move(pasted.properties);
    const std::string what = "Paste " + counted(pasted.spheres.size(), "sphere");
    perform(state, {EditScene{std::move(insert), what, 0}});
    if (by == glm::dvec3(0.0)) return;
    announce(state, "Pasted beside where they were, by " + vector_text(by, 4) + ": the same spheres stand there already.");
}

}  // namespace sphereview
