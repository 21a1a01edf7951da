// The pixels that the inspector holds, and their words.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>

#include "panels/inspector.hpp"

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
};

// `beside`: as the second, if there is a first.
void pin(PinnedPixels& pins, const PinnedPixel& pixel, bool beside);

// Lets go of what was asked for last: the question for a second, the second, the first. Returns whether there was anything.
bool let_go(PinnedPixels& pins);

// Where a picture of another size shows the pixel's ray, in pixels from its top left corner.
glm::dvec2 place_in(PictureSize size, const PinnedPixel& pixel);

// Brings what the inspector shows up to date: of the pinned pixels, else of the one under the pointer, as the picture's last
// update() saw them, or the eye whose rays are shown. `moves`: the view or a sphere does, and what takes time waits. Returns how
// many explanations were made anew.
std::size_t inspect(ViewerState& state, const LivePicture& picture, const std::optional<PinnedPixel>& under_pointer, bool moves,
                    Inspection& inspection);

// Does what the inspector asks for; a copy goes on beside the loop (state.copying).
void grant(ViewerState& state, InspectorWish wish);

}  // namespace sphereview
