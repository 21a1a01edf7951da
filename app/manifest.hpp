// What rendered pictures were made of, so that somebody else can make them again: a JSON line for each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/options.hpp"
#include "app/render_plan.hpp"
#include "base/file_watcher.hpp"
#include "image/image.hpp"

namespace sphereview {

// Of a picture's bytes, the top row first, 3 or 4 a pixel.
std::string sum_of_pixels(const Image& picture);
// Throws InputError for a device or a FIFO, of which no sum can be made.
void require_regular_file(const std::string& path);
// Of a regular file. Throws InputError.
std::string sum_of_file(const std::string& path);

// The files that pictures are made of, as they are before the first is opened.
std::map<std::string, FileStates> states_of_inputs(const RenderOptions& options);

// What a manifest says of a picture's bytes.
struct PictureSums {
    std::string pixels{};               // sum_of_pixels()
    std::optional<std::string> file{};  // SHA-256 of the PNG; none: it went into a film
};

struct ManifestEntry {
    std::string where{};                   // its line, as messages begin with it
    std::optional<std::string> picture{};  // its file; none: it went into a film
    std::int64_t frame = 0;
    std::size_t place = 0;  // in the sequence, from 0
    std::string scene{};
    std::string scene_sum{};
    std::optional<std::string> camera_sum{};    // of the scene that --camera names
    std::optional<std::string> sequence_sum{};  // FrameSequence::sum_of(); none: a picture by itself
    std::vector<std::string> options{};         // of `render`, that say what the picture looks like
    std::string pixels_sum{};
    std::optional<std::string> file_sum{};
    std::string version{};  // of the program
};

// The options of a picture without those that say only which other pictures there are: what of them is seen, sequence_sum tells.
std::vector<std::string> options_of_one(const ManifestEntry& entry);

// The whole lines of a manifest, without blank ones: one that was cut off at its end is left out. Throws InputError.
struct ManifestLines {
    std::vector<ManifestEntry> entries{};
    std::optional<std::size_t> cut_off{};  // the number of the last line
};
ManifestLines read_manifest(const std::string& path);

class Manifest {
public:
    // Begins the file named by the options anew, or with --skip-existing goes on behind the whole lines that are there, without
    // those of jobs' pictures that were made of something else: then the jobs' sequences are to be prepared.
    // `states`: states_of_inputs(). Throws OutputError, and InputError for scenes without a name, or names that JSON cannot hold.
    Manifest(const RenderOptions& options, std::span<const RenderJob> jobs, std::map<std::string, FileStates> states);

    // Whether that picture of a job is there whole, and has a line.
    bool has(const std::string& picture) const { return known_.contains(picture); }
    // How many pictures of the jobs had been made of something else.
    std::size_t outdated() const { return outdated_.size(); }

    // Appends the line of a job's picture, unless it is there, whole or not at all, as durable as the picture. Throws OutputError,
    // and InputError where the scene, or that of the camera, is no longer the file whose state was given, or none that has a sum.
    void add(const RenderJob& job, const PictureSums& sums);
    // Whether a scene was found changed: no further picture gets a line.
    bool has_lost_scene() const { return lost_scene_; }

private:
    // Whether the line is what add() would write of the job, but for the sums of its picture.
    bool is_of(const ManifestEntry& entry, const RenderJob& job);
    // Made when it is first asked for. Throws InputError where the file is not as it was.
    const std::string& sum_of(const std::string& file);
    std::optional<std::string> camera_sum();
    void require_same(const std::string& file);
    std::int64_t number_of(const RenderJob& job) const;
    // The lines of a manifest that are to stay.
    std::string kept_of(std::string_view lines, std::span<const RenderJob> jobs);

    const RenderOptions& options_;
    std::map<std::string, FileStates> states_;
    std::map<std::string, std::string> sums_{};
    bool lost_scene_ = false;
    std::set<std::string> known_{};
    std::set<std::string> lines_of_lost_{};  // of pictures that are gone or damaged
    std::set<std::string> outdated_{};
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace sphereview
