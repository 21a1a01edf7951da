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

// The scenes' sequences, where several pictures of each are asked for. What is wrong with one scene does not stop the others.
class Sequences {
public:
    // Opens those of options.scenes, of which no others are left; `options` and `progress` must outlive this. Throws as
    // FrameSequence, where there is but one.
    Sequences(RenderOptions& options, Progress& progress) : progress_(progress), is_only_one_(options.scenes.size() == 1) {
        if (!options.frames.several()) return;
        std::erase_if(options.scenes, [&](const std::string& scene) {
            return !succeeds([&] {
                if (options.frames.manifest) require_regular_file(scene);
                all_.push_back(std::make_shared<FrameSequence>(scene, options, progress_));
                if (const std::string& end = all_.back()->early_end(); !end.empty()) say(end);
            });
        });
    }

    std::span<const std::shared_ptr<FrameSequence>> all() const { return all_; }
    // Prepares them for the jobs, of which those of a wrong scene are left out.
    void prepare(std::vector<RenderJob>& jobs) {
        for (const auto& sequence : all_) {
            if (succeeds([&] { sequence->prepare(progress_); })) continue;
            std::erase_if(jobs, [&](const RenderJob& job) { return job.sequence == sequence; });
        }
    }
    // Done where no frame was lost, and no scene.
    ExitCode status() const {
        // The pictures are those of the frames before, but more were to be had.
        const bool is_damaged = std::ranges::any_of(all_, [](const auto& sequence) { return sequence->is_damaged(); });
        return is_damaged || has_wrong_one_ ? ExitCode::bad_input : ExitCode::done;
    }

private:
    template <typename Step>
    bool succeeds(const Step& step) {
        try {
            step();
            return true;
        } catch (const InputError& error) {
            if (is_only_one_) throw;
            progress_.clear();
            say(error.what());
            has_wrong_one_ = true;
            return false;
        }
    }

    Progress& progress_;
    std::vector<std::shared_ptr<FrameSequence>> all_{};
    bool is_only_one_;
    bool has_wrong_one_ = false;
};

// Leaves out what is there. Of pictures whose manifest is wanted only those are there that it knows.
void leave_out_existing(std::vector<RenderJob>& jobs, const RenderOptions& options, const Manifest* manifest) {
    if (!options.frames.skip_existing) return;
    if (manifest != nullptr && manifest->outdated() > 0) {
        const bool one = manifest->outdated() == 1;
        say(*options.frames.manifest + ": " + in_groups(manifest->outdated()) +
            (one ? " picture that was" : " pictures that were") + " made of another file or with other options " +
            (one ? "is" : "are") + " rendered anew");
    }
    const std::size_t all = jobs.size();
    std::erase_if(jobs, [&](const RenderJob& job) {
        return job.output && (manifest != nullptr ? manifest->has(*job.output)
                                                  : is_whole_png(*job.output, options.size.width, options.size.height));
    });
    if (options.verbose) say(in_groups(all - jobs.size()) + " of " + in_groups(all) + " pictures are there already");
}

}  // namespace

ExitCode run_render(const RenderOptions& asked_for) {
    RenderOptions options = asked_for;
    if (std::optional<std::string>& movie = options.film.movie)
        movie = fill_in(*movie, {.name = name_in_patterns(options.scenes.front())});
    // Light needs megabytes of its own, when what was needed before it is given back.
    if (options.shading == Shading::studio) return_large_blocks();
    Progress progress;
    const auto states = options.frames.manifest ? states_of_inputs(options) : std::map<std::string, FileStates>();
    Sequences sequences(options, progress);
    std::vector<RenderJob> jobs = plan_render(options, sequences.all());
    std::optional<Manifest> manifest;
    // What is there is compared with what would be made.
    const bool prepares_first = options.frames.manifest && options.frames.skip_existing;
    if (prepares_first) sequences.prepare(jobs);
    if (options.frames.manifest) manifest.emplace(options, jobs, states);
    leave_out_existing(jobs, options, manifest ? &*manifest : nullptr);
    if (jobs.empty()) return sequences.status();
    std::optional<Film> film;
    if (options.film.movie || options.streams_film()) film.emplace(options.film, options.durability, jobs.size());
    std::optional<InterruptibleFilm> interruptible;
    if (options.film.movie) interruptible.emplace(*film);
    if (!prepares_first) sequences.prepare(jobs);
    const RenderSinks sinks{film ? &*film : nullptr, manifest ? &*manifest : nullptr};
    const ExitCode status = run_jobs(options, jobs, sinks, progress);
    if (film && status == ExitCode::done) film->finish();
    for (const auto& sequence : sequences.all()) {
        if (const std::string beyond = sequence->values_beyond_range(); !beyond.empty()) say(beyond);
    }
    return std::max(status, sequences.status());
}

}  // namespace sphereview
