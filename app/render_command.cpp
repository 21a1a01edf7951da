// The jobs of sphereview render: scenes in, PNG files out.
#include "app/render_command.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/failure.hpp"
#include "app/film.hpp"
#include "app/frame_sequence.hpp"
#include "app/interruptible.hpp"
#include "app/load_scene.hpp"
#include "app/manifest.hpp"
#include "app/options.hpp"
#include "app/picture_of_scene.hpp"
#include "app/render_picture.hpp"
#include "app/render_plan.hpp"
#include "app/render_report.hpp"
#include "base/background_job.hpp"
#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/ordered_work.hpp"
#include "base/output_file.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "base/sha256.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"
#include "base/timings.hpp"
#include "image/compare.hpp"
#include "image/png.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

namespace {

// One picture between its scene's file and its own.
struct Work {
    RenderReport report{};
    std::optional<PngReader> golden{};
    LoadedScene loaded{};
    bool failed = false;        // its report has the error; differing from a golden image is none
    bool lacks_memory = false;  // that is the error
    Image picture{};
    Image difference{};
    std::string png{};  // where there is an output
    PictureSums sums{};
    std::vector<std::string> warnings{};  // of the picture
};

bool is_lack_of_memory(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        return true;
    } catch (const MemoryError&) {
        return true;
    } catch (...) {
        return false;
    }
}

// Told how far a picture is, 0..1, with a note.
using Watcher = std::function<void(double, const std::string&)>;

// Renders one scene after the other, or several frames at once; opens the backend when the first needs it and keeps it.
class Batch {
public:
    Batch(const RenderOptions& options, std::span<const RenderJob> jobs, const RenderSinks& sinks, Progress& progress)
        : options_(options), jobs_(jobs), sinks_(sinks), progress_(progress) {}

    // Does the jobs and tells the person; never throws for what concerns one job alone. Returns the highest status.
    ExitCode run() {
        std::optional<Interruptible> interruptible;
        if (jobs_.size() > 1 && jobs_.front().sequence && jobs_.front().output && sinks_.film == nullptr && !sinks_.reported) {
            interruptible.emplace([this] { return how_far(); });
        }
        const bool are_frames = std::ranges::all_of(jobs_, [](const RenderJob& job) { return job.sequence != nullptr; });
        std::size_t next = are_frames && jobs_.size() > 1 && worker_count() > 1 ? run_several_at_once() : 0;
        while (next < jobs_.size() && run(next)) ++next;
        if (jobs_.size() > 1 && !failed_.empty() && !has_ended_film() && !sinks_.reported) say_what_failed();
        return report_failed_ ? std::max(worst_, ExitCode::no_output) : worst_;
    }

private:
    void say_what_failed() const {
        if (cannot_write_) {
            say("sphereview: ended where a picture could not be written; " + in_groups(done_) + " of " + in_groups(jobs_.size()) +
                " pictures were done");
            return;
        }
        const bool pictures = std::ranges::any_of(jobs_, [](const RenderJob& job) { return job.sequence || job.pixels_sum; });
        std::vector<std::string> named(failed_.begin(), failed_.begin() + static_cast<std::ptrdiff_t>(named_count()));
        if (named.size() < failed_.size()) named.push_back("and " + in_groups(failed_.size() - named.size()) + " more");
        say("sphereview: " + std::to_string(failed_.size()) + " of " + std::to_string(jobs_.size()) +
            (pictures ? " pictures failed: " : " scenes failed: ") + joined(named, pictures ? "; " : " "));
    }

    // Of those that failed, in a line that people read.
    std::size_t named_count() const { return failed_.size() <= most_named + 1 ? failed_.size() : most_named; }

    // For the end of the process. What is just written is waited for, unless it is a pipe that nobody reads.
    std::string how_far() {
        constexpr std::chrono::seconds patience{1};
        nothing_more_ = std::unique_lock(delivering_, patience);
        return "sphereview: interrupted; " + in_groups(done_) + " of " + in_groups(jobs_.size()) + " pictures were done";
    }

