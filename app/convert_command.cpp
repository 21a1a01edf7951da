// sphereview convert: one scene from one format to another.
#include <cstdio>

#include "app/load_scene.hpp"
#include "app/options.hpp"
#include "base/error.hpp"
#include "base/gunzip.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"

namespace sphereview {

ExitCode run_convert(const ConvertOptions& options) {
    const std::string input = options.input == standard_stream ? "" : file_identity(options.input);
    if (!input.empty() && input == file_identity(options.output)) {
        throw InputError(options.output + ": the output is also the input");
    }
    // Also with --to: whoever opens the file believes a name of data more than its content.
    const SceneFormat named = format_of_name(options.output);
    if (is_data(named)) {
        throw InputError(options.output + ": found a name for " + std::string(words_for(named)) +
                         ", which is only read; expected one for text or TOML (.txt, .toml)");
    }
    const SceneFormat format = options.to.value_or(named);
    if (without_gzip_ending(options.output) != options.output) {
        throw InputError(options.output + ": found a name for gzip, which is only read; expected one that ends with .txt or .toml");
    }
    check_output(options.output);

    FitOptions fit = options.fit;
    if (format == SceneFormat::text && !fit.wanted) fit.wanted = false;  // text holds no camera: none is made only to be lost
    const LoadedScene loaded = [&] {
        Progress progress(true);
        return load_scene(options.input, {.progress = &progress, .data = options.data, .fit = fit});
    }();
    if (const std::string lost = lost_in(loaded.scene, format); !lost.empty()) {
        std::fprintf(stderr, "%s: the text format cannot hold %s; left out\n", loaded.name.c_str(), lost.c_str());
    }
    write_output(options.output, write_scene(loaded.scene, format));
    return ExitCode::done;
}

}  // namespace sphereview
