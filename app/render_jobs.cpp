// The jobs of sphereview render: scenes in, PNG files out.
#include "app/render_jobs.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "app/failure.hpp"
#include "app/film.hpp"
#include "app/frame_sequence.hpp"
#include "app/interruptible.hpp"
#include "app/load_scene.hpp"
#include "app/manifest.hpp"
#include "app/options.hpp"
#include "app/picture_work.hpp"
#include "app/render_plan.hpp"
#include "app/render_report.hpp"
#include "base/background_job.hpp"
#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/ordered_work.hpp"
#include "base/output_file.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"
#include "base/timings.hpp"
#include "image/png.hpp"

namespace sphereview {

namespace {

// Renders one scene after the other, or several frames at once.
class Batch {
public:
    Batch(const RenderOptions& options, std::span<const RenderJob> jobs, const RenderSinks& sinks, Progress& progress)
        : options_(options),
          jobs_(jobs),
          pictures_(count_pictures(jobs)),
          sinks_(sinks),
          progress_(progress),
          maker_(options, {sinks.film != nullptr, sinks.manifest != nullptr}, progress) {}

    // Does the jobs and tells the person; never throws for what concerns one job alone. Returns the highest status.
    ExitCode run() {
        std::optional<Interruptible> interruptible;
        const bool ends_whole = sinks_.film != nullptr && !sinks_.film->is_streamed();  // then the film has its own last words
        const bool are_frames = std::ranges::any_of(jobs_, [](const RenderJob& job) { return job.sequence != nullptr; });
        if (jobs_.size() > 1 && are_frames && !ends_whole && has_terminal()) {
            interruptible.emplace([this] { return how_far(); });
        }
        std::size_t next = are_frames && jobs_.size() > 1 && worker_count() > 1 ? run_several_at_once() : 0;
        while (next < jobs_.size() && run(next)) ++next;
        if (jobs_.size() > 1 && !has_ended_film() && has_terminal()) say_what_failed();
        if (are_frames && without_spheres_ > 1 && has_terminal()) {
            say("sphereview: " + in_groups(without_spheres_) + " of " + in_groups(pictures_) + " pictures show no sphere");
        }
        return report_failed_ ? std::max(worst_, ExitCode::no_output) : worst_;
    }

private:
    void say_what_failed() const {
        if (!ended_where_.empty()) {
            say("sphereview: ended where " + ended_where_ + "; " + in_groups(done_) + " of " + in_groups(pictures_) +
                " pictures were done");
            return;
        }
        std::size_t scenes = 0;
        const FrameSequence* last = nullptr;
        for (const RenderJob& job : jobs_) {
            if (!job.sequence || job.sequence.get() != last) ++scenes;
            last = job.sequence.get();
        }
        say_which_failed(failed_pictures_, pictures_, " pictures failed: ", "; ");
        say_which_failed(failed_scenes_, scenes, " scenes failed: ", " ");
    }

    static void say_which_failed(const std::vector<std::string>& failed, std::size_t all, const std::string& what,
                                 const std::string& between) {
        if (failed.empty()) return;
        const std::size_t count = failed.size() <= most_named + 1 ? failed.size() : most_named;
        std::vector<std::string> named(failed.begin(), failed.begin() + static_cast<std::ptrdiff_t>(count));
        if (named.size() < failed.size()) named.push_back("and " + in_groups(failed.size() - named.size()) + " more");
        say("sphereview: " + std::to_string(failed.size()) + " of " + std::to_string(all) + what + joined(named, between));
    }

    // For the end of the process. What is just written is waited for, unless it is a pipe that nobody reads.
    std::string how_far() {
        constexpr std::chrono::seconds patience{1};
        nothing_more_ = std::unique_lock(delivering_, patience);
        return "sphereview: interrupted; " + in_groups(done_) + " of " + in_groups(pictures_) + " pictures were done";
    }

