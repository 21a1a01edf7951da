// The pixels that the inspector holds, and their words.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>

#include "panels/inspector.hpp"
#include "viewer/made_beside.hpp"

namespace sphereview {

class LivePicture;
struct ViewerState;

// A pixel of a picture of that size. So its ray stays the same when the window's picture gets another size.
struct PinnedPixel {
    Pixel pixel;
    PictureSize size;

    bool operator==(const PinnedPixel&) const = default;
};

struct PinnedPixels {
    std::optional<PinnedPixel> first{};
    std::optional<PinnedPixel> second{};  // only beside a first
    bool second_is_next = false;          // the next click pins the second
    std::optional<PinnedPixel> last{};    // what was under the pointer last, which is shown while nothing is pinned

    // The explanations that take long, of the first and of the second.
    using Explained = MadeBeside<InspectedPlace, InspectedPixel>;
    Explained explained_first{};
    Explained explained_second{};
};

// `beside`: as the second, if there is a first.
void pin(PinnedPixels& pins, const PinnedPixel& pixel, bool beside);

// Lets go of what was asked for last: the question for a second, the second, the first. Returns whether there was anything.
bool let_go(PinnedPixels& pins);

// Where a picture of another size shows the pixel's ray, in pixels from its top left corner.
glm::dvec2 place_in(PictureSize size, const PinnedPixel& pixel);

// Brings what the inspector shows up to date: of the pinned pixels, else of the one under the pointer, as the picture's last
// update() saw them, or the eye whose rays are shown. `moves`: the view or a sphere does, and what takes time waits. A pixel with
// hundreds of spheres on its ray is explained beside the loop: until that is there, what there was is shown. Returns how many
// explanations are new.
std::size_t inspect(ViewerState& state, const LivePicture& picture, const std::optional<PinnedPixel>& under_pointer, bool moves,
                    Inspection& inspection);

// Whether an explanation is being made beside the loop, and whether one of them has ended.
bool explains_beside(const ViewerState& state);
bool take_explained(ViewerState& state);

// Does what the inspector asks for; a copy goes on beside the loop (state.copying).
void grant(ViewerState& state, InspectorWish wish);

}  // namespace sphereview
