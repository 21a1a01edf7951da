#include "viewer/rest_view.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace sphereview {

RestView::News RestView::look(const ViewerState& state) {
    if (!works_) return News::none;
    if (!state.rest_picture || state.rest_picture->job.ended()) {
        works_ = false;
        return News::end;
    }
    const std::shared_ptr<const Image> draft = state.rest_picture->preview->get();
    if (draft == previewed_) return News::none;
    previewed_ = draft;
    return draft ? News::draft : News::none;
}

void RestView::settle(ViewerState& state) {
    // Asked first: a picture that ends while it is looked at has not been shown yet.
    ended_ = state.rest_picture && state.rest_picture->job.ended();
    const auto begun = state.rest_picture ? std::optional(state.rest_picture->begun) : std::nullopt;
    exact_ = rest_picture_is_shown(state);
    kept_ = state.rest_picture && state.rest_picture->begun == begun;  // and not begun anew
}

bool RestView::upload(const ViewerState& state, LivePicture& picture) {
    // A draft is as right as the picture is: both are forgotten when something changes.
    if (!state.rest_picture) return false;
    const std::shared_ptr<const Image> image = exact_ ? state.rest_picture->image : state.rest_picture->draft();
    if (image && uploaded_ != image) {
        uploaded_ = image;
        picture.upload(*uploaded_);
    }
    return image != nullptr;
}

void RestView::end_redraw(ViewerState& state, const LivePicture& picture, bool rests) {
    if (rests) make_rest_picture(state, [&] { return picture.seen_numbers(); });
    works_ = state.rest_picture && !(kept_ && ended_);
}

std::optional<double> RestView::draft_seconds(const ViewerState& state) const {
    if (exact_ || !state.rest_picture || !uploaded_ || uploaded_ != previewed_) return std::nullopt;
    return std::chrono::duration<double>(Clock::now() - state.rest_picture->begun).count();
}

bool LostHint::update(ViewerState& state, const LivePicture& picture, bool rests) {
    if (revision_ == state.document.revision() && camera_ == state.camera) return false;
    state.messages.hint.clear();
    if (!rests) return false;
    revision_ = state.document.revision();
    camera_ = state.camera;
    const bool shows_any = state.scene().spheres.size() > state.bounds.hidden;
    const std::vector<std::int32_t> seen = shows_any ? picture.seen_numbers() : std::vector<std::int32_t>{};
    const auto is_background = [](std::int32_t number) { return number == visible_background; };
    if (seen.empty() || !std::ranges::all_of(seen, is_background)) return false;
    state.messages.hint = "Nothing of the scene is in view. F shows everything, Home returns to the scene's camera.";
    return true;
}

}  // namespace sphereview
