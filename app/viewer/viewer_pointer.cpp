// The pointer in the viewer's picture: what is under it, and what the mouse does there.
#include <imgui.h>

#include <algorithm>

#include "viewer/box_selection.hpp"
#include "viewer/ray_drawing.hpp"
#include "viewer/scene_properties.hpp"
#include "viewer/viewer.hpp"

namespace sphereview {

std::optional<Pixel> Viewer::pixel_under_pointer() const {
    const ImVec2 at = ImGui::GetIO().MousePos;
    const double x = (static_cast<double>(at.x) - static_cast<double>(area_.x)) * pixels_;
    const double y = (static_cast<double>(at.y) - static_cast<double>(area_.y)) * pixels_;
    if (!(x >= 0.0 && y >= 0.0 && x < state_.picture_size.width && y < state_.picture_size.height)) return std::nullopt;
    return Pixel{static_cast<int>(x), static_cast<int>(y)};
}

void Viewer::use_mouse(const PanelContext& context, bool cancelled) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto pixel = pixel_under_pointer();
    pointer_in_picture_ = pixel && !io.WantCaptureMouse && state_.dialogs.empty();
    PictureMouse mouse;
    mouse.place = {(static_cast<double>(io.MousePos.x) - static_cast<double>(area_.x)) * pixels_,
                   (static_cast<double>(io.MousePos.y) - static_cast<double>(area_.y)) * pixels_};
    mouse.corner = {static_cast<double>(area_.x) * pixels_, static_cast<double>(area_.y) * pixels_};
    mouse.available = pointer_in_picture_;
    for (int button = 0; button < 3; ++button) {
        mouse.pressed[static_cast<std::size_t>(button)] = ImGui::IsMouseClicked(button);
        mouse.released[static_cast<std::size_t>(button)] = !io.MouseDown[button];
    }
    mouse.double_clicked = ImGui::IsMouseDoubleClicked(0);
    mouse.wheel = static_cast<double>(io.MouseWheel);
    mouse.control = io.KeyCtrl;
    mouse.shift = io.KeyShift;
    mouse.cancelled = cancelled;
    mouse.drag_threshold = 4.0 * static_cast<double>(imgui_.scale()) * pixels_;

    const auto pick = [this](glm::dvec2 place) {
        const Pixel at{std::clamp(static_cast<int>(place.x), 0, state_.picture_size.width - 1),
                       std::clamp(static_cast<int>(place.y), 0, state_.picture_size.height - 1)};
        return picture_.pick(state_.document, at);
    };
    const PictureState picture{
        state_.scene(),
        state_.selection,
        state_.camera,
        state_.picture_size,
        state_.pivot,
        pick,
        [this](Pixel low, Pixel high, bool toggles) {
            select_seen(state_, {low.x, low.y, high.x - low.x + 1, high.y - low.y + 1}, toggles);
        },
        state_.bounds,
        state_.settings.trackball,
        state_.measuring.on,
        middle_of_rays(state_),
        [&](glm::dvec2 place) { return state_.rays.on && eye_pixel_at(state_, place, pick(place), true).has_value(); }};
    const PictureConsequences done = mouse_.redraw(mouse, picture, state_.gesture, context.actions);
    if (done.camera && *done.camera != state_.camera) state_.camera = *done.camera;
    if (done.pivot) state_.pivot = *done.pivot;
    // A click that measures is not one that pins, too.
    if (done.clicked && state_.has_pins() && !state_.measuring.on) pin_clicked(*done.clicked, mouse.shift);
}

std::optional<PinnedPixel> Viewer::pointed_pixel(const std::optional<Pixel>& pixel,
                                                 const std::optional<std::uint32_t>& sphere) const {
    if (state_.rays.on && state_.rays.pointed) return state_.rays.pointed;
    if (!pixel) return std::nullopt;
    if (!state_.rays.on) return PinnedPixel{*pixel, state_.picture_size};
    if (state_.flight || mouse_.is_dragging()) return std::nullopt;
    return eye_pixel_at(state_, {pixel->x + 0.5, pixel->y + 0.5}, sphere ? static_cast<std::int32_t>(*sphere) : visible_background);
}

void Viewer::pin_clicked(const glm::dvec2& place, bool beside) {
    const Pixel pixel{static_cast<int>(place.x), static_cast<int>(place.y)};
    const std::optional<PinnedPixel> meant = state_.rays.on ? eye_pixel_at(state_, place, picture_.pick(state_.document, pixel))
                                                            : PinnedPixel{pixel, state_.picture_size};
    if (meant) pin(state_.pins, *meant, beside);
}

void Viewer::note_facts() {
    const std::optional<Pixel> pixel = pointer_in_picture_ ? pixel_under_pointer() : std::nullopt;
    std::optional<std::uint32_t> sphere;
    // While the view moves nothing is looked for under the pointer: in a coarse picture of a million spheres that takes as long as
    // a fifth of a redraw.
    if (mouse_.moves_camera()) {
        state_.hovered.reset();
    } else if (pixel) {
        const std::int32_t picked = picture_.pick(state_.document, *pixel);
        if (picked >= 0) sphere = static_cast<std::uint32_t>(picked);
        if (state_.hovered != sphere) pacing_.touch();
        state_.hovered = sphere;
    }
    facts_.status = {facts_.status.renderer, picture_.last_seconds(), picture_.step(), pixel, state_.picture_size, sphere,
                     told_properties(state_)};
    // A text field stays active when nothing moves; what is dragged in a panel has the button down.
    const bool drags = mouse_.is_dragging() || (ImGui::IsAnyItemActive() && ImGui::IsMouseDown(0));
    const std::size_t explained =
        inspect(state_, picture_, pointed_pixel(pixel, sphere), drags || state_.flight, facts_.inspection);
    explanations_ += explained;
    if (explained > 0) pacing_.touch();  // the panels of this redraw are drawn already
}

}  // namespace sphereview
