// The pixels that the inspector explains.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>

#include "panels/inspector.hpp"
#include "viewer/made_beside.hpp"

namespace sphereview {

class LivePicture;
struct ViewerState;

// A pixel of a picture of that size: its ray stays the same when the window's picture gets another size.
struct PinnedPixel {
    Pixel pixel;
    PictureSize size;

    bool operator==(const PinnedPixel&) const = default;
};

struct PinnedPixels {
    std::optional<PinnedPixel> first{};
    std::optional<PinnedPixel> second{};  // only beside a first
    bool second_is_next = false;          // the next click pins the second
    std::optional<PinnedPixel> last{};    // the last pixel under the pointer, shown while nothing is pinned

    // Slow explanations of the first and the second pixel.
    using Explained = MadeBeside<InspectedPlace, InspectedPixel>;
    Explained explained_first{};
    Explained explained_second{};
};

// `beside`: pins as the second, if there is a first.
void pin(PinnedPixels& pins, const PinnedPixel& pixel, bool beside);

// Takes back the last step: the question for a second, the second, the first. Returns whether there was one.
bool let_go(PinnedPixels& pins);

// The place of the pixel's ray in a picture of another size, in pixels from the top left corner.
glm::dvec2 place_in(PictureSize size, const PinnedPixel& pixel);

// Updates the inspection of the pinned pixels, or of the one under the pointer, as the picture's last update() or the eye of the
// shown rays saw them. `moves`: the view or a sphere moves, so slow work waits. A pixel with hundreds of spheres on its ray is
// explained beside the loop; the former explanation stays meanwhile. Returns the number of new explanations.
std::size_t inspect(ViewerState& state, const LivePicture& picture, const std::optional<PinnedPixel>& under_pointer, bool moves,
                    Inspection& inspection);

// Whether an explanation is being made beside the loop; takes an ended one and returns whether there was any.
bool explains_beside(const ViewerState& state);
bool take_explained(ViewerState& state);

// Carries out a wish of the inspector; copying goes on beside the loop (state.copying).
void grant(ViewerState& state, InspectorWish wish);

}  // namespace sphereview
