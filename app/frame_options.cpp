#include "app/frame_options.hpp"

#include "app/add_option.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr const char* fit_first = "--fit-first";

}  // namespace

void add_frame_options(CLI::App& command, RenderOptions& options) {
    FrameOptions& frames = options.frames;
    add_option(
        command, frames.ranges,
        {"--frames", "LIST",
         "Pictures of several frames, named by {frame}: " + std::string(frames_syntax) +
             "; B is the first that is left out. One camera for all, fitted to all that they hold, or with --fit first to the "
             "first of them",
         frames_syntax},
        [](const std::string& text) { return parse_frames(text); });
    add_file(command, options.fit.camera, "--camera", "SCENE",
             "See everything by the camera of this TOML scene, or by the view of it that --view names");
    CLI::Option* first = add_flag(command, frames.fit_first, fit_first, "");
    first->group("");  // written as --fit first
    first->excludes(command.get_option("--no-fit"));
    CLI::Option* turntable =
        add_option(command, frames.turntable,
                   {"--turntable", "N", "N pictures once around; with --frames the view turns 1/N of that from frame to frame",
                    "the number of pictures of a turn, from 1"},
                   [](const std::string& text) { return whole_number<std::int64_t>(text, 1); });
    const std::string axes = listed(std::vector<std::string>(turn_axis_names.begin(), turn_axis_names.end()), "or");
    add_option(command, frames.axis,
               {"--axis", "AXIS", "What --turntable turns about: " + axes + " [up, the view's own upward direction]", axes},
               [](const std::string& text) { return turn_axis_named(text); })
        ->needs(turntable);
}

void check_frame_options(const CLI::App&, const RenderOptions& options) {
    const FrameOptions& frames = options.frames;
    if (frames.fit_first && frames.ranges.empty()) wrong("--fit", "'first'", "--frames, of which that is the first");
    if (options.fit.camera && (options.fit.wanted.value_or(false) || frames.fit_first)) {
        wrong("--camera", in_quotes(*options.fit.camera), "no --fit and no --view from a side beside it: they move the camera");
    }
}

void join_fit_first(std::vector<std::string>& words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] == "--") return;
        if (words[i] != "--fit" || words[i + 1] != "first") continue;
        words[i] = fit_first;
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
}

}  // namespace sphereview
