#include "app/picture_work.hpp"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <new>
#include <utility>

#include "app/failure.hpp"
#include "app/frame_sequence.hpp"
#include "app/picture_of_scene.hpp"
#include "app/render_picture.hpp"
#include "base/error.hpp"
#include "base/output_file.hpp"
#include "base/sha256.hpp"
#include "base/text.hpp"
#include "base/timings.hpp"
#include "image/compare.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

namespace {

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

void check_sum(const Image& picture, const RenderJob& job, RenderReport& report) {
    const std::string sum = sum_of_pixels(picture);
    if (sum == *job.pixels_sum) return;
    report.status = ExitCode::differs;
    report.error = on_one_line(job.label + ": differs: the SHA-256 of its pixels is " + sum + ", expected " + *job.pixels_sum);
}

void check(const Image& picture, PngReader& golden, Image* difference, RenderReport& report) {
    const Comparison comparison = compare(picture, golden, difference);
    report.comparison = comparison;
    if (comparison.equal()) return;
    report.status = ExitCode::differs;
    report.error = on_one_line(report.job.label + ": differs from " + *report.job.expect + ": " + describe(comparison));
}

}  // namespace

void note_failure(PictureWork& work) {
    const Failure failure = describe_current_exception(work.report.job.label);
    work.report.status = failure.code;
    work.report.error = failure.message;
    work.failed = true;
    work.lacks_memory = is_lack_of_memory(std::current_exception());
}

void PictureMaker::begin(const RenderJob& job, PictureWork& work) {
    work.report.job = job;
    attempt(work, [&] {
        if (!job.fault.empty()) throw InputError(job.fault);
        if (job.output) check_output(*job.output, missing_folder(options_.output.value_or("")));
        if (job.diff) check_output(*job.diff, missing_folder(*options_.diff));
        if (job.expect) work.golden.emplace(open_png(*job.expect));
        if (wanted_.sums) require_regular_file(job.scene);
        try {
            work.loaded = read_scene(job, work.report);
        } catch (const ReadError&) {
            work.cannot_read_scene = true;
            throw;
        }
        spheres_of_last_ = work.report.spheres = work.loaded.scene.spheres.size();
    });
}

void PictureMaker::make(PictureWork& work, const PictureWatcher& watcher) {
    attempt(work, [&] {
        RenderReport& report = work.report;
        const RenderJob& job = report.job;
        draw(work, watcher);
        // Before anything is written: the rest of the golden may be damaged.
        if (work.golden) check(work.picture, *work.golden, job.diff ? &work.difference : nullptr, report);
        if (job.pixels_sum) check_sum(work.picture, job, report);
        if (job.output) work.png = timed(report.timings, Phase::encode, [&] { return encode_png(work.picture); });
        if (wanted_.sums) {
            work.sums.pixels = sum_of_pixels(work.picture);
            if (job.output) work.sums.file = sha256(work.png);
        }
        if (!wanted_.pixels) work.picture = Image();
    });
}

// The scene is given back then.
void PictureMaker::draw(PictureWork& work, const PictureWatcher& watcher) {
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

LoadedScene PictureMaker::read_scene(const RenderJob& job, RenderReport& report) {
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
Image PictureMaker::render(const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options, RenderReport& report,
                           const PictureWatcher& watcher) {
    const auto render_by = [&](OpenBackend& opened) {
        return render_by_what_holds_it(opened, options_.backend, [&](OpenBackend& backend) {
            report.backend = name_of(backend.backend);
            report.renderer = backend.description;
            report.passed_over = backend.passed_over;
            return render_picture(backend, scene, drawn, options, report.timings, report.facts, [&](double done) {
                // Exact decisions take long, so the note counts them.
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

OpenBackend& PictureMaker::backend_for(RenderReport& report) {
    const auto picture_bytes =
        static_cast<std::uint64_t>(options_.size.width) * static_cast<std::uint64_t>(options_.size.height) * 4;
    // Never closed: the process ends soon, and taking a driver down in good order takes milliseconds.
    static OpenBackend& opened =
        *new OpenBackend(best_for_these(open_backend(options_.backend, options_.device, report.timings, picture_bytes)));
    return opened;
}

// A processor that stands for a GPU does so with all cores for one frame, which takes longer than a frame on each.
OpenBackend PictureMaker::best_for_these(OpenBackend opened) const {
    const bool is_chosen = errands_ != nullptr && options_.backend == Backend::automatic;
    if (!is_chosen || !opened.context || !opened.context->is_software()) return opened;
    OpenBackend cpu;
    cpu.passed_over = opened.passed_over;
    cpu.passed_over.push_back(opened.description + ": it draws one frame at a time, where each core can trace one");
    return cpu;
}

}  // namespace sphereview
