// sphereview render: scenes in, PNG files out.
#include <algorithm>
#include <cstdio>
#include <optional>

#include "app/failure.hpp"
#include "app/load_scene.hpp"
#include "app/options.hpp"
#include "app/render_picture.hpp"
#include "app/render_plan.hpp"
#include "app/render_report.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/progress.hpp"
#include "base/text.hpp"
#include "image/compare.hpp"
#include "image/png.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

namespace {

// Renders one scene after the other; opens the backend when the first needs it and keeps it.
class Batch {
public:
    Batch(const RenderOptions& options, std::size_t scenes) : options_(options), scenes_(scenes) {}

    // Does one job and tells the person; never throws for what concerns this job alone.
    ExitCode run(const RenderJob& job) {
        ++started_;
        RenderReport report;
        report.job = job;
        report.size = options_.size;
        report.samples = options_.samples;
        report.shading = options_.shading;
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
            print_json(report);
        } catch (const OutputError& error) {
            std::fprintf(stderr, "%s\n", error.what());
            report_failed_ = true;  // what does not arrive whole is not worth going on with; the pictures are
        }
    }

    void work(const RenderJob& job, RenderReport& report) {
        if (job.output) check_output(*job.output);
        if (job.diff) check_output(*job.diff);
        std::optional<Image> golden;
        if (job.expect) golden = read_golden(*job.expect);
        const Scene scene = read_scene(job.scene, report);
        report.spheres = scene.spheres.size();

        const std::string order = scenes_ > 1 ? " (" + std::to_string(started_) + " of " + std::to_string(scenes_) + ")" : "";
        progress_.start(job.name + order, 1e-6 * options_.size.width * options_.size.height, "Mpixel");
        const DrawnSpheres drawn = [&] {
            const PhaseTimer timer(report.timings, Phase::prepare);
            return drawn_spheres(scene);
        }();
        const PictureOptions options{scene.camera,     options_.size,    options_.background.value_or(scene.background),
                                     options_.certify, options_.samples, options_.shading};
        const Image picture = render_by_what_holds_it(scene, drawn, options, report);

        if (job.output) write_png(picture, *job.output, report.timings);
        if (golden) check(picture, *golden, job, report);
    }

    static Image read_golden(const std::string& path) {
        const InputFile file(path, Content::binary);
        return decode_png(file.bytes(), file.name());
    }

    Scene read_scene(const std::string& path, RenderReport& report) {
        const PhaseTimer timer(report.timings, Phase::read);
        return load_scene(path, {&progress_, bytes_to_draw_a_sphere, options_.data, options_.fit}).scene;
    }

    Image render_by_what_holds_it(const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options,
                                  RenderReport& report) {
        const auto render = [&](OpenBackend& backend) {
            report.backend = name_of(backend.backend);
            report.renderer = backend.description;
            return render_picture(backend, scene, drawn, options, report.timings, report.facts, [&](double done) {
                // They take long: people see why.
                const auto exactly = static_cast<std::uint64_t>(report.facts.decisions.exactly);
                progress_.update(done, exactly > 0 ? in_groups(exactly) + " exactly, " : "");
            });
        };
        OpenBackend& opened = backend_for(report);
        try {
            return render(opened);
        } catch (const TooLarge& error) {
            if (options_.backend != Backend::automatic) {
                throw RenderError("the backend " + opened.description + " cannot hold the scene: " + error.what() +
                                  "; use --backend cpu");
            }
            report.passed_over.push_back(opened.description + ": " + error.what());
            return render(cpu_);
        }
    }

    OpenBackend& backend_for(RenderReport& report) {
        // Never closed: the process ends soon, and taking a driver down in good order takes milliseconds.
        static OpenBackend& opened = *new OpenBackend(open_backend(options_.backend, options_.device, report.timings));
        report.passed_over = opened.passed_over;
        return opened;
    }

    static void write_png(const Image& picture, const std::string& path, Timings& timings) {
        const std::string png = [&] {
            const PhaseTimer timer(timings, Phase::encode);
            return encode_png(picture);
        }();
        const PhaseTimer timer(timings, Phase::write);
        write_output(path, png);
    }

    static void check(const Image& picture, const Image& golden, const RenderJob& job, RenderReport& report) {
        const Comparison comparison = compare(picture, golden);
        report.comparison = comparison;
        if (!comparison.equal()) {
            report.status = ExitCode::differs;
            report.error = job.label + ": differs from " + *job.expect + ": " + describe(comparison, picture, golden);
        }
        if (job.diff) write_output(*job.diff, encode_png(difference_picture(picture, golden)));
    }

    const RenderOptions& options_;
    std::size_t scenes_;
    std::size_t started_ = 0;
    bool report_failed_ = false;
    OpenBackend cpu_;
    Progress progress_{true};
};

}  // namespace

ExitCode run_render(const RenderOptions& options) {
    const std::vector<RenderJob> jobs = plan_render(options);
    Batch batch(options, jobs.size());
    ExitCode worst = ExitCode::done;
    std::vector<std::string> failed;
    for (const RenderJob& job : jobs) {
        const ExitCode status = batch.run(job);
        if (status != ExitCode::done) failed.push_back(job.label);
        worst = std::max(worst, status);
    }
    if (jobs.size() > 1 && !failed.empty()) {
        std::string summary = std::to_string(failed.size()) + " of " + std::to_string(jobs.size()) + " scenes failed:";
        for (const std::string& scene : failed) summary += " " + scene;
        std::fprintf(stderr, "sphereview: %s\n", summary.c_str());
    }
    return batch.report_failed() ? std::max(worst, ExitCode::no_output) : worst;
}

}  // namespace sphereview
