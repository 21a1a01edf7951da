// sphereview render: which pictures, and where they go.
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/film.hpp"
#include "app/frame_sequence.hpp"
#include "app/manifest.hpp"
#include "app/options.hpp"
#include "app/render_jobs.hpp"
#include "app/render_plan.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/memory.hpp"
#include "base/progress.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"
#include "image/whole_png.hpp"

namespace sphereview {

namespace {

// The scenes, where several pictures of each are asked for. What is wrong with one does not stop the others, unless a part of all
// pictures is wanted: then it throws InputError.
std::vector<OpenedScene> opened_scenes(const RenderOptions& options, Progress& progress) {
    std::vector<OpenedScene> all;
    if (!options.frames.several()) return all;
    for (const std::string& scene : options.scenes) {
        OpenedScene& opened = all.emplace_back();
        try {
            if (options.frames.manifest) require_regular_file(scene);
            opened.sequence = std::make_shared<FrameSequence>(scene, options, progress);
            if (const std::string& end = opened.sequence->early_end(); !end.empty()) say(end);
        } catch (const InputError& error) {
            progress.clear();
            opened.fault = error.what();
            // Whoever can open the scene counts its pictures, too: parts would not fit together.
            const bool stops_others = options.scenes.size() > 1;
            if (options.frames.part) throw InputError(opened.fault + (stops_others ? "; --part needs all scenes" : ""));
        }
    }
    return all;
}

// Prepares the jobs' sequences. The jobs of a scene, which stand together, become one that says what is wrong with it.
void prepare(std::vector<RenderJob>& jobs, Progress& progress) {
    for (auto job = jobs.begin(); job != jobs.end();) {
        const auto sequence = job->sequence;
        auto end = std::find_if(job, jobs.end(), [&](const RenderJob& other) { return other.sequence != sequence; });
        try {
            if (sequence) sequence->prepare(progress);
        } catch (const InputError& error) {
            progress.clear();
            *job = job_of_scene(job->scene, error.what());
            end = jobs.erase(job + 1, end);
        }
        job = end;
    }
}

// Where a file is damaged, pictures are those of the frames before, but more were to be had.
ExitCode status_of(std::span<const OpenedScene> scenes) {
    const bool is_damaged =
        std::ranges::any_of(scenes, [](const OpenedScene& scene) { return scene.sequence && scene.sequence->is_damaged(); });
    return is_damaged ? ExitCode::bad_input : ExitCode::done;
}

// Leaves out what is there. Of pictures whose manifest is wanted only those are there that it knows.
void leave_out_existing(std::vector<RenderJob>& jobs, const RenderOptions& options, const Manifest* manifest) {
    if (!options.frames.skip_existing) return;
    if (manifest != nullptr && manifest->outdated() > 0) {
        const bool one = manifest->outdated() == 1;
        say(*options.frames.manifest + ": " + in_groups(manifest->outdated()) +
            (one ? " picture that was" : " pictures that were") + " made of another file or with other options " +
            (one ? "is" : "are") + " rendered anew");
    }
    const std::size_t all = count_pictures(jobs);
    std::erase_if(jobs, [&](const RenderJob& job) {
        return job.output && (manifest != nullptr ? manifest->has(*job.output)
                                                  : is_whole_png(*job.output, options.size.width, options.size.height));
    });
    if (options.verbose) say(in_groups(all - count_pictures(jobs)) + " of " + in_groups(all) + " pictures are there already");
}

}  // namespace

ExitCode run_render(const RenderOptions& asked_for) {
    RenderOptions options = asked_for;
    if (std::optional<std::string>& movie = options.film.movie)
        movie = fill_in(*movie, {.name = name_in_patterns(options.scenes.front())});
    // Light needs megabytes of its own, when what was needed before it is given back.
    if (is_lit(options.shading)) return_large_blocks();
    Progress progress;
    const auto states = options.frames.manifest ? states_of_inputs(options) : std::map<std::string, FileStates>();
    const std::vector<OpenedScene> scenes = opened_scenes(options, progress);
    std::vector<RenderJob> jobs = plan_render(options, scenes);
    // What is there is compared with what would be made.
    const bool prepares_first = options.frames.manifest && options.frames.skip_existing;
    if (prepares_first) prepare(jobs, progress);
    // Where no scene is right, what there is of an earlier run stays.
    if (!jobs.empty() && count_pictures(jobs) == 0) return run_jobs(options, jobs, {}, progress);
    std::optional<Manifest> manifest;
    if (options.frames.manifest) manifest.emplace(options, jobs, states);
    leave_out_existing(jobs, options, manifest ? &*manifest : nullptr);
    if (jobs.empty()) return status_of(scenes);
    std::optional<Film> film;
    if (options.film.movie || options.streams_film()) film.emplace(options.film, options.durability, jobs.size());
    std::optional<InterruptibleFilm> interruptible;
    if (options.film.movie) interruptible.emplace(*film);
    if (!prepares_first) prepare(jobs, progress);
    const RenderSinks sinks{film ? &*film : nullptr, manifest ? &*manifest : nullptr};
    const ExitCode status = run_jobs(options, jobs, sinks, progress);
    if (film && status == ExitCode::done) film->finish();
    for (const OpenedScene& scene : scenes) {
        const std::string beyond = scene.sequence ? scene.sequence->values_beyond_range() : "";
        if (!beyond.empty()) say(beyond);
    }
    return std::max(status, status_of(scenes));
}

}  // namespace sphereview
