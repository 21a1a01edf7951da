// View > Rays: the scene seen from beside, with an eye, its screen and its rays drawn over the picture. This is no edit: nothing of
// it is saved or undone. The picture from beside is made as any other; the eye is the former view.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "app/render_picture.hpp"
#include "base/background_job.hpp"
#include "panels/rays_panel.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"
#include "viewer/made_beside.hpp"
#include "viewer/pinned_pixels.hpp"

namespace sphereview {

// The most rays that are drawn at once: more could not be told apart, nor drawn quickly.
inline constexpr std::size_t most_rays = 4000;

// The pixels whose rays are drawn: those that stand for the squares of a coarse picture (tiles/pixel_range.hpp), or those of the
// given row. None for RaysShown::one.
std::vector<Pixel> pixels_of_rays(PictureSize size, const RayChoice& choice, int row);

// The least RayChoice::every() with at most most_rays rays, and the one for a good drawing.
int least_every(PictureSize size, RaysShown shown);
int usual_every(PictureSize size, RaysShown shown);

// A ray of a camera as a line in space.
struct TracedRay {
    Pixel pixel;
    std::int32_t visible = 0;  // the number of the sphere at its end, or visible_background
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0};
};

// Traces the rays of some pixels, on all cores. The first sphere of a ray is decided exactly; the hit is the exact point, rounded
// once. A ray that hits nothing ends at `far_depth`, as of depth_of().
std::vector<TracedRay> trace_rays(const Scene& scene, const Camera& camera, PictureSize size, std::span<const Pixel> pixels,
                                  double far_depth);

struct ViewerState;

// All that the drawn rays, and the eye's picture, depend on.
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
    RayChoice choice{RaysShown::one, 0, 0};  // 0: chosen by the picture

    // While they are shown:
    Camera camera{};                   // the eye's
    PictureSize size{};                // of the eye's picture
    double screen_depth = 1.0;         // depth of the drawn screen (camera/beside.hpp)
    double far_depth = 1.0;            // depth of the ends of rays that hit nothing
    std::vector<glm::dvec3> to_see{};  // points that the view from beside must see
    bool flies = false;                // flies to that view once it is known
    int waits = 0;                     // redraws until the panels over the picture have their size
    std::optional<Camera> beside{};    // that view, in a picture of this size
    PictureSize beside_size{};
    glm::dvec3 pivot{};                    // of the former view
    std::optional<PinnedPixel> pointed{};  // the eye's pixel under the pointer
    ImVec2 panel{};                        // its lower right end from the picture's upper left corner
    bool axes_beside = false;              // the axes are right of the panel, which reaches down to them
    MadeBeside<AskedRays, std::vector<TracedRay>> rays{};
    MadeBeside<AskedPicture, Image> picture{};
};

// Shows the rays of the view. fly_beside() moves the view.
void show_rays(ViewerState& state);
// Flies to a view of the eye and what it sees, if not done yet, or again when the picture got another size and nobody moved the
// view. `covered`: as for camera_beside().
void fly_beside(ViewerState& state, const glm::dvec2& covered);
// Hides the rays and flies back.
void end_rays(ViewerState& state);

// Brings the rays and the eye's picture up to date with the document, the settings and the pixel. Quick results are there on
// return, others come by take_rays().
void follow_rays(ViewerState& state);
// Takes finished results; returns whether there were any.
bool take_rays(ViewerState& state);
bool makes_rays(const ViewerState& state);

// The eye's pixel at a place of the window's picture: the drawn screen's, or the one whose ray leads to the seen point of the
// sphere `visible`, whichever is in front. `on_screen`: the screen's alone, where nothing hides it.
std::optional<PinnedPixel> eye_pixel_at(const ViewerState& state, const glm::dvec2& place, std::int32_t visible,
                                        bool on_screen = false);

// What the panel shows of the rays. `first`: the inspected pixel.
RaysFacts facts_of_rays(const ViewerState& state, const std::optional<InspectedPixel>& first);

}  // namespace sphereview
