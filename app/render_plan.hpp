// Plans which files a batch of renders reads and writes, before any work.
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
    std::string label;        // the picture in messages: the scene as given, or "stdin"; of several with ", 12" behind it
    std::string scene_label;  // the scene alone
    std::string name;         // the scene's file name without folder and last extension; "stdin" for "-"
    std::optional<std::string> output;
    std::optional<std::string> expect;
    std::optional<std::string> diff;
    std::shared_ptr<FrameSequence> sequence{};  // the picture's sequence; null: the scene is read by itself
    std::size_t shot = 0;                       // the picture's place in the sequence
    std::optional<std::string> pixels_sum{};    // the SHA-256 that its pixels must have
    std::string fault{};                        // why the scene has no picture, which is all that the job says; else ""
};

// A job without files and sequence. `fault`: RenderJob::fault.
RenderJob job_of_scene(const std::string& scene, const std::string& fault = "");

// How many jobs make a picture.
std::size_t count_pictures(std::span<const RenderJob> jobs);

// A scene that several pictures are made of.
struct OpenedScene {
    std::shared_ptr<FrameSequence> sequence{};  // null: the scene could not be opened
    std::string fault{};                        // why
};

// The values of a pattern's placeholders. A placeholder without a value stays.
struct PatternValues {
    std::optional<std::string> name{};    // {name}
    std::optional<std::int64_t> frame{};  // {frame}; {frame:0W} has at least W digits
    std::optional<std::string> folder{};  // {folder}
};

// `pattern` with the values filled in once: a value's own text is no placeholder.
std::string fill_in(std::string_view pattern, const PatternValues& values);

// Whether a pattern holds {frame} or {frame:0W}.
bool has_frame(std::string_view pattern);

// Outputs of a pattern with {name} or {frame} get their folder, so that a batch needs no `mkdir`. The folder of a full name must
// exist: the name may be a slip.
MissingFolder missing_folder(const std::string& pattern);

// The value of {name}: the file's name without folder, .gz and the ending before that; "stdin" for "-".
std::string name_in_patterns(const std::string& path);

// One job a scene. With `opened`: one for each picture of a scene's sequence, and one for the fault of a scene without a sequence;
// without other parts' pictures. {name} and {frame} are filled in. Throws InputError when an output has another ending than .png,
// is also an input, a golden image or another output, or a standard stream would be used twice.
std::vector<RenderJob> plan_render(const RenderOptions& options, std::span<const OpenedScene> opened = {});

}  // namespace sphereview
