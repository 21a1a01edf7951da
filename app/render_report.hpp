// What one render has to say: for people on stderr, for programs as a JSON line on stdout.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/exit_code.hpp"
#include "app/options.hpp"
#include "app/render_picture.hpp"
#include "app/render_plan.hpp"
#include "base/timings.hpp"
#include "image/compare.hpp"

namespace sphereview {

struct RenderReport {
    RenderJob job;
    PictureSize size;
    int samples = 1;  // points a pixel
    Shading shading = Shading::flat;
    std::size_t spheres = 0;
    std::string backend;                   // "" while none was opened
    std::string renderer;                  // OpenBackend::description
    std::vector<std::string> passed_over;  // better ones, with reasons
    Timings timings;
    PictureFacts facts;
    std::optional<Comparison> comparison;
    ExitCode status = ExitCode::done;
    std::string error;  // "" when done
};

// On stderr: what `options` ask for (--verbose, --timings), and the error if there is one.
void print_words(const RenderReport& report, const RenderOptions& options);

// On stdout, as one line. Throws OutputError.
void print_json(const RenderReport& report);

}  // namespace sphereview
