// The picture that the window shows when nothing moves: the one that `render` writes, or a draft of it.
#pragma once

#include <memory>
#include <optional>

#include "gpu/live_picture.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

class RestView {
public:
    enum class News { none, draft, end };
    // What has become of the picture since the last call.
    News look(const ViewerState& state);

    // Call at the beginning of a redraw: forgets the picture if the window shows something else now. A picture that ends later is
    // left to the next redraw.
    void settle(ViewerState& state);
    // Whether settle() left a finished picture, which the redraw shows.
    bool is_exact() const { return exact_; }
    // Uploads the best draft or the picture. Returns whether it replaces the traced picture.
    bool upload(const ViewerState& state, LivePicture& picture);
    // Call at the end of a redraw. `rests`: nothing else is to be drawn, so a missing picture is begun.
    void end_redraw(ViewerState& state, const LivePicture& picture, bool rests);

    // Whether the picture is being made.
    bool works() const { return works_; }
    // Seconds from the picture's beginning to its shown draft; nothing while none is shown.
    std::optional<double> draft_seconds(const ViewerState& state) const;

private:
    std::shared_ptr<const Image> uploaded_;   // the image in the window's context
    std::shared_ptr<const Image> previewed_;  // the latest draft that a redraw was asked for
    bool exact_ = false;
    bool kept_ = false;   // the picture of the redraw's beginning stayed
    bool ended_ = false;  // its job had ended then
    bool works_ = false;
};

// A hint when the scene is out of sight.
class LostHint {
public:
    // Removes the hint when the view or the scene changes. At rest shows it if the picture shows no sphere of a scene that has
    // some. Returns whether the hint has appeared.
    bool update(ViewerState& state, const LivePicture& picture, bool rests);

private:
    std::uint64_t revision_ = 0;  // of the document, when the picture was looked at
    Camera camera_;
};

}  // namespace sphereview
