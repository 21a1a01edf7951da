// Makes a film of a file's frames, or around a scene, beside the window's loop, by the functions of `render --frames`, so each
// picture has the same pixels.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/frame_changes.hpp"
#include "app/options.hpp"
#include "base/background_job.hpp"
#include "look/coloring.hpp"
#include "scene/scene.hpp"

namespace sphereview {

class Film;

struct FilmRequest {
    // The options of `render`: one scene, a camera, and a movie or an output with {frame}; on the CPU.
    RenderOptions options;
    bool is_of_file = false;             // the frames of the scene's file; else a turntable of `shown`
    FrameChanges changes{};              // of the file's frames, with the window's light
    std::shared_ptr<const Scene> shown;  // the spheres in the window; null with `is_of_file`
    std::optional<Coloring> coloring{};  // what the colours of `shown` stand for
};

// The progress of a film; usable from any thread.
class FilmStatus {
public:
    // 0 while the file is looked through for its frames.
    std::size_t pictures() const { return pictures_; }
    std::size_t done() const { return done_; }
    // The finished part, 0..1; before there are pictures, the part of the file that was read.
    double part() const;
    // Seconds for the rest, estimated by the pictures so far; nothing before the first.
    std::optional<double> seconds_left() const;
    std::vector<std::string> warnings() const;

    // Ends an encoder that takes no more pictures, for which the cancelled work would wait. Returns whether a film was given up.
    bool give_up_film();

    // For the thread that makes it.
    void begin(std::size_t pictures);
    void set_film(Film* film);
    // The part of the file, then of the pictures or of the one being made: 0..1.
    void progress(double part) { part_ = part; }
    void add_done() { ++done_; }
    void warn(const std::vector<std::string>& lines);

private:
    using Clock = std::chrono::steady_clock;
    std::atomic<std::size_t> pictures_ = 0;
    std::atomic<std::size_t> done_ = 0;
    std::atomic<double> part_ = 0.0;
    std::atomic<Clock::time_point> begun_{};
    mutable std::mutex mutex_;
    std::vector<std::string> warnings_;
    Film* film_ = nullptr;  // while there is one
};

// Makes the film. Throws on any fault, and Cancelled. A film appears whole or not at all; written pictures stay.
void make_film(const FilmRequest& request, WorkControl& control, FilmStatus& status);

}  // namespace sphereview
