// The steps that can be undone and redone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "edit/edit.hpp"

namespace sphereview {

// One step of undo or redo. `edits` undo it (or redo it), applied from the last to the first.
struct HistoryStep {
    std::string name;
    std::vector<Edit> edits;
    std::vector<std::uint32_t> selected{};  // the selection before the step, if known: ascending numbers
};

class History {
public:
    // Beyond `most_bytes` in all, the oldest steps to undo or the farthest to redo are forgotten; never the next one of either.
    explicit History(std::size_t most_bytes) : most_bytes_(most_bytes) {}

    // Whether the open step of that gesture already undoes an edit with this inverse, which then takes no memory.
    bool covers(const Edit& inverse, std::uint64_t gesture) const;

    // Adds the inverse of an edit to the open step of that gesture, or to a new step with this name and selection.
    void add(Edit inverse, std::string name, std::uint64_t gesture, std::vector<std::uint32_t> selected = {});

    // Removes the open step if undoing it would not change the scene.
    void drop_idle_step(const Scene& scene);

    // The next steps to undo and to redo, or null.
    const HistoryStep* last_done() const { return done_.empty() ? nullptr : &done_.back(); }
    const HistoryStep* last_undone() const { return undone_.empty() ? nullptr : &undone_.back(); }

    // Remove the next step, which must exist. The caller applies it and pushes the inverse to the other side.
    HistoryStep take_done();
    HistoryStep take_undone();
    void push_undone(HistoryStep step);
    void push_done(HistoryStep step);

    // About how much memory all steps take.
    std::size_t bytes() const { return done_bytes_ + undone_bytes_; }
    std::size_t most_bytes() const { return most_bytes_; }

    void mark_saved();
    void mark_unsaved() { saved_.reset(); }
    bool at_saved() const { return saved_ == done_.size(); }

private:
    bool continues(std::uint64_t gesture) const { return gesture != 0 && gesture == open_gesture_; }
    void forget_oldest();

    std::deque<HistoryStep> done_;
    std::deque<HistoryStep> undone_;
    std::uint64_t open_gesture_ = 0;        // of the last step while edits may still join it; else 0
    std::optional<std::size_t> saved_ = 0;  // number of done steps in the saved state
    std::size_t most_bytes_;
    std::size_t done_bytes_ = 0;
    std::size_t undone_bytes_ = 0;
};

}  // namespace sphereview
