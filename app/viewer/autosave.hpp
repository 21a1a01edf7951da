// Keeps unsaved changes in the recovery file while the viewer runs, so that not even a kill or a power cut loses more than seconds.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "base/background_job.hpp"
#include "edit/document.hpp"

namespace sphereview {

class Autosave {
public:
    using Clock = std::chrono::steady_clock;

    // Call when nothing moves. Keeps the changes once they are some seconds old; the longer that took the last time, the later, so
    // that it never takes more than a small part of the time; a large scene's from a copy, in the background. Forgets what is kept
    // as soon as nothing is unsaved. `original` is the document's file.
    void look(const Document& document, const std::string& original, Clock::time_point now);

    // What is being written in the background is on the disk, or has failed, when this returns.
    void finish();

    // Keeps the changes at once. False when that cannot be done; it is not tried again before the next change.
    bool keep(const Document& document, const std::string& original);

    // When look() has something to do that no input announces.
    std::optional<Clock::time_point> due() const { return due_; }

private:
    void keep_in_background(const Document& document, const std::string& original);

    std::optional<Clock::time_point> due_;
    Clock::duration pause_ = shortest_pause;
    std::uint64_t tried_ = 0;  // the revision of the last attempt
    bool kept_ = false;        // there may be a recovery file of ours
    std::optional<BackgroundJob> job_;
    Clock::time_point job_begin_;

    static constexpr Clock::duration shortest_pause = std::chrono::seconds(2);
    static constexpr int pauses_per_write = 20;
    static constexpr Clock::duration look_again = std::chrono::milliseconds(250);  // while a job runs
    static constexpr std::size_t spheres_at_once = 10'000;
};

}  // namespace sphereview
