// Which files a batch of renders reads and writes, settled before any work.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/options.hpp"
#include "base/output_file.hpp"

namespace sphereview {

class FrameSequence;

// The files of one picture. Paths may be "-".
struct RenderJob {
    std::string scene;
    std::string label;        // how messages call the picture: the scene as given, or "stdin"; of several ", 12" behind it
    std::string scene_label;  // the scene alone
    std::string name;         // the scene's file name without folder and last extension; "stdin" for "-"
    std::optional<std::string> output;
    std::optional<std::string> expect;
    std::optional<std::string> diff;
    std::shared_ptr<FrameSequence> sequence{};  // of which this is a picture; null: the scene is read by itself
    std::size_t shot = 0;                       // its place there
    std::optional<std::string> pixels_sum{};    // the SHA-256 that its pixels must have
    std::string fault{};                        // why there can be no picture of the scene: the job only says so; else ""
};

// Without files and a sequence. `fault`: RenderJob::fault.
RenderJob job_of_scene(const std::string& scene, const std::string& fault = "");

// How many jobs are to make a picture.
std::size_t count_pictures(std::span<const RenderJob> jobs);

// A scene of which several pictures are asked for.
struct OpenedScene {
    std::shared_ptr<FrameSequence> sequence{};  // null: it could not be opened
    std::string fault{};                        // why
};

// What the placeholders of a pattern stand for. Those without a value stay as they are.
struct PatternValues {
    std::optional<std::string> name{};    // {name}
    std::optional<std::int64_t> frame{};  // {frame}, and with at least W digits {frame:0W}
    std::optional<std::string> folder{};  // {folder}
};

// `pattern` with the values filled in once, from left to right: what a value itself holds is no placeholder.
std::string fill_in(std::string_view pattern, const PatternValues& values);

// Whether a pattern holds {frame} or {frame:0W}.
bool has_frame(std::string_view pattern);

// The folder of outputs of a pattern with {name} or {frame} is made: a batch needs no `mkdir`. A file that is named whole may be a
// slip.
MissingFolder missing_folder(const std::string& pattern);

// What {name} stands for: the file's name without its folder, .gz and the ending before that; "stdin" for "-".
std::string name_in_patterns(const std::string& path);

// One job a scene, or, where the scenes of the options were opened, one for each picture of a scene's sequence, and one that says
// what is wrong with a scene without a sequence; with {name} and {frame} filled in, and without those of other parts. Throws
// InputError when an output has an ending of something else than a PNG, is also an input, a golden image or another output, or a
// standard stream would be used twice.
std::vector<RenderJob> plan_render(const RenderOptions& options, std::span<const OpenedScene> opened = {});

}  // namespace sphereview