    bool run(std::size_t place) {
        PictureWork work;
        maker_.begin(jobs_[place], work);
        const std::string order =
            jobs_.size() > 1 ? " (" + std::to_string(place + 1) + " of " + std::to_string(jobs_.size()) + ")" : "";
        progress_.clear();
        progress_.start(jobs_[place].name + order, 1e-6 * options_.size.width * options_.size.height, "Mpixel");
        maker_.make(work, [this](double done, const std::string& note) { progress_.update(done, note); });
        progress_.clear();
        return deliver(work);
    }

    // Reading of one frame, tracing of others, and writing overlap. Returns the place of the first job that is to be done alone:
    // there is no memory for several, or there can be no threads.
    std::size_t run_several_at_once() {
        const int cores = worker_count();
        // One waits for the GPU while all cores have work.
        const int threads = options_.backend == Backend::cpu ? cores : cores + 1;
        // What the C library reserves of addresses for a thread, one that does all alone needs not.
        constexpr std::uint64_t bytes_of_a_thread = std::uint64_t{1} << 26;
        if (address_space_left().value_or(usual_room * 4) < static_cast<std::uint64_t>(threads + 1) * bytes_of_a_thread) return 0;
        Errands errands;
        maker_.draw_by(&errands);
        std::vector<std::unique_ptr<PictureWork>> all(jobs_.size());
        // How much of each picture is made, 0..1. Not in its PictureWork, which another thread may just set up.
        std::vector<std::atomic<double>> parts(jobs_.size());
        const std::uint64_t memory = available_memory().value_or(usual_room * 4);
        std::size_t next = 0;
        const auto part_done = [&](double places) { return places / static_cast<double>(jobs_.size()); };
        const auto make_one = [&](std::size_t place) {
            maker_.make(*all[place], [&part = parts[place]](double done, const std::string&) { part = done; });
        };
        progress_.start(jobs_.front().name, static_cast<double>(jobs_.size()), "picture");
        const OrderedWork steps{jobs_.size(),
                                [&](std::size_t place) {
                                    all[place] = std::make_unique<PictureWork>();
                                    if (!has_terminal()) give_way();
                                    maker_.begin(jobs_[place], *all[place]);
                                    // Where all cores can have a frame of their own, no thread waits for another.
                                    keep_loops_on_this_thread(most_at_once(memory, threads) >= static_cast<std::size_t>(cores));
                                },
                                make_one,
                                [&](std::size_t place) {
                                    progress_.clear();
                                    if (all[place]->lacks_memory) return false;
                                    const bool goes_on = deliver(*all[place]);
                                    next = goes_on ? place + 1 : jobs_.size();
                                    all[place].reset();
                                    progress_.update(part_done(static_cast<double>(place + 1)));
                                    return goes_on;
                                },
                                [&](std::size_t place) { progress_.update(part_done(static_cast<double>(place) + parts[place])); },
                                [&] { return most_at_once(memory, threads); }};
        try {
            do_in_order(steps, threads, errands);
        } catch (const std::bad_alloc&) {
            // The delivered pictures are done.
        }
        maker_.draw_by(nullptr);
        progress_.clear();
        return next;
    }

    // As many frames like the last one as fit in the room for them.
    std::size_t most_at_once(std::uint64_t memory, int threads) const {
        const auto pixels = static_cast<std::uint64_t>(options_.size.width) * static_cast<std::uint64_t>(options_.size.height);
        const std::uint64_t bytes = bytes_of_a_pixel * pixels + bytes_of_a_sphere * maker_.spheres_of_last() + 1;
        const std::uint64_t fit = std::min(usual_room, memory / 4) / bytes;
        return std::clamp<std::uint64_t>(fit, bytes < memory / 4 ? 2 : 1, static_cast<std::uint64_t>(2 * threads));
    }

