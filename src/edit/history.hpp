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

// One entry of a menu. Its edits take it back (or do it again), to be applied from the last to the first.
struct HistoryStep {
    std::string name;
    std::vector<Edit> edits;
    std::vector<std::uint32_t> selected{};  // before it, where whoever made it said so: ascending numbers
};

class History {
public:
    // Beyond so many bytes together the oldest steps to undo are forgotten, or the farthest to redo; never the next of either.
    explicit History(std::size_t most_bytes) : most_bytes_(most_bytes) {}

    // Whether an edit with that inverse, in that gesture, needs no place: undoing the step that it belongs to takes it back too.
    bool covers(const Edit& inverse, std::uint64_t gesture) const;

    // Notes an edit by its inverse, in the open step of that gesture or in one of its own, whose name and selection it then
    // gives.
    void add(Edit inverse, std::string name, std::uint64_t gesture, std::vector<std::uint32_t> selected = {});

    // Takes the open step away if undoing it would change nothing of the scene.
    void drop_idle_step(const Scene& scene);

    // The steps next in turn, or null.
    const HistoryStep* last_done() const { return done_.empty() ? nullptr : &done_.back(); }
    const HistoryStep* last_undone() const { return undone_.empty() ? nullptr : &undone_.back(); }

    // Take the step out; the caller applies it and gives what takes that back to the other. There must be one.
    HistoryStep take_done();
    HistoryStep take_undone();
    void push_undone(HistoryStep step);
    void push_done(HistoryStep step);

    // What the steps to undo and to redo keep in memory, about.
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
    std::uint64_t open_gesture_ = 0;        // of the last step, while edits may still join it; else 0
    std::optional<std::size_t> saved_ = 0;  // how many steps are done in the state that the file holds
    std::size_t most_bytes_;
    std::size_t done_bytes_ = 0;
    std::size_t undone_bytes_ = 0;
};

}  // namespace sphereview
