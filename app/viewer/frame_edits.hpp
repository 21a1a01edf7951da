// What the edits of a frame mean to the other frames of its file. Changes of colours, radii, names, hidden spheres and of the whole
// scene hold in all frames. Moved, added and deleted spheres change their own frame alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/frame_changes.hpp"
#include "panels/timeline.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct ViewerState;

// What the viewer remembers of the edits of frames.
struct FrameEdits {
    FrameChanges shared{};                  // made in the frames that were shown before
    std::optional<FrameChanges> redone{};   // `shared` after every possible redo, where that differs
    std::shared_ptr<const Scene> before{};  // the shown frame without edits and properties; null without edits
    EditsReach judged = EditsReach::none;   // at `judged_revision` of the document
    std::uint64_t judged_revision = 0;
    std::uint64_t given_revision = 0;  // the document with the shared changes and no edit of its own
    std::uint64_t numbers_order = 0;   // order_revision() at which an undone reload restored the numbers of `before`
    bool outdated = false;             // the file's frame is another by now: a reload was undone
};

// For each reload of the file that undo and redo can reach, the frames' edits on its other side. The first `done` reloads are not
// undone.
struct EditsBeyondReloads {
    std::vector<FrameEdits> edits{};
    std::size_t done = 0;
};

// Remembers the frame without edits. Call before each edit of the document; `renumbers`: the edit gives spheres other numbers.
void note_frame_before_edit(ViewerState& state, bool renumbers);

// What the edits of the shown frame apply to, including the edits that it got from other frames.
EditsReach reach_of_edits(ViewerState& state);

// Whether each sphere still has its number of the file, so that changes by number hold in other frames.
bool has_numbers_of_file(const ViewerState& state);

// The changes that the shown frame shares with all others, including those that it got from them and those of spheres that it
// lacks.
FrameChanges shared_edits_now(ViewerState& state);

// Whether some shared changes are of spheres that the shown frame lacks. A saved scene of this frame would not have these changes.
bool lacks_edited_spheres(const ViewerState& state);

// Notes the edits, for a later undo, before the shown frame is read from its file again, which has none of them.
void note_edits_before_reload(ViewerState& state, const Scene& reloaded);
// Undoes or redoes such a reload by `step`, and with it restores the edits of all frames.
void cross_reload(ViewerState& state, bool undoes, const std::function<void()>& step);

// Replaces the shown frame, as it was read, by the scene that was kept of it, as a step that can be undone.
void apply_recovered(ViewerState& state, Scene kept, bool has_numbers);

// Collects the shared changes of the document, and those that a redo would bring back, before a frame of `next_size` spheres
// replaces the document. Leaves the document in an undefined state.
void take_shared_edits(ViewerState& state, std::size_t next_size);
// Applies the collected changes to the new frame, as a step that can be undone, and one that can be redone.
void give_shared_edits(ViewerState& state);

}  // namespace sphereview
