// Reports on rendered pictures.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/failure.hpp"
#include "app/look.hpp"
#include "app/options.hpp"
#include "app/render_picture.hpp"
#include "app/render_plan.hpp"
#include "base/timings.hpp"
#include "image/compare.hpp"

namespace sphereview {

// The report on one picture: for people on stderr, for programs as a JSON line on stdout.
struct RenderReport {
    RenderJob job;
    std::size_t spheres = 0;
    std::string backend;                   // "" while none was opened
    std::string renderer;                  // OpenBackend::description
    std::vector<std::string> passed_over;  // better backends, with reasons
    Timings timings;
    PictureFacts facts;
    std::optional<Comparison> comparison;
    std::vector<std::string> warnings;    // of the scene's file, and of the picture
    std::vector<std::string> notes;       // of the file
    std::vector<std::string> properties;  // the names of all properties in the file
    AppliedLook look;
    ExitCode status = ExitCode::done;
    std::string error;  // "" when done
};

// Prints what `options` ask for (--verbose, --timings), and the error if there is one, on stderr.
void print_words(const RenderReport& report, const RenderOptions& options);

// Prints the report on stdout, as one line. Throws OutputError.
void print_json(const RenderReport& report, const RenderOptions& options);

}  // namespace sphereview
