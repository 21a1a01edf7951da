// View > Rays: the scene from beside, with an eye, its screen and its rays drawn over the picture. A way to look, no edit: nothing
// of it is saved or undone. What is seen from beside is a picture like any other, of the same renderers; the eye is the view that
// there was when the rays were shown.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/render_picture.hpp"
#include "base/background_job.hpp"
#include "panels/rays_panel.hpp"
#include "viewer/pinned_pixels.hpp"
#include "viewer/traced_rays.hpp"

namespace sphereview {

struct ViewerState;

// What is made beside the loop of what goes on changing: the latest is shown until there is a later one, and the next is begun when
// the one before has ended, so that a drag shows many of them.
template <typename Asked, typename Made>
class MadeBeside {
public:
    using Make = std::function<Made(WorkControl&)>;

    // Begins, by what begin() returns, unless that is what was begun last or something is still being made.
    void ask(const Asked& asked, const std::function<Make()>& begin) {
        if (job_ || begun_ == asked) return;
        begun_ = asked;
        making_ = std::make_shared<std::shared_ptr<const Made>>();
        job_ = std::make_unique<BackgroundJob>(
            [found = making_, make = begin()](WorkControl& control) { *found = std::make_shared<const Made>(make(control)); });
    }
    // Takes what has been made, if that is within the time; what failed leaves what there was. Returns whether something has ended.
    bool take(std::chrono::milliseconds time = std::chrono::milliseconds(0)) {
        if (!job_ || !job_->wait_for(time)) return false;
        job_.reset();
        if (*making_) {
            made_ = *making_;
            made_of_ = begun_;
        }
        making_.reset();
        return true;
    }
    // Has that made already.
    void set(const Asked& asked, std::shared_ptr<const Made> made) {
        begun_ = asked;
        made_of_ = asked;
        made_ = std::move(made);
    }

    bool works() const { return job_ != nullptr; }
    // Null before the first.
    const std::shared_ptr<const Made>& made() const { return made_; }
    bool is_of(const Asked& asked) const { return made_ && made_of_ == asked; }

private:
    std::optional<Asked> begun_{};
    std::optional<Asked> made_of_{};
    std::shared_ptr<std::shared_ptr<const Made>> making_{};
    std::shared_ptr<const Made> made_{};
    std::unique_ptr<BackgroundJob> job_{};
};

// All that the drawn rays depend on, and all that the eye's picture does.
struct AskedRays {
    std::uint64_t revision = 0;  // of the document
    RayChoice choice{};
    int row = 0;

    bool operator==(const AskedRays&) const = default;
};
struct AskedPicture {
    std::uint64_t revision = 0;
    PictureOptions options{};

    bool operator==(const AskedPicture&) const = default;
};

struct RaysInSpace {
    bool on = false;
    RayChoice choice{RaysShown::one, 0, 0};  // 0: what suits the picture

    // While they are shown:
    Camera camera{};                       // the eye's
    PictureSize size{};                    // of its picture
    double screen_depth = 1.0;             // how deep its screen is drawn (camera/beside.hpp)
    double far_depth = 1.0;                // and the end of rays that hit nothing
    std::vector<glm::dvec3> to_see{};      // what is to be seen from beside, until it is known from where
    int waits = 0;                         // so many redraws for what is drawn over the picture to have its size
    std::optional<PinnedPixel> pointed{};  // the eye's pixel under the pointer
    MadeBeside<AskedRays, std::vector<TracedRay>> rays{};
    MadeBeside<AskedPicture, Image> picture{};
};

// Shows the rays of the view. The view is to be moved by fly_beside().
void show_rays(ViewerState& state);
// Flies to where the eye and what it sees are seen from beside, if that is still to be done; `covered`: as for camera_beside().
void fly_beside(ViewerState& state, const glm::dvec2& covered);
// Ends that, and flies back.
void end_rays(ViewerState& state);

// Brings what is made beside the loop up to date with the document, the settings and the pixel. What is quickly made is there when
// it returns.
void follow_rays(ViewerState& state);
// Whether something that was being made has come.
bool take_rays(ViewerState& state);
bool makes_rays(const ViewerState& state);

// The eye's pixel that is at a place of the window's picture, which shows that sphere there, or visible_background: of the screen,
// or the one whose ray leads to the point of the sphere, whichever is in front. `on_screen`: of the screen alone, where nothing
// hides it.
std::optional<PinnedPixel> eye_pixel_at(const ViewerState& state, const glm::dvec2& place, std::int32_t visible,
                                        bool on_screen = false);

// What the panel shows of them; `first`: what is inspected.
RaysFacts facts_of_rays(const ViewerState& state, const std::optional<InspectedPixel>& first);

}  // namespace sphereview
