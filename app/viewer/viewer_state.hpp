// The viewer's state without its window. Panels read it, actions change it.
#pragma once

#include <chrono>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "base/file_watcher.hpp"
#include "camera/fit.hpp"
#include "panels/dialogs.hpp"
#include "panels/inspector.hpp"
#include "panels/measuring.hpp"
#include "panels/menus.hpp"
#include "panels/side_panel.hpp"
#include "panels/start_page.hpp"
#include "panels/status.hpp"
#include "viewer/camera_flight.hpp"
#include "viewer/frame_player.hpp"
#include "viewer/picture_comparison.hpp"
#include "viewer/picture_job.hpp"
#include "viewer/pinned_pixels.hpp"
#include "viewer/rays_in_space.hpp"
#include "viewer/recovery.hpp"
#include "viewer/scene_work.hpp"
#include "viewer/settings.hpp"
#include "viewer/view_marks.hpp"

namespace sphereview {

using Clock = std::chrono::steady_clock;

// Not movable: dialog callbacks hold references to it.
struct ViewerState {
    explicit ViewerState(ViewOptions viewer_options, ViewerSettings viewer_settings)
        : options(std::move(viewer_options)), settings(std::move(viewer_settings)), remembered(settings) {}
    ViewerState(const ViewerState&) = delete;
    ViewerState& operator=(const ViewerState&) = delete;

    ViewOptions options;
    ViewerSettings settings;
    // Shading, samples and sizes of exports and films that the next run begins with. `settings` has this run's, which options of
    // the command line may set.
    ViewerSettings remembered;

    // The loop's thread holds this while the document, its file or the autosave may change. So another thread can keep the edits
    // when the loop hangs elsewhere, in a driver.
    std::timed_mutex changing;

    Document document;
    Selection selection;
    std::optional<std::uint32_t> hovered;
    std::uint64_t gesture = 0;
    // The names of steps that gave nearly all spheres colours or sizes by a property. Undoing such a step selects no sphere.
    std::set<std::string> look_steps{};
    SceneBounds bounds;  // of the document at bounds_revision
    std::uint64_t bounds_revision = 0;

    // The document's file.
    std::string path;  // absolute; "" when it has none yet
    SceneFormat format = SceneFormat::toml;
    std::int64_t frame = 0;   // the document's frame of the file
    std::int64_t frames = 1;  // of the file, as far as known (FramePlayer::all_frames)
    FramePlayer player;
    FileStates stamp;                         // the file's at the last look
    FileStates read_stamp;                    // the file's when the document was read or written
    std::vector<std::string> property_names;  // of the file, whether read or not
    bool all_properties = false;              // read even with a large scene
    std::uint64_t file_order = 0;             // order_revision() at which the numbers are the file's
    // While the file is gone: the document's revision if it equalled the file, else 0.
    std::optional<std::uint64_t> gone_at;
    std::optional<Work> loading;
    std::optional<Work> saving;
    std::optional<Work> exporting;
    std::optional<Work> filming;
    std::optional<FilmChoices> film_choices;  // the latest
    std::optional<Work> comparing;
    std::optional<Work> copying;                // a pixel's explanation, to the clipboard
    std::optional<ShownComparison> comparison;  // the latest
    Autosave autosave;

    // The view; need not be the scene's camera.
    Camera camera;
    glm::dvec3 pivot{0.0};
    std::optional<CameraFlight> flight;  // while the view moves by itself
    AxesInHand axes_in_hand;
    CornerMarks marks_in_corners{};        // as drawn last
    PictureSize picture_size;              // of the window's picture, in pixels
    std::optional<Background> background;  // --background, instead of the scene's
    LightOptions light;                    // --sun and its like, instead of the scene's
    SceneSnapshot snapshot;
    std::optional<RestPicture> rest_picture;  // of `snapshot`, being made or complete
    std::shared_ptr<KeptLights> kept_lights;  // of rest_picture, or null
    std::optional<Work> selecting;            // by a box

    // The system's clipboard; empty without a window.
    struct Clipboard {
        std::function<std::string()> text = [] { return std::string(); };
        std::function<void(const std::string&)> set_text = [](const std::string&) {};
    };
    Clipboard clipboard{};

    Messages messages;
    std::optional<Clock::time_point> announcement_ends;
    Dialogs dialogs;

    MenuKeys menu_keys;
    bool panel_shown = true;
    bool panel_drawn = true;  // in the last redraw; a small window has no room
    bool inspector_shown = false;
    PinnedPixels pins;
    InspectorState inspector;
    RaysInSpace rays;
    bool export_area_shown = true;
    bool help_shown = false;
    Measuring measuring{};
    About about{};
    SidePanelState side_panel;
    StartPage start_page{example_scenes()};
    bool quits = false;

    const Scene& scene() const { return document.scene(); }
    Background shown_background() const { return background.value_or(scene().background); }
    // The inspected pixels' camera: the view's, or the eye's while its rays are seen from beside.
    const Camera& inspected_camera() const { return rays.on ? rays.camera : camera; }
    bool has_pins() const { return inspector_shown || rays.on; }
    // The scene's light with the command line's options.
    Light shown_light() const;
    // Whether nothing is open, shown or undoable: the window shows the start page.
    bool is_at_start() const {
        return path.empty() && !loading && scene().spheres.empty() && !document.can_undo() && !document.can_redo();
    }
    // The scene in the title and in questions: the file's name, or "untitled".
    std::string name() const;
};

// Sets a setting that the person chose in the window, now and for later runs.
template <typename T>
void choose(ViewerState& state, T ViewerSettings::*setting, const T& value) {
    state.settings.*setting = state.remembered.*setting = value;
}
// Likewise a dialog's size, if it differs from the offered one.
void choose_size(ViewerState& state, int ViewerSettings::*width, int ViewerSettings::*height, PictureSize size);

// The settings for the next run.
ViewerSettings settings_to_keep(const ViewerState& state);

// Shows a line over the picture for some seconds.
void announce(ViewerState& state, const std::string& text);

// Shows an error in a dialog.
void report_error(ViewerState& state, const std::string& title, const std::string& text);

// The view becomes the scene's own camera.
void go_home(ViewerState& state);

// Begins to move the view to see everything in that direction; does nothing if there is nothing to see.
void fly_to_fit(ViewerState& state, const ViewAxes& axes);

// Begins to move the view to that camera.
void fly_to(ViewerState& state, const Camera& camera);

// Moves the view on. Ends the flight on arrival, or if something else has moved the view. Returns whether the view moved.
bool fly_on(ViewerState& state, Clock::time_point now);

// Updates the bounds, but not during a drag, whose speed depends on them.
void update_bounds(ViewerState& state);

}  // namespace sphereview
