#include "viewer/film_job.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "app/film.hpp"
#include "app/frame_sequence.hpp"
#include "app/render_jobs.hpp"
#include "app/render_plan.hpp"
#include "app/render_report.hpp"
#include "base/error.hpp"

namespace sphereview {

namespace {

std::shared_ptr<FrameSequence> open_sequence(const FilmRequest& request, FilmStatus& status, Progress& progress) {
    const RenderOptions& options = request.options;
    if (request.is_of_file) {
        auto sequence = std::make_shared<FrameSequence>(options.scenes.front(), options, progress);
        if (!sequence->early_end().empty()) status.warn({sequence->early_end()});
        sequence->set_changes(request.changes);
        return sequence;
    }
    LoadedScene scene{{.scene = *request.shown}, options.scenes.front(), SceneFormat::toml};
    hide_and_light(scene.scene, {.light = request.changes.light});
    scene.look.coloring = request.coloring;
    return std::make_shared<FrameSequence>(std::move(scene), options);
}

// While the film lives.
class FilmInStatus {
public:
    FilmInStatus(FilmStatus& status, Film* film) : status_(status) { status_.set_film(film); }
    ~FilmInStatus() { status_.set_film(nullptr); }
    FilmInStatus(const FilmInStatus&) = delete;
    FilmInStatus& operator=(const FilmInStatus&) = delete;

private:
    FilmStatus& status_;
};

}  // namespace

double FilmStatus::part() const {
    if (pictures() == 0) return part_;
    const auto all = static_cast<double>(pictures());
    const auto before = static_cast<double>(done());
    return std::clamp(part_.load(), before / all, std::min((before + 1.0) / all, 1.0));
}

std::optional<double> FilmStatus::seconds_left() const {
    const double done = part();
    const double seconds = std::chrono::duration<double>(Clock::now() - begun_.load()).count();
    if (!(done > 0.0)) return std::nullopt;
    return seconds / done - seconds;
}

std::vector<std::string> FilmStatus::warnings() const {
    const std::lock_guard lock(mutex_);
    return warnings_;
}

bool FilmStatus::give_up_film() {
    const std::lock_guard lock(mutex_);
    return film_ != nullptr && film_->give_up().owns_lock();
}

void FilmStatus::set_film(Film* film) {
    const std::lock_guard lock(mutex_);
    film_ = film;
}

void FilmStatus::begin(std::size_t pictures) {
    begun_ = Clock::now();
    part_ = 0.0;
    pictures_ = pictures;
}

void FilmStatus::warn(const std::vector<std::string>& lines) {
    const std::lock_guard lock(mutex_);
    warnings_.insert(warnings_.end(), lines.begin(), lines.end());
}

void make_film(const FilmRequest& request, WorkControl& control, FilmStatus& status) {
    const RenderOptions& options = request.options;
    const std::function<void(double)> follow = [&](double done) {
        control.check();
        status.progress(done);
    };
    Progress progress(follow);
    const auto sequence = open_sequence(request, status, progress);
    const std::vector<RenderJob> jobs = plan_render(options, std::vector{OpenedScene{sequence}});
    const std::unique_ptr<Film> film =
        options.film.movie ? std::make_unique<Film>(options.film, options.durability, jobs.size()) : nullptr;
    const FilmInStatus known(status, film.get());
    if (film) film->begin();
    sequence->prepare(progress);
    status.begin(jobs.size());
    const auto reported = [&](const RenderReport& report) {
        control.check();
        status.warn(sequence->not_said(report.warnings));
        if (!report.error.empty()) throw InputError(report.error);  // which names its file
        status.add_done();
    };
    run_jobs(options, jobs, {.film = film.get(), .manifest = nullptr, .reported = reported}, progress);
    if (!film) return;
    control.begin_to_write();
    film->finish();
}

}  // namespace sphereview
