// Rendering what is planned.
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
    Film* film = nullptr;  // the first picture that fails ends it, and the work
    Manifest* manifest = nullptr;
    // Where there is a window and no terminal: told of each picture in its turn, with what there is to say of it. The threads give
    // way to others. May throw, which ends the work.
    std::function<void(const RenderReport&)> reported{};
};

// Does the jobs one after the other, whose sequences are prepared; what concerns one alone does not stop the others, but a picture
// of a sequence that cannot be written does. Returns the highest status.
ExitCode run_jobs(const RenderOptions& options, std::span<const RenderJob> jobs, const RenderSinks& sinks, Progress& progress);

}  // namespace sphereview
