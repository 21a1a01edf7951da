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

// What one edit, undo or redo concerned, for selecting it: the numbers that its spheres have now, ascending.
using Touched = std::vector<std::uint32_t>;

class Document {
public:
    // How much memory the steps to undo may take; beyond it the oldest are forgotten, except the last one.
    // A move of a million spheres takes 44 MB.
    static constexpr std::size_t usual_history_bytes = std::size_t{64} << 20U;

    // The scene counts as saved.
    explicit Document(Scene scene = {}, std::size_t history_bytes = usual_history_bytes);

    const Scene& scene() const { return scene_; }
    // Grows with everything that changes the scene; never the same for two different scenes, also of different documents, and
    // never 0.
    std::uint64_t revision() const { return revision_; }
    // Grows, like revision(), with what may change the name that goes with a number: names, and which spheres there are.
    std::uint64_t names_revision() const { return names_revision_; }
    // Grows, like revision(), with what may change which sphere a number means: unlike the scene, it does not come back.
    std::uint64_t order_revision() const { return order_revision_; }
    // Of a revision that is another document's, or too old (ChangeLog says how old): everything.
    ChangesSince changes_since(std::uint64_t revision) const {
        return revision == revision_ ? ChangesSince{} : log_.since(revision, scene_);
    }

    // Makes a step of its own, or with the same gesture (not 0) as the last one, so long as nothing was undone or saved since,
    // a part of that. `name` is what a menu says: "Move 'sun'"; a step has that of its first edit. Forgets what could be
    // redone. An edit that changes nothing is no step; a gesture that ends where it began leaves none. `selected`: the numbers that
    // are selected before, ascending, where undoing the step is to select them again.
    Touched apply(Edit edit, std::string name, std::uint64_t gesture = 0, std::vector<std::uint32_t> selected = {});

    // Adds the properties whose names the scene does not have, each with a value for every sphere. No step to undo: they were in
    // the file all the time. Steps from before know no values of theirs: what they bring back has none.
    void add_properties(std::vector<Property> properties);

    bool can_undo() const { return history_.last_done() != nullptr; }
    bool can_redo() const { return history_.last_undone() != nullptr; }
    // Of the step that would be undone or redone; "" if there is none.
    const std::string& undo_name() const;
    const std::string& redo_name() const;
    // What the step that would be undone was given as selected.
    std::vector<std::uint32_t> selected_before_undo_step() const;
    // Whether that step changed the camera of a view that showed it.
    bool undo_moves_view() const;
    bool redo_moves_view() const;
    // Whether it makes everything another scene (ReplaceScene).
    bool undo_replaces_scene() const;
    bool redo_replaces_scene() const;
    // Whether it may change which sphere a number means.
    bool redo_changes_order() const;
    // What the steps to undo take, about, and what they may take; those to redo may take as much again.
    std::size_t history_bytes() const { return history_.bytes(); }
    std::size_t most_history_bytes() const { return history_.most_bytes(); }
    // Do nothing if there is nothing to do.
    Touched undo();
    Touched redo();

    // The scene as it is now is what the file holds.
    void mark_saved() { history_.mark_saved(); }
    // No state of the history is what the file holds.
    void mark_unsaved() { history_.mark_unsaved(); }
    // Whether the scene is another than at mark_saved(), or at the construction; undoing back to that makes it false again.
    bool is_changed() const { return !history_.at_saved(); }

private:
    void advance(LoggedChange change);
    // Applies an edit to the scene, notes what it changed, and returns its inverse.
    Edit carry_out(Edit edit);
    // Applies the step's edits and makes it the one that takes them back.
    Touched apply_step(HistoryStep& step);

    Scene scene_;
    std::uint64_t revision_;
    std::uint64_t names_revision_ = revision_;
    std::uint64_t order_revision_ = revision_;
    ChangeLog log_;
    History history_;
};

}  // namespace sphereview
