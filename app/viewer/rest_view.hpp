// What the window shows when nothing moves: the picture that `render` writes, or a draft on the way to it.
#pragma once

#include <memory>
#include <optional>

#include "gpu/live_picture.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

class RestView {
public:
    enum class News { none, draft, end };
    // What has come, since the last call, of the picture that is being made.
    News look(const ViewerState& state);

    // At the beginning of a redraw: forgets the picture if the window has come to show something else. What is finished from now on
    // is shown by the next redraw.
    void settle(ViewerState& state);
    // Whether what settle() left is finished: then it is what the redraw shows.
    bool is_exact() const { return exact_; }
    // Uploads the best there is. Returns whether that is instead of the traced picture.
    bool upload(const ViewerState& state, LivePicture& picture);
    // At the end of a redraw; `rests`: nothing else is to be drawn. Then the picture is begun, if it is not there.
    void end_redraw(ViewerState& state, const LivePicture& picture, bool rests);

    // Whether the picture is being made.
    bool works() const { return works_; }
    // When a draft has come to be shown, in seconds since its picture was begun; nothing while none is shown.
    std::optional<double> draft_seconds(const ViewerState& state) const;

private:
    std::shared_ptr<const Image> uploaded_;   // what the window's context holds
    std::shared_ptr<const Image> previewed_;  // the latest draft that a redraw was asked for
    bool exact_ = false;
    bool kept_ = false;   // there was a picture when the redraw began,
    bool ended_ = false;  // and its job had ended
    bool works_ = false;
};

// A hint for whoever has lost the scene out of sight.
class LostHint {
public:
    // Takes the hint away when the view or the scene is another; at rest, gives it where the picture shows nothing of a scene that
    // has something to show. Returns whether it has come.
    bool update(ViewerState& state, const LivePicture& picture, bool rests);

private:
    std::uint64_t revision_ = 0;  // of the document, when the picture was looked at
    Camera camera_;
};

}  // namespace sphereview