    bool run(std::size_t place) {
        Work work;
        begin(place, work);
        const std::string order =
            jobs_.size() > 1 ? " (" + std::to_string(place + 1) + " of " + std::to_string(jobs_.size()) + ")" : "";
        progress_.clear();
        progress_.start(jobs_[place].name + order, 1e-6 * options_.size.width * options_.size.height, "Mpixel");
        make(work, [this](double done, const std::string& note) { progress_.update(done, note); });
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
        errands_ = &errands;
        std::vector<std::unique_ptr<Work>> all(jobs_.size());
        // How much of each picture is made, 0..1. Not in its Work, which another thread may just set up.
        std::vector<std::atomic<double>> parts(jobs_.size());
        const std::uint64_t memory = available_memory().value_or(usual_room * 4);
        std::size_t next = 0;
        const auto part_done = [&](double places) { return places / static_cast<double>(jobs_.size()); };
        const auto make_one = [&](std::size_t place) {
            make(*all[place], [&part = parts[place]](double done, const std::string&) { part = done; });
        };
        progress_.start(jobs_.front().name, static_cast<double>(jobs_.size()), "picture");
        const OrderedWork steps{jobs_.size(),
                                [&](std::size_t place) {
                                    all[place] = std::make_unique<Work>();
                                    if (sinks_.reported) give_way();
                                    begin(place, *all[place]);
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
            // Those that are delivered are done.
        }
        errands_ = nullptr;
        progress_.clear();
        return next;
    }

    // As many frames like the last one as fit in the room for them.
    std::size_t most_at_once(std::uint64_t memory, int threads) const {
        const auto pixels = static_cast<std::uint64_t>(options_.size.width) * static_cast<std::uint64_t>(options_.size.height);
        const std::uint64_t bytes = bytes_of_a_pixel * pixels + bytes_of_a_sphere * spheres_of_last_ + 1;
        const std::uint64_t fit = std::min(usual_room, memory / 4) / bytes;
        return std::clamp<std::uint64_t>(fit, bytes < memory / 4 ? 2 : 1, static_cast<std::uint64_t>(2 * threads));
    }

    // Calls step() unless the work has failed, and notes what it throws; Cancelled goes on.
    template <typename Step>
    static void attempt(Work& work, const Step& step) {
        if (work.failed) return;
        try {
            step();
        } catch (const Cancelled&) {
            throw;
        } catch (...) {
            const Failure failure = describe_current_exception(work.report.job.label);
            work.report.status = failure.code;
            work.report.error = failure.message;
            work.failed = true;
            work.lacks_memory = is_lack_of_memory(std::current_exception());
        }
    }

    // Reads what the picture is made of.
    void begin(std::size_t place, Work& work) {
        const RenderJob& job = jobs_[place];
        work.report.job = job;
        attempt(work, [&] {
            if (job.output) check_output(*job.output, missing_folder(options_.output.value_or("")));
            if (job.diff) check_output(*job.diff, missing_folder(*options_.diff));
            if (job.expect) work.golden.emplace(open_png(*job.expect));
            work.loaded = read_scene(job, work.report);
            spheres_of_last_ = work.report.spheres = work.loaded.scene.spheres.size();
        });
    }

    void make(Work& work, const Watcher& watcher) {
        attempt(work, [&] {
            RenderReport& report = work.report;
            const RenderJob& job = report.job;
            draw(work, watcher);
            // Before anything is written: the rest of the golden may be damaged.
            if (work.golden) check(work.picture, *work.golden, job.diff ? &work.difference : nullptr, report);
            if (job.pixels_sum) check_sum(work.picture, job, report);
            if (job.output) work.png = timed(report.timings, Phase::encode, [&] { return encode_png(work.picture); });
            if (sinks_.manifest != nullptr) {
                work.sums.pixels = sum_of_pixels(work.picture);
                if (job.output) work.sums.file = sha256(work.png);
            }
            if (sinks_.film == nullptr) work.picture = Image();
        });
    }

    // Writes, and says what there is to say. False where nothing more is to be done.
    bool deliver(Work& work) {
        const std::lock_guard lock(delivering_);
        RenderReport& report = work.report;
        const RenderJob& job = report.job;
        if (!sinks_.reported) say_what_was_found(work);
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
        if (sinks_.reported) {
            sinks_.reported(report);
        } else {
            print_words(report, options_);
        }
        if (options_.json && !report_failed_) print_json_if_possible(report);
        if (report.status == ExitCode::done) {
            ++done_;
        } else {
            failed_.push_back(job.label);
        }
        worst_ = std::max(worst_, report.status);
        // What one picture of a sequence met, the next ones would meet as well.
        cannot_write_ = job.sequence && report.status == ExitCode::no_output;
        return !has_ended_film() && !cannot_write_;
    }

    static void say_what_was_found(const Work& work) {
        if (const auto& sequence = work.report.job.sequence) {
            for (const std::string& line : sequence->not_said(work.loaded.warnings)) say(line);
            for (const std::string& line : sequence->not_said(work.loaded.look.lines)) say(line);
        } else {
            say_warnings(work.loaded);
        }
        for (const std::string& warning : work.warnings) say(warning);
    }

    bool has_ended_film() const { return sinks_.film != nullptr && worst_ != ExitCode::done; }

    void print_json_if_possible(const RenderReport& report) {
        try {
            print_json(report, options_);
        } catch (const OutputError& error) {
            say(error.what());
            report_failed_ = true;  // what does not arrive whole is not worth going on with; the pictures are
        }
    }

    // The scene is given back then.
    void draw(Work& work, const Watcher& watcher) {
        RenderReport& report = work.report;
        const PictureOptions options = picture_options(work.loaded, options_);
        const Scene scene = std::exchange(work.loaded.scene, {});
        const DrawnSpheres drawn = timed(report.timings, Phase::prepare, [&] { return drawn_spheres(scene); });
        const bool shows_any = std::ranges::any_of(scene.spheres, std::not_fn(&Sphere::hidden));
        work.picture = render(scene, drawn, options, report, watcher);
        if (report.facts.shows_sphere || !shows_any) return;
        work.warnings.push_back(report.job.label +
                                (work.loaded.fitted
                                     ? ": no pixel shows a sphere, though the camera sees all: they are too small for the picture; "
                                       "a larger --size, or --radius where the file says none, shows them"
                                     : ": no pixel shows a sphere; --fit frames all"));
    }

    LoadedScene read_scene(const RenderJob& job, RenderReport& report) {
        const PhaseTimer timer(report.timings, Phase::read);
        LoadedScene loaded =
            job.sequence ? job.sequence->load(job.sequence->shots()[job.shot])
                         : load_scene(job.scene, {&progress_, bytes_to_draw_a_sphere, options_.data, options_.look, options_.fit});
        report.warnings = loaded.warnings;
        report.notes = loaded.notes;
        report.properties = loaded.property_names;
        report.look = loaded.look;
        return loaded;
    }

    // A context of GL is that of the thread that has opened it.
    Image render(const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options, RenderReport& report,
                 const Watcher& watcher) {
        const auto render_by = [&](OpenBackend& opened) {
            return render_by_what_holds_it(opened, options_.backend, [&](OpenBackend& backend) {
                report.backend = name_of(backend.backend);
                report.renderer = backend.description;
                report.passed_over = backend.passed_over;
                return render_picture(backend, scene, drawn, options, report.timings, report.facts, [&](double done) {
                    // They take long: people see why.
                    const auto exactly = static_cast<std::uint64_t>(report.facts.decisions.exactly);
                    watcher(done, exactly > 0 ? in_groups(exactly) + " exactly, " : "");
                });
            });
        };
        if (errands_ == nullptr) return render_by(backend_for(report));
        Image picture;
        OpenBackend* cpu = nullptr;
        errands_->ask([&] {
            OpenBackend& opened = backend_for(report);
            if (opened.gpu) {
                picture = render_by(opened);
            } else {
                cpu = &opened;
            }
        });
        return cpu != nullptr ? render_by(*cpu) : std::move(picture);
    }

    OpenBackend& backend_for(RenderReport& report) {
        const auto picture_bytes =
            static_cast<std::uint64_t>(options_.size.width) * static_cast<std::uint64_t>(options_.size.height) * 4;
        // Never closed: the process ends soon, and taking a driver down in good order takes milliseconds.
        static OpenBackend& opened =
            *new OpenBackend(best_for_these(open_backend(options_.backend, options_.device, report.timings, picture_bytes)));
        return opened;
    }

    // A processor that stands for a GPU does so with all cores for one frame, which takes longer than a frame on each.
    OpenBackend best_for_these(OpenBackend opened) const {
        const bool is_chosen = errands_ != nullptr && options_.backend == Backend::automatic;
        if (!is_chosen || !opened.context || !opened.context->is_software()) return opened;
        OpenBackend cpu;
        cpu.passed_over = opened.passed_over;
        cpu.passed_over.push_back(opened.description + ": it draws one frame at a time, where each core can trace one");
        return cpu;
    }

    static void check_sum(const Image& picture, const RenderJob& job, RenderReport& report) {
        const std::string sum = sum_of_pixels(picture);
        if (sum == *job.pixels_sum) return;
        report.status = ExitCode::differs;
        report.error = on_one_line(job.label + ": differs: the SHA-256 of its pixels is " + sum + ", expected " + *job.pixels_sum);
    }

    static void check(const Image& picture, PngReader& golden, Image* difference, RenderReport& report) {
        const Comparison comparison = compare(picture, golden, difference);
        report.comparison = comparison;
        if (comparison.equal()) return;
        report.status = ExitCode::differs;
        report.error = on_one_line(report.job.label + ": differs from " + *report.job.expect + ": " + describe(comparison));
    }

    // Of a frame on its way, about: its scene, what is drawn of it and the lists of tiles; the picture, its file and its points.
    static constexpr std::uint64_t bytes_of_a_sphere = 250;
    static constexpr std::uint64_t bytes_of_a_pixel = 12;
    static constexpr std::uint64_t usual_room = std::uint64_t{1} << 29;  // for all frames on their way
    static constexpr std::size_t most_named = 10;                        // of what failed

    const RenderOptions& options_;
    std::span<const RenderJob> jobs_;
    RenderSinks sinks_;
    Progress& progress_;
    Errands* errands_ = nullptr;  // of other threads, where several frames are on their way
    std::size_t spheres_of_last_ = 0;
    ExitCode worst_ = ExitCode::done;
    std::atomic<std::size_t> done_ = 0;
    std::timed_mutex delivering_{};
    std::unique_lock<std::timed_mutex> nothing_more_{};  // is delivered
    std::vector<std::string> failed_{};
    bool cannot_write_ = false;  // a picture of a sequence, which ends it
    bool report_failed_ = false;
};

}  // namespace

ExitCode run_jobs(const RenderOptions& options, std::span<const RenderJob> jobs, const RenderSinks& sinks, Progress& progress) {
    return Batch(options, jobs, sinks, progress).run();
}

}  // namespace sphereview
