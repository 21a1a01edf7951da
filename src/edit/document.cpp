#include "edit/document.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

namespace sphereview {

namespace {

// One counter for all documents: a picture of one document must not be taken for one of another.
std::uint64_t next_revision() {
    static std::atomic<std::uint64_t> latest = 0;
    return ++latest;
}

const std::string& name_of(const HistoryStep* step) {
    static const std::string none;
    return step == nullptr ? none : step->name;
}

bool has_any(const HistoryStep* step, bool (*wanted)(const Edit&)) {
    return step != nullptr && std::ranges::any_of(step->edits, wanted);
}

bool moves_view(const Edit& edit) {
    const auto* camera = std::get_if<ChangeCamera>(&edit);
    return camera != nullptr && camera->moves_view;
}

bool replaces_scene(const Edit& edit) { return std::holds_alternative<ReplaceScene>(edit); }

bool changes_order(const Edit& edit) {
    return std::holds_alternative<InsertSpheres>(edit) || std::holds_alternative<RemoveSpheres>(edit) ||
           std::holds_alternative<ReorderSphere>(edit) || replaces_scene(edit);
}

bool changes_names(const Edit& edit) { return changes_order(edit) || std::holds_alternative<RenameSphere>(edit); }

}  // namespace

Document::Document(Scene scene, std::size_t history_bytes)
    : scene_(std::move(scene)), revision_(next_revision()), history_(history_bytes) {}

const std::string& Document::undo_name() const { return name_of(history_.last_done()); }
const std::string& Document::redo_name() const { return name_of(history_.last_undone()); }

std::vector<std::uint32_t> Document::selected_before_undo_step() const {
    const HistoryStep* step = history_.last_done();
    return step == nullptr ? std::vector<std::uint32_t>{} : step->selected;
}

bool Document::undo_moves_view() const { return has_any(history_.last_done(), moves_view); }
bool Document::redo_moves_view() const { return has_any(history_.last_undone(), moves_view); }
bool Document::undo_replaces_scene() const { return has_any(history_.last_done(), replaces_scene); }
bool Document::redo_replaces_scene() const { return has_any(history_.last_undone(), replaces_scene); }
bool Document::redo_changes_order() const { return has_any(history_.last_undone(), changes_order); }

void Document::advance(LoggedChange change) {
    log_.add(revision_, std::move(change));
    revision_ = next_revision();
}

Edit Document::carry_out(Edit edit) {
    const bool names = changes_names(edit);
    const bool order = changes_order(edit);
    Edit inverse = sphereview::apply(std::move(edit), scene_);
    advance(change_undone_by(inverse, scene_));
    if (names) names_revision_ = revision_;
    if (order) order_revision_ = revision_;
    return inverse;
}

Touched Document::apply(Edit edit, std::string name, std::uint64_t gesture, std::vector<std::uint32_t> selected) {
    Touched touched = numbers_concerned(edit);
    if (changes_nothing(edit, scene_)) return touched;
    Edit inverse = carry_out(std::move(edit));
    if (history_.covers(inverse, gesture)) {
        history_.drop_idle_step(scene_);
    } else {
        history_.add(std::move(inverse), std::move(name), gesture, std::move(selected));
    }
    return touched;
}

void Document::add_properties(std::vector<Property> properties) {
    for (Property& property : properties) {
        if (find_property(scene_.properties, property.name) == nullptr) scene_.properties.push_back(std::move(property));
    }
    advance({});
}

Touched Document::apply_step(HistoryStep& step) {
    Touched touched;
    std::vector<Edit> inverses;
    inverses.reserve(step.edits.size());
    for (auto edit = step.edits.rbegin(); edit != step.edits.rend(); ++edit) {
        const Touched before = numbers_after(*edit, std::move(touched));
        const Touched more = numbers_concerned(*edit);
        touched.clear();
        std::ranges::set_union(before, more, std::back_inserter(touched));
        inverses.push_back(carry_out(std::move(*edit)));
    }
    step.edits = std::move(inverses);
    return touched;
}

Touched Document::undo() {
    if (!can_undo()) return {};
    HistoryStep step = history_.take_done();
    Touched touched = apply_step(step);
    history_.push_undone(std::move(step));
    return touched;
}

Touched Document::redo() {
    if (!can_redo()) return {};
    HistoryStep step = history_.take_undone();
    Touched touched = apply_step(step);
    history_.push_done(std::move(step));
    return touched;
}

}  // namespace sphereview
