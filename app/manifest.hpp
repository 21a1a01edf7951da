// A JSON line for each rendered picture says what it was made of, so that somebody else can render it again.
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

// The SHA-256 of a picture's bytes, the top row first, 3 or 4 a pixel.
std::string sum_of_pixels(const Image& picture);
// Throws InputError for a device or a FIFO, which has no sum.
void require_regular_file(const std::string& path);
// The SHA-256 of a regular file. Throws InputError.
std::string sum_of_file(const std::string& path);

// The states of the input files, to be taken before the first is opened.
std::map<std::string, FileStates> states_of_inputs(const RenderOptions& options);

// The sums of a picture.
struct PictureSums {
    std::string pixels{};               // sum_of_pixels()
    std::optional<std::string> file{};  // SHA-256 of the PNG; none: it went into a film
};

struct ManifestEntry {
    std::string where{};                   // the place of its line, which begins messages
    std::optional<std::string> picture{};  // its file; none: it went into a film
    std::int64_t frame = 0;
    std::size_t place = 0;  // in the sequence, from 0
    std::string scene{};
    std::string scene_sum{};
    std::optional<std::string> camera_sum{};    // of the scene that --camera names
    std::optional<std::string> sequence_sum{};  // FrameSequence::sum_of(); none: a picture by itself
    std::vector<std::string> options{};         // options of `render` that change what pictures look like
    std::string pixels_sum{};
    std::optional<std::string> file_sum{};
    std::string version{};  // of the program
};

// The entry's options without those that only select other pictures. sequence_sum covers their effect on this picture.
std::vector<std::string> options_of_one(const ManifestEntry& entry);

// Reads a manifest's lines, without blank ones and without a last one that is cut off. Throws InputError.
struct ManifestLines {
    std::vector<ManifestEntry> entries{};
    std::optional<std::size_t> cut_off{};  // the number of that line
};
ManifestLines read_manifest(const std::string& path);

class Manifest {
public:
    // Begins the options' file anew. With --skip-existing keeps its whole lines, except those of jobs' pictures that were made of
    // something else; then the jobs' sequences must be prepared. `states`: states_of_inputs(). Throws OutputError, and InputError
    // for scenes without a name, or names that JSON cannot hold.
    Manifest(const RenderOptions& options, std::span<const RenderJob> jobs, std::map<std::string, FileStates> states);

    // Whether a job's picture exists whole and has a line.
    bool has(const std::string& picture) const { return known_.contains(picture); }
    // How many of the jobs' pictures were made of something else.
    std::size_t outdated() const { return outdated_.size(); }

    // Appends the line of a job's picture, unless the file has it; whole or not at all, and as durable as the picture. Throws
    // OutputError, and InputError if a scene's file, or the camera's, has changed since `states` or can have no sum.
    void add(const RenderJob& job, const PictureSums& sums);
    // Whether a scene has changed: no further picture gets a line.
    bool has_lost_scene() const { return lost_scene_; }

private:
    // Whether add() would write the same line for the job, apart from the picture's sums.
    bool is_of(const ManifestEntry& entry, const RenderJob& job);
    // The file's sum, made when first needed. Throws InputError if the file has changed.
    const std::string& sum_of(const std::string& file);
    std::optional<std::string> camera_sum();
    void require_same(const std::string& file);
    std::int64_t number_of(const RenderJob& job) const;
    // Those of `lines` that the manifest keeps.
    std::string kept_of(std::string_view lines, std::span<const RenderJob> jobs);

    const RenderOptions& options_;
    std::map<std::string, FileStates> states_;
    std::map<std::string, std::string> sums_{};
    bool lost_scene_ = false;
    std::set<std::string> known_{};
    std::set<std::string> lines_of_lost_{};  // lines of pictures that are gone or damaged
    std::set<std::string> outdated_{};
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace sphereview
