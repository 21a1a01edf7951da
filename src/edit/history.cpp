#include "edit/history.hpp"

#include <algorithm>
#include <utility>

namespace sphereview {

namespace {

// Whether applying `older` gives the old scene back even if `newer` is not applied before it.
bool says_more(const Edit& older, const Edit& newer) {
    if (std::holds_alternative<ReplaceScene>(older)) return true;
    if (older.index() != newer.index()) return false;
    if (const auto* change = std::get_if<ChangeSpheres>(&older)) return change->numbers == std::get<ChangeSpheres>(newer).numbers;
    if (const auto* rename = std::get_if<RenameSphere>(&older)) return rename->number == std::get<RenameSphere>(newer).number;
    return std::holds_alternative<ChangeCamera>(older) || std::holds_alternative<ChangeBackground>(older) ||
           std::holds_alternative<ChangeLight>(older) || std::holds_alternative<ChangeViews>(older);
}

bool keeps_numbers(const Edit& edit) {
    return !std::holds_alternative<InsertSpheres>(edit) && !std::holds_alternative<RemoveSpheres>(edit) &&
           !std::holds_alternative<ReorderSphere>(edit);
}

std::size_t bytes_of(const std::vector<Property>& properties) {
    std::size_t bytes = 0;
    for (const Property& property : properties) bytes += bytes_of(property);
    return bytes;
}

// What an edit keeps in memory, about.
std::size_t bytes_of(const Edit& edit) {
    constexpr std::size_t for_a_name = 80;
    constexpr std::size_t for_a_view = sizeof(SavedView) + 32;
    std::size_t bytes = sizeof(Edit);
    if (const auto* change = std::get_if<ChangeSpheres>(&edit)) {
        bytes += change->numbers.size() * (sizeof(std::uint32_t) + sizeof(Sphere));
    } else if (const auto* insert = std::get_if<InsertSpheres>(&edit)) {
        bytes += insert->numbers.size() * (sizeof(std::uint32_t) + sizeof(NamedSphere)) + bytes_of(insert->properties);
    } else if (const auto* remove = std::get_if<RemoveSpheres>(&edit)) {
        bytes += remove->numbers.size() * sizeof(std::uint32_t);
    } else if (const auto* replace = std::get_if<ReplaceScene>(&edit)) {
        bytes += replace->scene.spheres.size() * sizeof(Sphere) + replace->scene.names.size() * for_a_name +
                 replace->scene.views.size() * for_a_view + bytes_of(replace->scene.properties);
    } else if (const auto* views = std::get_if<ChangeViews>(&edit)) {
        bytes += views->views.size() * for_a_view;
    }
    return bytes;
}

std::size_t bytes_of(const HistoryStep& step) {
    std::size_t bytes = sizeof(HistoryStep) + step.selected.size() * sizeof(std::uint32_t);
    for (const Edit& edit : step.edits) bytes += bytes_of(edit);
    return bytes;
}

}  // namespace

bool History::covers(const Edit& inverse, std::uint64_t gesture) const {
    if (!continues(gesture)) return false;
    const std::vector<Edit>& edits = done_.back().edits;
    for (auto older = edits.rbegin(); older != edits.rend(); ++older) {
        if (says_more(*older, inverse)) return true;
        if (!keeps_numbers(*older)) return false;
    }
    return false;
}

void History::add(Edit inverse, std::string name, std::uint64_t gesture, std::vector<std::uint32_t> selected) {
    if (!continues(gesture)) {
        // A state that only redoing would have reached is gone.
        if (saved_ && *saved_ > done_.size()) saved_.reset();
        undone_.clear();
        undone_bytes_ = 0;
        push_done({std::move(name), {}, std::move(selected)});
        open_gesture_ = gesture;
    }
    done_bytes_ += bytes_of(inverse);
    done_.back().edits.push_back(std::move(inverse));
    forget_oldest();
}

void History::drop_idle_step(const Scene& scene) {
    if (open_gesture_ == 0) return;
    // The last first: the numbers of an edit need not fit before those after it are taken back.
    const std::vector<Edit>& edits = done_.back().edits;
    if (!std::all_of(edits.rbegin(), edits.rend(), [&](const Edit& edit) { return changes_nothing(edit, scene); })) return;
    take_done();
}

HistoryStep History::take_done() {
    open_gesture_ = 0;
    HistoryStep step = std::move(done_.back());
    done_.pop_back();
    done_bytes_ -= bytes_of(step);
    return step;
}

HistoryStep History::take_undone() {
    HistoryStep step = std::move(undone_.back());
    undone_.pop_back();
    undone_bytes_ -= bytes_of(step);
    return step;
}

// Taking inserted spheres back keeps them here, though the step to undo was a few bytes.
void History::push_undone(HistoryStep step) {
    undone_bytes_ += bytes_of(step);
    undone_.push_back(std::move(step));
    while (undone_.size() > 1 && bytes() > most_bytes_) {
        undone_bytes_ -= bytes_of(undone_.front());
        undone_.pop_front();
    }
    if (saved_ && *saved_ > done_.size() + undone_.size()) saved_.reset();
}

void History::push_done(HistoryStep step) {
    done_bytes_ += bytes_of(step);
    done_.push_back(std::move(step));
    forget_oldest();
}

void History::mark_saved() {
    // What comes next is another step, so that this state can be undone to.
    open_gesture_ = 0;
    saved_ = done_.size();
}

void History::forget_oldest() {
    while (done_.size() > 1 && bytes() > most_bytes_) {
        done_bytes_ -= bytes_of(done_.front());
        done_.pop_front();
        if (saved_) saved_ = *saved_ > 0 ? std::optional(*saved_ - 1) : std::nullopt;
    }
}

}  // namespace sphereview
