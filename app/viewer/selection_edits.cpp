#include "viewer/selection_edits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/sine_cosine.hpp"
#include "base/text.hpp"
#include "camera/navigation.hpp"
#include "edit/selection.hpp"
#include "formats/scene_format.hpp"
#include "panels/math_text.hpp"
#include "panels/widgets.hpp"
#include "scene/vectors.hpp"
#include "viewer/perform.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

std::string selected_in_words(const ViewerState& state) { return title_of(state.scene(), state.selection.numbers()); }

// Told apart at a glance, on black and on white.
constexpr std::array<Color, 7> new_colors = {
    {{230, 80, 60}, {70, 140, 230}, {90, 190, 90}, {240, 180, 50}, {160, 100, 210}, {60, 190, 190}, {230, 110, 170}}};

// Moves the sphere that way until no shown sphere's centre is in it and its own is in none: else it could not be seen. Returns
// whether it is so.
bool move_out_of_others(const Scene& scene, const glm::dvec3& direction, Sphere& sphere) {
    constexpr int most_moves = 100;  // in a crowd that ends somewhere
    for (int i = 0; i < most_moves; ++i) {
        const auto other = std::ranges::find_if(scene.spheres, [&](const Sphere& one) {
            return !one.hidden && glm::distance(one.center, sphere.center) < std::max(one.radius, sphere.radius);
        });
        if (other == scene.spheres.end()) return true;
        // To where the two touch, beyond the other's centre.
        const glm::dvec3 way = other->center - sphere.center;
        const double along = glm::dot(way, direction);
        const double reach = sphere.radius + other->radius;
        const double aside = reach * reach - (glm::dot(way, way) - along * along);
        const glm::dvec3 moved = sphere.center + (along + std::sqrt(std::max(aside, 0.0))) * direction;
        if (!std::isfinite(moved.x) || !std::isfinite(moved.y) || !std::isfinite(moved.z)) return false;
        sphere.center = moved;
    }
    return false;
}

// Of the places beside it, to all sides of the view, the nearest free one whose middle the picture shows; to the right where it
// shows none.
Sphere in_a_free_place(const ViewerState& state, const Sphere& sphere) {
    constexpr int ways = 8;
    const CameraAxes axes = camera_axes(state.camera);
    Sphere beside = sphere;
    move_out_of_others(state.scene(), axes.right, beside);
    std::optional<double> nearest;
    for (int i = 0; i < ways; ++i) {
        const auto [upward, rightward] = sine_cosine(i * 360.0 / ways);
        Sphere moved = sphere;
        if (!move_out_of_others(state.scene(), rightward * axes.right + upward * axes.up, moved)) continue;
        const auto place = place_of(state.camera, state.picture_size, moved.center);
        const bool is_seen = place && place->x > 0.0 && place->y > 0.0 && place->x < state.picture_size.width &&
                             place->y < state.picture_size.height;
        const double distance = glm::distance(moved.center, sphere.center);
        if (!is_seen || (nearest && *nearest <= distance)) continue;
        nearest = distance;
        beside = moved;
    }
    return beside;
}

// By one place in the list, up (-1) or down (1); needs one sphere and a place to go to.
EditScene reorder_selected(const ViewerState& state, int by) {
    const std::uint32_t from = state.selection.numbers().front();
    const std::uint32_t to = by < 0 ? from - 1 : from + 1;
    return {ReorderSphere{from, to}, "Move " + selected_in_words(state) + (by < 0 ? " up" : " down"), 0};
}

}  // namespace

EditScene add_sphere(const ViewerState& state) {
    const std::size_t count = state.scene().spheres.size();
    Sphere sphere;
    const double depth = std::max(depth_of(state.camera, state.pivot), 0.1);
    const glm::dvec2 middle(0.5 * state.picture_size.width, 0.5 * state.picture_size.height);
    sphere.center = point_at(state.camera, state.picture_size, middle, depth);
    // A tenth of what the picture's shorter side shows there.
    const glm::dvec2 beside = middle + glm::dvec2(0.1 * state.picture_size.shorter_side(), 0.0);
    sphere.radius = length_of(point_at(state.camera, state.picture_size, beside, depth) - sphere.center);
    sphere.color = new_colors[count % new_colors.size()];
    sphere.radius = rounded_to(sphere.radius, last_digit(sphere.radius, 3));
    sphere = in_a_free_place(state, sphere);
    // A thousandth of its size is less than anybody sees.
    for (int i = 0; i < 3; ++i) sphere.center[i] = rounded_to(sphere.center[i], last_digit(sphere.radius, 4)) + 0.0;
    return {InsertSpheres{{static_cast<std::uint32_t>(count)}, {{sphere, ""}}}, "Add sphere " + std::to_string(count), 0};
}

EditScene duplicate_selected(const ViewerState& state) {
    InsertSpheres insert;
    auto next = static_cast<std::uint32_t>(state.scene().spheres.size());
    const glm::dvec3 right = camera_axes(state.camera).right;  // beside the original, where the copy can be seen
    for (const std::uint32_t number : state.selection.numbers()) {
        NamedSphere copy{state.scene().spheres[number], name_of(state.scene(), number)};
        if (!copy.name.empty()) copy.name += " copy";
        copy.sphere.center += copy.sphere.radius * right;
        insert.numbers.push_back(next++);
        insert.spheres.push_back(std::move(copy));
    }
    for (const Property& property : state.scene().properties) {
        insert.properties.push_back(values_of(property, state.selection.numbers()));
    }
    return {std::move(insert), "Duplicate " + selected_in_words(state), 0};
}

EditScene remove_selected(const ViewerState& state) {
    return {RemoveSpheres{state.selection.numbers()}, "Delete " + selected_in_words(state), 0};
}

EditScene hide_or_show_selected(const ViewerState& state) { return hide_or_show(state.scene(), state.selection.numbers()); }

EditScene move_up(const ViewerState& state) { return reorder_selected(state, -1); }
EditScene move_down(const ViewerState& state) { return reorder_selected(state, 1); }

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
