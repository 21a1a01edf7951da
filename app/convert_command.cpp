// sphereview convert: one scene from one format to another.
#include "app/load_scene.hpp"
#include "app/options.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"

namespace sphereview {

ExitCode run_convert(const ConvertOptions& options) {
    const std::string input = options.input == standard_stream ? "" : file_identity(options.input, FileUse::input);
    if (!input.empty() && input == file_identity(options.output, FileUse::output)) {
        throw InputError(options.output + ": the output is also the input");
    }
    // Whatever --to says: no command could open the file.
    if (const std::string fault = name_fault(options.output); !fault.empty()) {
        throw InputError(options.output + ": found " + fault);
    }
    check_output(options.output);

    const SceneFormat format = options.to.value_or(format_of_name(options.output));
    FitOptions fit = options.fit;
    if (format.holds_only_spheres && !fit.wanted) fit.wanted = false;  // no camera is made only to be lost
    LoadedScene loaded = [&] {
        Progress progress;
        return load_scene(options.input, {.progress = &progress, .data = options.data, .look = options.look, .fit = fit});
    }();
    say_warnings(loaded);
    if (options.verbose) {
        for (const std::string& note : loaded.notes) say(note);
        const std::string frame = "frame " + std::to_string(options.data.frame) + " of " + std::to_string(loaded.frames) + ", ";
        say(loaded.name + ": " + std::string(loaded.format.name) + ", " + (loaded.frames > 1 ? frame : "") +
            counted(loaded.scene.spheres.size(), "sphere"));
    }
    require_properties(loaded, options.data);
    // What was read only for colours and sizes is not kept.
    const bool keeps_properties = options.data.all_properties || !options.data.properties.empty() || !loaded.format.is_data;
    if (!keeps_properties) loaded.scene.properties.clear();
    if (const std::string lost = lost_in(loaded.scene, format); !lost.empty()) {
        say(loaded.name + ": the " + std::string(format.name) + " format cannot hold " + lost + "; left out");
    }
    write_output(options.output, write_scene(loaded.scene, format));
    return ExitCode::done;
}

}  // namespace sphereview
