// The jobs of sphereview render: scenes in, PNG files out.
#include "app/render_command.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/failure.hpp"
#include "app/film.hpp"
#include "app/frame_sequence.hpp"
#include "app/json.hpp"
#include "app/load_scene.hpp"
#include "app/manifest.hpp"
#include "app/options.hpp"
#include "app/picture_of_scene.hpp"
#include "app/render_picture.hpp"
#include "app/render_plan.hpp"
#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/output_file.hpp"
#include "base/progress.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"
#include "base/timings.hpp"
#include "image/compare.hpp"
#include "image/png.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

namespace {

// What one render has to say: for people on stderr, for programs as a JSON line on stdout.
struct RenderReport {
    RenderJob job;
    std::size_t spheres = 0;
    std::string backend;                   // "" while none was opened
    std::string renderer;                  // OpenBackend::description
    std::vector<std::string> passed_over;  // better ones, with reasons
    Timings timings;
    PictureFacts facts;
    std::optional<Comparison> comparison;
    std::vector<std::string> warnings;  // of the scene's file, and of the picture
    std::vector<std::string> notes;     // of the file
    AppliedLook look;
    ExitCode status = ExitCode::done;
    std::string error;  // "" when done
};

Json to_json(const RenderReport& report, const RenderOptions& options) {
    Json timings;
    for (std::size_t i = 0; i < phase_names.size(); ++i) timings.set(phase_names[i], report.timings[static_cast<Phase>(i)]);
    Json json = {
        {"scene", report.job.scene_label},
        {"status", static_cast<int>(report.status)},
        {"error", report.error.empty() ? Json(nullptr) : Json(report.error)},
        {"warnings", report.warnings},
        {"notes", report.notes},
        {"output", report.job.output},
        {"size", {options.size.width, options.size.height}},
        {"samples", options.samples},
        {"shade", name_of(options.shading)},
        {"spheres", report.spheres},
        {"backend", report.backend.empty() ? Json(nullptr) : Json(report.backend)},
        {"renderer", report.renderer.empty() ? Json(nullptr) : Json(report.renderer)},
        {"passed_over", report.passed_over},
        {"decided",
         {{"float", report.facts.decisions.in_float},
          {"double", report.facts.decisions.in_double},
          {"exact", report.facts.decisions.exactly}}},
        {"spheres_in", report.facts.spheres_in.empty() ? Json(nullptr) : Json(report.facts.spheres_in)},
        {"tiles",
         {{"sides", report.facts.tile_sides},
          {"candidates", report.facts.candidates},
          {"longest_list", report.facts.longest_list}}},
        {"timings_ms", timings},
    };
    if (options.look.any()) json.update(to_json(report.look));
    if (report.job.sequence) json.set("frame", report.job.sequence->shots()[report.job.shot].number);
    if (report.comparison) {
        const Comparison& comparison = *report.comparison;
        const bool has_first = comparison.different_pixels > 0;
        json.set("comparison", {{"expected", report.job.expect},
                                {"equal", comparison.equal()},
                                {"same_size", comparison.same_size()},
                                {"different_pixels", comparison.different_pixels},
                                {"largest_difference", comparison.largest},
                                {"first", has_first ? Json{comparison.first_x, comparison.first_y} : Json(nullptr)}});
    }
    return json;
}

void print_backend(const RenderReport& report, const RenderOptions& options) {
    std::string line = report.job.label + ": backend: " + report.renderer;
    if (!report.passed_over.empty()) line += "; passed over: " + joined(report.passed_over, "; ");
    if (options.shading != Shading::flat) line += "; shaded: " + std::string(name_of(options.shading));
    say(line);
}

// Tiles and decisions are of points where a pixel has several.
std::string unit_of(const RenderOptions& options) {
    return options.samples == 1 ? "pixels" : "points (" + std::to_string(options.samples) + " a pixel)";
}

// "NAME: tiles of 16 and 4 pixels, candidates: 2,600,000, in the longest list: 400; spheres in buffer textures".
void print_tiles(const RenderReport& report, const RenderOptions& options) {
    const PictureFacts& facts = report.facts;
    if (facts.spheres_in.empty()) return;
    std::vector<std::string> sides;
    for (const int side : facts.tile_sides) sides.push_back(std::to_string(side));
    const std::string tiles = sides.empty() ? "no sphere is in the picture"
                                            : "tiles of " + listed(sides, "and") + (options.samples == 1 ? " pixels" : " points");
    say(report.job.label + ": " + tiles + ", candidates: " + in_groups(facts.candidates) +
        ", in the longest list: " + in_groups(facts.longest_list) + "; spheres in " + facts.spheres_in);
}

// Nothing was counted where best guesses were kept, or nothing was drawn.
void print_decisions(const RenderReport& report, const RenderOptions& options) {
    const DecisionCounts& counts = report.facts.decisions;
    if (counts.in_float + counts.in_double + counts.exactly == 0) return;
    say(report.job.label + ": " + unit_of(options) + " decided: " + std::to_string(counts.in_float) + " in float, " +
        std::to_string(counts.in_double) + " in double, " + std::to_string(counts.exactly) + " exactly");
}

void print_timings(const RenderReport& report) {
    for (std::size_t i = 0; i < phase_names.size(); ++i) {
        std::fprintf(stderr, "%-10s %9s ms\n", std::string(phase_names[i]).c_str(),
                     fixed(report.timings[static_cast<Phase>(i)], 3).c_str());
    }
}

// On stderr: what `options` ask for (--verbose, --timings), and the error if there is one.
void print_words(const RenderReport& report, const RenderOptions& options) {
    for (const std::string& note : report.notes) {
        if (options.verbose) say(note);
    }
    if (options.verbose && !report.renderer.empty()) print_backend(report, options);
    if (options.timings) print_timings(report);
    if (options.verbose || options.timings) {
        print_tiles(report, options);
        print_decisions(report, options);
    }
    if (!report.error.empty()) std::fprintf(stderr, "%s\n", report.error.c_str());
}

// On stdout, as one line. Throws OutputError.
void print_json(const RenderReport& report, const RenderOptions& options) {
    write_output(std::string(standard_stream), to_json(report, options).dump() + "\n");
}

// Renders one scene after the other; opens the backend when the first needs it and keeps it.
class Batch {
public:
    Batch(const RenderOptions& options, std::size_t scenes, const RenderSinks& sinks, Progress& progress)
        : options_(options), scenes_(scenes), sinks_(sinks), progress_(progress) {}

