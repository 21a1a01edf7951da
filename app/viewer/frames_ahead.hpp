// Frames of a file, read beside the window's loop before they are to be shown, and counted meanwhile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/load_scene.hpp"
#include "base/background_job.hpp"

namespace sphereview {

class FrameReader;

struct PassedFrame {
    std::int64_t number = 0;
    LoadedScene loaded{};
};

class FramesAhead {
public:
    // Beyond so many bytes, about, no frame is read ahead.
    static constexpr std::size_t usual_most_bytes = std::size_t{64} << 20U;
    static constexpr std::size_t most_frames = 24;

    // Opens `path` beside the caller. `options`: how each frame is read, but for its number.
    FramesAhead(std::string path, LoadOptions options, std::size_t most_bytes = usual_most_bytes);
    // Ends the work, and waits for nothing.
    ~FramesAhead();
    FramesAhead(const FramesAhead&) = delete;
    FramesAhead& operator=(const FramesAhead&) = delete;

    // What is to be read from now on, instead of what was: the first one in any case, then those behind as far as there is room.
    // What is read already and not among them is forgotten.
    void want(std::vector<std::int64_t> frames);
    // Where the look is another than before, what is read is forgotten.
    void set_look(const LookOptions& look);

    // Gives a frame away that is read.
    std::optional<LoadedScene> take(std::int64_t frame);
    // The latest that came first when its reading began, and is not wanted any more now that it is read: who drags a handle sees
    // where it passes.
    std::optional<PassedFrame> take_passed();
    // The time of a frame that was read once, in the file's unit; nothing where the file says none.
    std::optional<double> time_of(std::int64_t frame) const;
    // Why a frame that is wanted cannot be read.
    std::optional<std::string> fault_of(std::int64_t frame) const;
    // Whether that is so of every frame: the file cannot be read.
    bool has_no_file() const;
    // Waits until the frame, which is wanted, is read or has a fault.
    void wait_for(std::int64_t frame) const;

    struct Count {
        std::int64_t frames = 0;  // known so far
        bool all = false;         // and no more come
        double part = 0.0;        // of the file that was looked through, 0..1
        std::string fault{};      // that ends the file behind them
    };
    Count count() const;

private:
    struct Shared;
    struct Task;
    static void work(Shared& shared, const std::string& path, const LoadOptions& options);
    static void read_one(Shared& shared, FrameReader& reader, LoadOptions options, const Task& task);
    static void count_on(Shared& shared, FrameReader& reader);

    std::shared_ptr<Shared> shared_;
    BackgroundJob job_;
};

}  // namespace sphereview
