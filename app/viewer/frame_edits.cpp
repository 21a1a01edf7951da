#include "viewer/frame_edits.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "viewer/frame_player.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

// Without what takes the most memory, and no edit changes.
Scene without_properties(const Scene& scene) {
    return {scene.spheres, scene.names, scene.background, scene.camera, scene.light, scene.views, {}};
}

bool same_places(const Scene& before, const Scene& after) {
    const auto same = [](const Sphere& a, const Sphere& b) { return same_bits(a.center, b.center); };
    return std::ranges::equal(before.spheres, after.spheres, same);
}

bool same_besides(const Scene& before, const Scene& after) {
    const auto same = [](const Sphere& a, const Sphere& b) { return same_bits(a, b); };
    return std::ranges::equal(before.spheres, after.spheres, same) && before.names == after.names &&
           before.background == after.background && same_bits(before.camera, after.camera) &&
           same_bits(before.light, after.light) && before.views == after.views;
}

void note_numbers(ViewerState& state) {
    state.player.edits.numbers_order = has_numbers_of_file(state) ? state.document.order_revision() : 0;
}

// The changes of the frame, and for spheres that it lacks those of others.
FrameChanges with_others(FrameChanges of_frame, std::size_t size, const FrameChanges& others) {
    of_frame.add_beyond(size, others);
    return of_frame;
}

// The frame before its edits as it would be with the colours and sizes by a property that are chosen now: other frames get these by
// their own values.
Scene with_chosen_look(ViewerState& state) {
    Scene scene = *state.player.edits.before;
    shown_coloring(state.document, state.side_panel.look);
    LookOptions look = load_options(state, state.path, state.frame).look;
    if (look.radius_scale) look.size_by.reset();  // the sizes are scaled already
    look.radii.reset();
    look.radius_scale.reset();
    if (!look.any()) return scene;
    scene.properties = state.scene().properties;
    try {
        apply_look(scene, look, state.name(), state.property_names);
    } catch (const InputError&) {  // a property that is not read: the look is not of this scene
    }
    return scene;
}

// Redoes what holds by number in other frames, as colours by a property do not.
std::optional<FrameChanges> redone_edits(ViewerState& state) {
    const FrameEdits& edits = state.player.edits;
    Document& document = state.document;
    if (!edits.before || !has_numbers_of_file(state) || (!edits.redone && !document.can_redo())) return std::nullopt;
    const Scene before = with_chosen_look(state);
    while (document.can_redo() && !document.redo_changes_order() && !state.look_steps.contains(document.redo_name()))
        document.redo();
    return with_others(changes_between(before, document.scene()), before.spheres.size(), edits.redone.value_or(edits.shared));
}

// Applies the changes as one step; returns whether there were any.
bool give(ViewerState& state, const FrameChanges& changes) {
    Document& document = state.document;
    const std::uint64_t before = document.revision();
    const std::uint64_t gesture = ++state.gesture;
    const auto apply = [&](Edit edit) { document.apply(std::move(edit), "Changes of all frames", gesture); };
    const std::size_t size = document.scene().spheres.size();
    ChangeSpheres change;
    for (const SphereChange& one : changes_within(changes, size)) {
        Sphere sphere = document.scene().spheres[one.number];
        sphere.color = one.color.value_or(sphere.color);
        sphere.radius = one.radius.value_or(sphere.radius);
        sphere.hidden = one.hidden.value_or(sphere.hidden);
        change.numbers.push_back(one.number);
        change.spheres.push_back(sphere);
    }
    if (!change.numbers.empty()) apply(std::move(change));
    for (const auto& [number, name] : changes.names) {
        if (number < size) apply(RenameSphere{number, name});
    }
    if (changes.background) apply(ChangeBackground{*changes.background});
    if (changes.camera) apply(ChangeCamera{*changes.camera});
    if (changes.light) apply(ChangeLight{*changes.light});
    if (changes.views) apply(ChangeViews{*changes.views});
    return document.revision() != before;
}

}  // namespace

FrameChanges shared_edits_now(ViewerState& state) {
    const FrameEdits& edits = state.player.edits;
    // Once spheres have come, gone or changed places no number tells anything: what was noted before that stays.
    if (!edits.before || !has_numbers_of_file(state)) return edits.shared;
    return with_others(changes_between(with_chosen_look(state), state.scene()), state.scene().spheres.size(), edits.shared);
}

