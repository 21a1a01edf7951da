// The making of one picture: its scene is read, drawn, compared and packed.
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
    bool failed = false;             // `report` has the error; a difference from a golden image is none
    bool lacks_memory = false;       // the error is a lack of memory
    bool cannot_read_scene = false;  // the error is that the file cannot be read at all
    Image picture{};
    Image difference{};
    std::string png{};  // if there is an output
    PictureSums sums{};
    std::vector<std::string> warnings{};  // of the picture
};

// Notes the exception being handled in the work's report, and that the work has failed.
void note_failure(PictureWork& work);

// Calls step() unless the work has failed, and notes what step() throws; passes Cancelled on.
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

// Gets the finished part of a picture, 0..1, and a note.
using PictureWatcher = std::function<void(double, const std::string&)>;

// What the caller wants of each picture besides its files.
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

    // For several pictures at once: the thread that serves `errands` draws what a single thread must draw. Null: each thread draws.
    void draw_by(Errands* errands) { errands_ = errands; }

    // Reads the picture's inputs; call for one picture at a time. Throws Cancelled.
    void begin(const RenderJob& job, PictureWork& work);
    // Draws the picture, compares it and makes its file. Throws Cancelled.
    void make(PictureWork& work, const PictureWatcher& watcher);

    // The number of spheres in the scene that begin() read last.
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
