// A scene that is being edited: the one door for changes, with undo and redo and a record of what changed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "edit/change_log.hpp"
#include "edit/edit.hpp"
#include "edit/history.hpp"

namespace sphereview {

// The spheres of an edit, undo or redo, to be selected: their present numbers, ascending.
using Touched = std::vector<std::uint32_t>;

class Document {
public:
    // Memory for the steps to undo; beyond it the oldest are forgotten, except the last one. A move of a million spheres takes 44
    // MB.
    static constexpr std::size_t usual_history_bytes = std::size_t{64} << 20U;

    // The scene counts as saved.
    explicit Document(Scene scene = {}, std::size_t history_bytes = usual_history_bytes);

    const Scene& scene() const { return scene_; }
    // Grows with every change of the scene. Never the same for two different scenes, even of different documents, and never 0.
    std::uint64_t revision() const { return revision_; }
    // Grows, like revision(), with changes of names and of numbers.
    std::uint64_t names_revision() const { return names_revision_; }
    // Grows, like revision(), with changes of numbers; an undo gives no earlier value back.
    std::uint64_t order_revision() const { return order_revision_; }
    // Everything, for a revision that is another document's or too old for ChangeLog.
    ChangesSince changes_since(std::uint64_t revision) const {
        return revision == revision_ ? ChangesSince{} : log_.since(revision, scene_);
    }

    // Applies an edit as a step of its own, or, with the last step's gesture (not 0), as a part of that step, unless something was
    // undone or saved since. `name`: for the menu, "Move 'sun'"; a step has its first edit's. Forgets the steps to redo. An edit
    // that changes nothing is no step; a gesture that ends where it began leaves none. `selected`: the numbers that undoing the
    // step selects again, ascending.
    Touched apply(Edit edit, std::string name, std::uint64_t gesture = 0, std::vector<std::uint32_t> selected = {});

    // Adds the properties whose names the scene lacks, each with a value for every sphere. This is no step, since the file had them
    // all the time. Spheres that earlier steps bring back have no values of them.
    void add_properties(std::vector<Property> properties);

    bool can_undo() const { return history_.last_done() != nullptr; }
    bool can_redo() const { return history_.last_undone() != nullptr; }
    // The name of the next step to undo or redo; "" for none.
    const std::string& undo_name() const;
    const std::string& redo_name() const;
    // `selected` of the next step to undo.
    std::vector<std::uint32_t> selected_before_undo_step() const;
    // Whether that step changes the camera of a view that shows it.
    bool undo_moves_view() const;
    bool redo_moves_view() const;
    // Whether that step replaces the scene (ReplaceScene).
    bool undo_replaces_scene() const;
    bool redo_replaces_scene() const;
    // Whether that step may change numbers.
    bool redo_changes_order() const;
    // About how much memory the steps take, and the bound for those to undo; steps to redo may take as much again.
    std::size_t history_bytes() const { return history_.bytes(); }
    std::size_t most_history_bytes() const { return history_.most_bytes(); }
    // Do nothing if there is nothing to do.
    Touched undo();
    Touched redo();

    // The file holds the present scene.
    void mark_saved() { history_.mark_saved(); }
    // The file holds no state of the history.
    void mark_unsaved() { history_.mark_unsaved(); }
    // Whether the scene differs from the saved one; false again after undoing back to it.
    bool is_changed() const { return !history_.at_saved(); }

private:
    void advance(LoggedChange change);
    // Applies an edit to the scene, logs the change, and returns the inverse.
    Edit carry_out(Edit edit);
    // Applies the step's edits, and replaces them in `step` by their inverses.
    Touched apply_step(HistoryStep& step);

    Scene scene_;
    std::uint64_t revision_;
    std::uint64_t names_revision_ = revision_;
    std::uint64_t order_revision_ = revision_;
    ChangeLog log_;
    History history_;
};

}  // namespace sphereview