void note_frame_before_edit(ViewerState& state, bool renumbers) {
    if (!has_several_frames(state)) return;
    FrameEdits& edits = state.player.edits;
    if (!edits.before) {
        edits.before = std::make_shared<const Scene>(without_properties(state.scene()));
        edits.judged_revision = 0;
    } else if (renumbers) {
        edits.shared = shared_edits_now(state);
    }
}

// Undoing a deletion brings the numbers back, but no revision.
bool has_numbers_of_file(const ViewerState& state) {
    if (state.document.order_revision() == state.file_order) return true;
    const FrameEdits& edits = state.player.edits;
    return edits.before && (state.document.order_revision() == edits.numbers_order || same_places(*edits.before, state.scene()));
}

EditsReach reach_of_edits(ViewerState& state) {
    FrameEdits& edits = state.player.edits;
    if (!edits.before) return edits.outdated ? EditsReach::this_frame : EditsReach::none;
    if (edits.judged_revision == state.document.revision()) return edits.judged;
    edits.judged_revision = state.document.revision();
    const bool is_as_read = same_besides(*edits.before, state.scene()) && !lacks_edited_spheres(state);
    edits.judged = edits.outdated || !same_places(*edits.before, state.scene()) ? EditsReach::this_frame
                   : is_as_read                                                 ? EditsReach::none
                                                                                : EditsReach::all_frames;
    return edits.judged;
}

bool lacks_edited_spheres(const ViewerState& state) {
    const FrameEdits& edits = state.player.edits;
    return edits.before && edits.shared.go_beyond(edits.before->spheres.size());
}

void note_edits_before_reload(ViewerState& state, const Scene& reloaded) {
    EditsBeyondReloads& reloads = state.player.reloads;
    reloads.edits.resize(reloads.done++);
    note_numbers(state);
    const bool same =
        state.player.edits.before ? same_besides(with_chosen_look(state), reloaded) : same_besides(state.scene(), reloaded);
    if (!same) {
        state.player.edits.outdated = true;
        for (FrameEdits& earlier : reloads.edits) earlier.outdated = true;
    }
    state.player.edits.redone.reset();  // a reload is a step: what was undone before it is gone
    reloads.edits.push_back(std::exchange(state.player.edits, {}));
}

void cross_reload(ViewerState& state, bool undoes, const std::function<void()>& step) {
    FramePlayer& player = state.player;
    note_numbers(state);
    step();
    std::swap(player.edits, player.reloads.edits.at(undoes ? --player.reloads.done : player.reloads.done++));
    if (player.edits.numbers_order != 0) player.edits.numbers_order = state.document.order_revision();
    state.autosave.shows_frame(state.document, lacks_edited_spheres(state));
}

void apply_recovered(ViewerState& state, Scene kept, bool has_numbers) {
    if (kept == state.scene()) return state.document.mark_unsaved();                   // other frames had more
    has_numbers = has_numbers && kept.spheres.size() == state.scene().spheres.size();  // whatever the file says
    note_frame_before_edit(state, false);
    note_edits_before_reload(state, state.scene());
    state.player.edits = state.player.reloads.edits.back();
    state.document.apply(ReplaceScene{std::move(kept)}, "Recovered changes");
    state.player.edits.numbers_order = has_numbers ? state.document.order_revision() : 0;
}

void take_shared_edits(ViewerState& state, std::size_t next_size) {
    FrameEdits& edits = state.player.edits;
    FrameChanges shared = shared_edits_now(state);
    // What it got from others is kept already.
    if (shared.go_beyond(next_size) && state.document.revision() != edits.given_revision) {
        state.autosave.keep_before_reading(state.document, edited_file(state));
    }
    if (state.document.can_redo()) note_frame_before_edit(state, false);  // a file that has grown may have been read since
    edits.redone = redone_edits(state);
    if (edits.redone == shared) edits.redone.reset();
    edits.shared = std::move(shared);
    edits.before.reset();
    state.player.reloads = {};
    edits.outdated = false;
}

void give_shared_edits(ViewerState& state) {
    FrameEdits& edits = state.player.edits;
    Document& document = state.document;
    if (edits.shared.any() || edits.redone) note_frame_before_edit(state, false);
    std::optional<Scene> redone;
    if (edits.redone) {
        give(state, *edits.redone);
        redone = without_properties(state.scene());
        document.undo();
    }
    give(state, edits.shared);
    if (redone && give(state, changes_between(state.scene(), *redone))) document.undo();
    const bool lacks_some = lacks_edited_spheres(state);
    if (lacks_some) document.mark_unsaved();
    edits.given_revision = document.revision();
    state.autosave.shows_frame(document, lacks_some);
}

}  // namespace sphereview
