// One picture between its scene's file and its own: read, drawn, compared and packed.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/load_scene.hpp"
#include "app/manifest.hpp"
#include "app/options.hpp"
#include "app/render_plan.hpp"
#include "app/render_report.hpp"
#include "base/background_job.hpp"
#include "base/ordered_work.hpp"
#include "base/progress.hpp"
#include "exact/drawn.hpp"
#include "image/image.hpp"
#include "image/png.hpp"

namespace sphereview {

struct PictureWork {
    RenderReport report{};
    std::optional<PngReader> golden{};
    LoadedScene loaded{};
    bool failed = false;             // its report has the error; differing from a golden image is none
    bool lacks_memory = false;       // that is the error
    bool cannot_read_scene = false;  // likewise: the file, whatever it holds
    Image picture{};
    Image difference{};
    std::string png{};  // where there is an output
    PictureSums sums{};
    std::vector<std::string> warnings{};  // of the picture
};

// Notes in the work's report what is being thrown, and that the work has failed.
void note_failure(PictureWork& work);

// Calls step() unless the work has failed, and notes what it throws; Cancelled goes on.
template <typename Step>
void attempt(PictureWork& work, const Step& step) {
    if (work.failed) return;
    try {
        step();
    } catch (const Cancelled&) {
        throw;
    } catch (...) {
        note_failure(work);
    }
}

// Told how far a picture is, 0..1, with a note.
using PictureWatcher = std::function<void(double, const std::string&)>;

// What is wanted of a picture besides its files.
struct WantedOfPictures {
    bool pixels = false;  // PictureWork::picture stays
    bool sums = false;
};

// Opens the backend when the first picture needs it, and keeps it.
class PictureMaker {
public:
    // `options` and `progress` must outlive this.
    PictureMaker(const RenderOptions& options, WantedOfPictures wanted, Progress& progress)
        : options_(options), wanted_(wanted), progress_(progress) {}

    // Where several pictures are on their way: who draws what a single thread may draw. Null: each thread may.
    void draw_by(Errands* errands) { errands_ = errands; }

    // Reads what the picture is made of; one at a time. Throws Cancelled.
    void begin(const RenderJob& job, PictureWork& work);
    // Draws the picture, compares it and makes its file. Throws Cancelled.
    void make(PictureWork& work, const PictureWatcher& watcher);

    // In the scene that begin() has read last.
    std::size_t spheres_of_last() const { return spheres_of_last_; }

private:
    LoadedScene read_scene(const RenderJob& job, RenderReport& report);
    void draw(PictureWork& work, const PictureWatcher& watcher);
    Image render(const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options, RenderReport& report,
                 const PictureWatcher& watcher);
    OpenBackend& backend_for(RenderReport& report);
    OpenBackend best_for_these(OpenBackend opened) const;

    const RenderOptions& options_;
    WantedOfPictures wanted_;
    Progress& progress_;
    Errands* errands_ = nullptr;
    std::size_t spheres_of_last_ = 0;
};

}  // namespace sphereview
