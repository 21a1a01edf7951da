// What the edits of a frame mean to the other frames of its file: colours, radii, names, what is hidden, and what concerns the
// whole scene go along; places, and which spheres there are, are this frame's own.
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
    FrameChanges shared{};                  // of the frames that were shown before
    std::optional<FrameChanges> redone{};   // what that would be if all was redone that is undone and can be: where it is another
    std::shared_ptr<const Scene> before{};  // the frame that is shown, without edits; null while it has none. No properties
    EditsReach judged = EditsReach::none;   // of this revision of the document
    std::uint64_t judged_revision = 0;
    std::uint64_t given_revision = 0;  // of the document that has got what is shared and no edit of its own
    std::uint64_t numbers_order = 0;   // the document's order_revision() in which an undone reload gave numbers as in `before` back
    bool outdated = false;             // the file has the frame otherwise by now: a reload was undone
};

// Of the reloads of the file that undo and redo can reach: what the frames' edits are on the other side of each. The first `done`
// of them are not undone.
struct EditsBeyondReloads {
    std::vector<FrameEdits> edits{};
    std::size_t done = 0;
};

// To be called before an edit of the document, which may give spheres other numbers: remembers what the frame was.
void note_frame_before_edit(ViewerState& state, bool renumbers);

// What the edits of the frame that is shown apply to, those included that it got from others.
EditsReach reach_of_edits(ViewerState& state);

// Whether a sphere's number means here what it means in the file, so that what was changed by number holds in other frames.
bool has_numbers_of_file(const ViewerState& state);

// What the frame that is shown shares with all others: what it got from them included, and what they have for spheres that it
// lacks.
FrameChanges shared_edits_now(ViewerState& state);

// Whether some of that is for spheres that the frame that is shown lacks: the window has it, and no scene that is saved of this
// frame.
bool lacks_edited_spheres(const ViewerState& state);

// The frame that is shown is about to be replaced by what its file holds now, which has nothing of the edits: notes how they are,
// for who undoes that.
void note_edits_before_reload(ViewerState& state, const Scene& reloaded);
// That is to be undone, or redone, by `step`: so are the edits of all frames.
void cross_reload(ViewerState& state, bool undoes, const std::function<void()>& step);

// The frame that is shown, as it was read, becomes a scene that was kept of it, as a step that can be undone.
void apply_recovered(ViewerState& state, Scene kept, bool has_numbers);

// Another frame, of so many spheres, is about to be shown, and the document to be replaced: takes along what the present one
// shares, and what it would share if what is undone was redone. Leaves the document in any state.
void take_shared_edits(ViewerState& state, std::size_t next_size);
// Another frame is the document now: it gets what was taken along, as a step that can be undone, and one that can be redone.
void give_shared_edits(ViewerState& state);

}  // namespace sphereview
