// A film of a file's frames, or around a scene, made beside the window's loop: by the functions of `render --frames`, so that each
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

// What is to be made.
struct FilmRequest {
    // As `render` would be asked: one scene, a camera, and a movie or an output with {frame}; by the processor.
    RenderOptions options;
    bool is_of_file = false;             // the frames of the scene's file; else a turntable of what is shown
    FrameChanges changes{};              // of the file's frames; the light is that of what is shown, too
    std::shared_ptr<const Scene> shown;  // the spheres in the window; of a file null
    std::optional<Coloring> coloring{};  // of what is shown: what its colours stand for
};

// How far it is; from any thread.
class FilmStatus {
public:
    // 0 while the file is looked through for its frames.
    std::size_t pictures() const { return pictures_; }
    std::size_t done() const { return done_; }
    // Of all, 0..1; before there are pictures, of the file.
    double part() const;
    // Of the rest, by what the pictures took so far; nothing before there is any of that.
    std::optional<double> seconds_left() const;
    std::vector<std::string> warnings() const;

    // Ends an encoder that takes no more pictures: the work, which is cancelled, would wait for it. Whether there was a film that
    // does not appear now.
    bool give_up_film();

    // For the thread that makes it.
    void begin(std::size_t pictures);
    void set_film(Film* film);
    // Of the file, and then of the pictures, or of the one that is being made: 0..1.
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

// Throws what cannot be, and Cancelled; a film appears whole or not at all, of pictures those stay that are written.
void make_film(const FilmRequest& request, WorkControl& control, FilmStatus& status);

}  // namespace sphereview