    // Does one job and tells the person; never throws for what concerns this job alone.
    ExitCode run(const RenderJob& job) {
        ++started_;
        RenderReport report;
        report.job = job;
        try {
            work(job, report);
        } catch (...) {
            const Failure failure = describe_current_exception(job.label);
            report.status = failure.code;
            report.error = failure.message;
        }
        progress_.clear();
        print_words(report, options_);
        if (options_.json && !report_failed_) print_json_if_possible(report);
        return report.status;
    }

    // Whether a line of the JSON report could not be written; the person has been told.
    bool report_failed() const { return report_failed_; }

private:
    void print_json_if_possible(const RenderReport& report) {
        try {
            print_json(report, options_);
        } catch (const OutputError& error) {
            say(error.what());
            report_failed_ = true;  // what does not arrive whole is not worth going on with; the pictures are
        }
    }

    void work(const RenderJob& job, RenderReport& report) {
        if (job.output) check_output(*job.output, missing_folder(options_.output.value_or("")));
        if (job.diff) check_output(*job.diff, missing_folder(*options_.diff));
        std::optional<PngReader> golden;
        if (job.expect) golden.emplace(open_png(*job.expect));
        const LoadedScene loaded = read_scene(job, report);
        const Scene& scene = loaded.scene;
        report.spheres = scene.spheres.size();

        const std::string order = scenes_ > 1 ? " (" + std::to_string(started_) + " of " + std::to_string(scenes_) + ")" : "";
        progress_.start(job.name + order, 1e-6 * options_.size.width * options_.size.height, "Mpixel");
        const DrawnSpheres drawn = timed(report.timings, Phase::prepare, [&] { return drawn_spheres(scene); });
        const bool shows_any = std::ranges::any_of(scene.spheres, std::not_fn(&Sphere::hidden));
        const PictureOptions options = picture_options(loaded, options_);
        const Image picture = render(scene, drawn, options, report);
        if (loaded.fitted && !report.facts.shows_sphere && shows_any) {
            report.warnings.push_back(job.label +
                                      ": no pixel shows a sphere, though the camera sees all: they are too small for the picture; "
                                      "a larger --size, or --radius where the file says none, shows them");
            progress_.clear();
            say(report.warnings.back());
        }

        // Before anything is written: the rest of the golden may be damaged.
        Image difference;
        if (golden) check(picture, *golden, job.diff ? &difference : nullptr, report);
        if (job.pixels_sum) check_sum(picture, job, report);
        if (sinks_.film != nullptr) timed(report.timings, Phase::encode, [&] { sinks_.film->add(picture); });
        if (job.output) {
            write_png(picture, job, report.timings);
        } else if (sinks_.manifest != nullptr) {
            sinks_.manifest->add(job, picture, std::nullopt);
        }
        if (job.diff) write_output(*job.diff, encode_png(difference), options_.durability, missing_folder(*options_.diff));
    }

