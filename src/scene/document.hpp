// A scene that is being edited: the one door for changes, with undo and redo and a record of what changed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/edit.hpp"

namespace sphereview {

// What changed between two revisions.
struct SceneChanges {
    bool order = false;                  // spheres came, went or changed places: nothing of the old numbers holds
    std::vector<std::uint32_t> spheres;  // unless `order`: those that got other values, ascending
    bool geometry = false;               // of `spheres`: a centre, a radius or whether it is hidden; else only colours
    bool camera = false;
    bool background = false;

    bool none() const { return !order && spheres.empty() && !camera && !background; }
};

// What one edit, undo or redo concerned, for selecting it: the numbers that its spheres have now, ascending.
using Touched = std::vector<std::uint32_t>;

class Document {
public:
    explicit Document(Scene scene = {});

    const Scene& scene() const { return scene_; }
    // Grows with everything that changes the scene; never the same for two different scenes.
    std::uint64_t revision() const { return revision_; }
    SceneChanges changes_since(std::uint64_t revision) const;

    // Makes a step of its own, or with the same gesture (not 0) as the last one, so long as nothing was undone since, a part
    // of that. `name` is what a menu says: "Move 'sun'". Forgets what could be redone.
    Touched apply(Edit edit, std::string name, std::uint64_t gesture = 0);

    bool can_undo() const;
    bool can_redo() const;
    // Of the step that would be undone or redone; "" if there is none.
    const std::string& undo_name() const;
    const std::string& redo_name() const;
    // Do nothing if there is nothing to do.
    Touched undo();
    Touched redo();

    // The scene as it is now is what the file holds.
    void mark_saved();
    // No state of the history is what the file holds.
    void mark_unsaved();
    // Whether the scene is another than at mark_saved(), or at the construction; undoing back to that makes it false again.
    bool is_changed() const;

private:
    // One entry of a menu. Its edits take it back (or do it again), to be applied from the last to the first.
    struct Step {
        std::string name;
        std::uint64_t gesture = 0;
        std::vector<Edit> edits;
    };

    Scene scene_;
    std::uint64_t revision_ = 1;
};

}  // namespace sphereview
