// What the edits of a frame mean to the other frames of its file: colours, radii, names, what is hidden, and what concerns the
// whole scene go along; places, and which spheres there are, are this frame's own.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/frame_changes.hpp"
#include "panels/timeline.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct ViewerState;

// What goes along.
struct SharedEdits {
    std::size_t frame_size = 0;                    // frames of so many spheres get
    std::vector<SphereChange> spheres{};           // these, by number,
    std::map<std::uint32_t, std::string> names{};  // and these
    // All frames.
    std::optional<Background> background{};
    std::optional<Camera> camera{};
    std::optional<Light> light{};
    std::optional<std::vector<SavedView>> views{};

    bool any() const { return !spheres.empty() || !names.empty() || background || camera || light || views; }
};

// Of as many spheres in the same order.
SharedEdits shared_edits(const Scene& before, const Scene& after);

// What the viewer remembers of the edits of frames.
struct FrameEdits {
    SharedEdits shared{};                   // of the frames that were shown before
    std::shared_ptr<const Scene> before{};  // the frame that is shown, without edits; null while it has none. No properties
    EditsReach judged = EditsReach::none;   // of this revision of the document
    std::uint64_t judged_revision = 0;
};

// To be called before an edit of the document, which may give spheres other numbers: remembers what the frame was.
void note_frame_before_edit(ViewerState& state, bool renumbers);

// What the edits of the frame that is shown apply to, those included that it got from others.
EditsReach reach_of_edits(ViewerState& state);

// Whether a sphere's number means here what it means in the file, so that what was changed by number holds in other frames.
bool has_numbers_of_file(const ViewerState& state);

// What the frame that is shown shares with all others, what it got from them included.
SharedEdits shared_edits_now(ViewerState& state);

// Another frame is about to be shown: takes along what the present one shares.
void take_shared_edits(ViewerState& state);
// Another frame is the document now: it gets what was taken along, as a step that can be undone.
void give_shared_edits(ViewerState& state);

}  // namespace sphereview
