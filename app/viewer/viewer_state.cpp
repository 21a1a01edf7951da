#include "viewer/viewer_state.hpp"

#include <algorithm>
#include <cstdint>

#include "base/path.hpp"

namespace sphereview {

namespace {

constexpr auto announcement_time = std::chrono::seconds(5);  // at least
constexpr auto time_to_read_a_letter = std::chrono::milliseconds(50);

}  // namespace

std::string ViewerState::name() const { return path.empty() ? "untitled" : text_from(path_from(path).filename()); }

Light ViewerState::shown_light() const {
    LightOptions asked = light;
    if (!scene().light.sun && !asked.sun) asked.sun_strength.reset();  // another scene than the one that this was asked for
    return with_options(scene(), asked);
}

void choose_size(ViewerState& state, int ViewerSettings::*width, int ViewerSettings::*height, PictureSize size) {
    if (PictureSize{state.settings.*width, state.settings.*height} == size) return;
    choose(state, width, size.width);
    choose(state, height, size.height);
}

ViewerSettings settings_to_keep(const ViewerState& state) {
    ViewerSettings kept = state.settings;
    const ViewerSettings& remembered = state.remembered;
    kept.shading = remembered.shading;
    kept.samples = remembered.samples;
    kept.export_width = remembered.export_width;
    kept.export_height = remembered.export_height;
    kept.film_width = remembered.film_width;
    kept.film_height = remembered.film_height;
    return kept;
}

void announce(ViewerState& state, const std::string& text) {
    state.messages.announcement = text;
    state.announcement_ends =
        Clock::now() + std::max<Clock::duration>(announcement_time, static_cast<std::int64_t>(text.size()) * time_to_read_a_letter);
}

void report_error(ViewerState& state, const std::string& title, const std::string& text) {
    state.dialogs.push_back(Question{.id = "error", .title = title, .text = text, .answers = {"OK"}, .answer = [](int) {}});
}

void go_home(ViewerState& state) {
    state.camera = state.scene().camera;
    update_bounds(state);
    state.pivot = state.bounds.middle();
}

void fly_to_fit(ViewerState& state, const ViewAxes& axes) {
    const std::optional<Camera> camera = fitted(state.scene(), with_hand_of(axes_of(state.camera), axes), state.camera.projection);
    if (camera) fly_to(state, *camera);
}

void fly_to(ViewerState& state, const Camera& camera) {
    update_bounds(state);
    state.pivot = state.bounds.middle();
    state.flight.emplace(state.camera, camera, state.pivot);
}

bool fly_on(ViewerState& state, Clock::time_point now) {
    if (!state.flight) return false;
    if (state.camera != state.flight->last()) {
        state.flight.reset();
        return false;
    }
    state.camera = state.flight->advance(now);
    if (state.flight->has_arrived()) state.flight.reset();
    return true;
}

void update_bounds(ViewerState& state) {
    if (state.bounds_revision == state.document.revision()) return;
    state.bounds_revision = state.document.revision();
    state.bounds = bounds_of(state.scene());
}

}  // namespace sphereview