    LoadedScene read_scene(const RenderJob& job, RenderReport& report) {
        const PhaseTimer timer(report.timings, Phase::read);
        LoadedScene loaded =
            job.sequence ? job.sequence->load(job.sequence->shots()[job.shot])
                         : load_scene(job.scene, {&progress_, bytes_to_draw_a_sphere, options_.data, options_.look, options_.fit});
        progress_.clear();
        if (job.sequence) {
            for (const std::string& line : job.sequence->not_said(loaded.warnings)) say(line);
            for (const std::string& line : job.sequence->not_said(loaded.look.lines)) say(line);
        } else {
            say_warnings(loaded);
        }
        report.warnings = loaded.warnings;
        report.notes = loaded.notes;
        report.look = loaded.look;
        return loaded;
    }

    Image render(const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options, RenderReport& report) {
        return render_by_what_holds_it(backend_for(report), options_.backend, [&](OpenBackend& backend) {
            report.backend = name_of(backend.backend);
            report.renderer = backend.description;
            report.passed_over = backend.passed_over;
            return render_picture(backend, scene, drawn, options, report.timings, report.facts, [&](double done) {
                // They take long: people see why.
                const auto exactly = static_cast<std::uint64_t>(report.facts.decisions.exactly);
                progress_.update(done, exactly > 0 ? in_groups(exactly) + " exactly, " : "");
            });
        });
    }

    OpenBackend& backend_for(RenderReport& report) {
        const auto picture_bytes =
            static_cast<std::uint64_t>(options_.size.width) * static_cast<std::uint64_t>(options_.size.height) * 4;
        // Never closed: the process ends soon, and taking a driver down in good order takes milliseconds.
        static OpenBackend& opened =
            *new OpenBackend(open_backend(options_.backend, options_.device, report.timings, picture_bytes));
        return opened;
    }

    void write_png(const Image& picture, const RenderJob& job, Timings& timings) const {
        const std::string png = timed(timings, Phase::encode, [&] { return encode_png(picture); });
        timed(timings, Phase::write,
              [&] { write_output(*job.output, png, options_.durability, missing_folder(options_.output.value_or(""))); });
        if (sinks_.manifest != nullptr) sinks_.manifest->add(job, picture, png);
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

    const RenderOptions& options_;
    std::size_t scenes_;
    RenderSinks sinks_;
    std::size_t started_ = 0;
    bool report_failed_ = false;
    Progress& progress_;
};

}  // namespace

ExitCode run_jobs(const RenderOptions& options, std::span<const RenderJob> jobs, const RenderSinks& sinks, Progress& progress) {
    Batch batch(options, jobs.size(), sinks, progress);
    ExitCode worst = ExitCode::done;
    std::vector<std::string> failed;
    for (const RenderJob& job : jobs) {
        const ExitCode status = batch.run(job);
        if (status != ExitCode::done) failed.push_back(job.label);
        worst = std::max(worst, status);
        if (sinks.film != nullptr && status != ExitCode::done) return worst;
    }
    if (jobs.size() > 1 && !failed.empty()) {
        const bool pictures = std::ranges::any_of(jobs, [](const RenderJob& job) { return job.sequence || job.pixels_sum; });
        std::string summary = std::to_string(failed.size()) + " of " + std::to_string(jobs.size()) +
                              (pictures ? " pictures failed: " : " scenes failed: ") + joined(failed, pictures ? "; " : " ");
        say("sphereview: " + summary);
    }
    return batch.report_failed() ? std::max(worst, ExitCode::no_output) : worst;
}

}  // namespace sphereview