    // Writes, and says what there is to say. False where nothing more is to be done.
    bool deliver(PictureWork& work) {
        const std::lock_guard lock(delivering_);
        RenderReport& report = work.report;
        const RenderJob& job = report.job;
        if (has_terminal()) say_what_was_found(work);
        report.warnings.insert(report.warnings.end(), work.warnings.begin(), work.warnings.end());
        attempt(work, [&] {
            if (sinks_.film != nullptr) timed(report.timings, Phase::encode, [&] { sinks_.film->add(work.picture); });
            if (job.output) {
                timed(report.timings, Phase::write, [&] {
                    write_output(*job.output, work.png, options_.durability, missing_folder(options_.output.value_or("")));
                });
            }
            if (sinks_.manifest != nullptr) sinks_.manifest->add(job, work.sums);
            if (job.diff) write_output(*job.diff, encode_png(work.difference), options_.durability, missing_folder(*options_.diff));
        });
        if (has_terminal()) {
            print_words(report, options_);
        } else {
            sinks_.reported(report);
        }
        if (options_.json && !report_failed_) print_json_if_possible(report);
        if (report.status == ExitCode::done) {
            ++done_;
        } else {
            (job.sequence || job.pixels_sum ? failed_pictures_ : failed_scenes_).push_back(job.label);
        }
        worst_ = std::max(worst_, report.status);
        // What one picture of a sequence met, the next ones would meet as well.
        if (job.sequence && report.status == ExitCode::no_output) ended_where_ = "a picture could not be written";
        if (job.sequence && work.cannot_read_scene) ended_where_ = "a scene could not be read";
        if (sinks_.manifest != nullptr && sinks_.manifest->has_lost_scene()) ended_where_ = "a scene had changed";
        return !has_ended_film() && ended_where_.empty();
    }

    void say_what_was_found(const PictureWork& work) {
        const auto& sequence = work.report.job.sequence;
        if (sequence) {
            for (const std::string& line : sequence->not_said(work.loaded.warnings)) say(line);
            for (const std::string& line : sequence->not_said(work.loaded.look.lines)) say(line);
        } else {
            say_warnings(work.loaded);
        }
        if (work.report.job.pixels_sum) return;  // whoever made the pictures was told
        // Of a film's pictures the first is enough, and how many there were.
        for (const std::string& warning : work.warnings) {
            if (without_spheres_++ == 0 || !sequence) say(warning);
        }
    }

    bool has_terminal() const { return !sinks_.reported; }
    bool has_ended_film() const { return sinks_.film != nullptr && worst_ != ExitCode::done; }

    void print_json_if_possible(const RenderReport& report) {
        try {
            print_json(report, options_);
        } catch (const OutputError& error) {
            say(error.what());
            report_failed_ = true;  // what does not arrive whole is not worth going on with; the pictures are
        }
    }

    // Of a frame on its way, about: its scene, what is drawn of it and the lists of tiles; the picture, its file and its points.
    static constexpr std::uint64_t bytes_of_a_sphere = 250;
    static constexpr std::uint64_t bytes_of_a_pixel = 12;
    static constexpr std::uint64_t usual_room = std::uint64_t{1} << 29;  // for all frames on their way
    static constexpr std::size_t most_named = 10;                        // of what failed

    const RenderOptions& options_;
    std::span<const RenderJob> jobs_;
    std::size_t pictures_;
    RenderSinks sinks_;
    Progress& progress_;
    PictureMaker maker_;
    ExitCode worst_ = ExitCode::done;
    std::atomic<std::size_t> done_ = 0;
    std::timed_mutex delivering_{};
    std::unique_lock<std::timed_mutex> nothing_more_{};  // is delivered
    std::vector<std::string> failed_pictures_{};         // of several of a scene
    std::vector<std::string> failed_scenes_{};
    std::size_t without_spheres_ = 0;  // pictures that show none
    std::string ended_where_{};        // "" while all goes on
    bool report_failed_ = false;
};

}  // namespace

ExitCode run_jobs(const RenderOptions& options, std::span<const RenderJob> jobs, const RenderSinks& sinks, Progress& progress) {
    return Batch(options, jobs, sinks, progress).run();
}

}  // namespace sphereview
