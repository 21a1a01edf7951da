// Renders the planned pictures.
#pragma once

#include <functional>
#include <span>

#include "app/failure.hpp"
#include "app/options.hpp"
#include "app/render_plan.hpp"
#include "base/progress.hpp"

namespace sphereview {

class Film;
class Manifest;
struct RenderReport;

// Where pictures go besides their files.
struct RenderSinks {
    Film* film = nullptr;  // the first failing picture ends the film and the work
    Manifest* manifest = nullptr;
    // Set by a window instead of a terminal: gets each picture's report, in order. The threads then give way to others. May throw,
    // which ends the work.
    std::function<void(const RenderReport&)> reported{};
};

// Does the jobs in order; their sequences must be prepared. A fault of one job does not stop the others, except a picture of a
// sequence that cannot be written. Returns the highest status.
ExitCode run_jobs(const RenderOptions& options, std::span<const RenderJob> jobs, const RenderSinks& sinks, Progress& progress);

}  // namespace sphereview
