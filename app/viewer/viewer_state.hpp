// Everything the viewer knows, without its window: what panels read and actions change.
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
    // Of shading, samples and the sizes of exports and films: what the next run begins with. The command line's options say what
    // this run has in `settings`; they are not what the person chose in a window.
    ViewerSettings remembered;

    // The loop's thread holds this while the document, its file or the autosave may change, so that another thread can keep the
    // edits when the loop hangs elsewhere, in a driver.
    std::timed_mutex changing;

    Document document;
    Selection selection;
    std::optional<std::uint32_t> hovered;
    std::uint64_t gesture = 0;
    // The names of steps that gave spheres colours or sizes by a property: nearly all spheres. Undoing one selects none of them.
    std::set<std::string> look_steps{};
    SceneBounds bounds;  // of the document at bounds_revision
    std::uint64_t bounds_revision = 0;

    // The file that the document is of.
    std::string path;  // absolute; "" when it has none yet
    SceneFormat format = SceneFormat::toml;
    std::int64_t frame = 0;   // of the file, which may have several
    std::int64_t frames = 1;  // as far as they are known (FramePlayer::all_frames)
    FramePlayer player;
    FileStates stamp;                         // as it was looked at last
    FileStates read_stamp;                    // as it was when the document was read of it, or written
    std::vector<std::string> property_names;  // of what the file holds of each sphere, whether read or not
    bool all_properties = false;              // they are read, whatever they take
    std::uint64_t file_order = 0;             // the document's order_revision() in which its numbers are the file's
    // While the file is gone: the document's revision then, if that was what the file held; else 0.
    std::optional<std::uint64_t> gone_at;
    std::optional<Work> loading;
    std::optional<Work> saving;
    std::optional<Work> exporting;
    std::optional<Work> filming;
    std::optional<FilmChoices> film_choices;  // the latest
    std::optional<Work> comparing;
    std::optional<Work> copying;                // what explains a pixel, to the clipboard
    std::optional<ShownComparison> comparison;  // the latest
    Autosave autosave;

    // The view: what the window shows, which need not be the scene's own camera.
    Camera camera;
    glm::dvec3 pivot{0.0};
    std::optional<CameraFlight> flight;  // where the view moves by itself
    AxesInHand axes_in_hand;
    CornerMarks marks_in_corners{};        // as they were drawn last
    PictureSize picture_size;              // of the window's picture, in pixels
    std::optional<Background> background;  // instead of the scene's, as --background asks
    LightOptions light;                    // instead of the scene's, as --sun and its like ask
    SceneSnapshot snapshot;
    std::optional<RestPicture> rest_picture;  // of that, being made or there
    std::shared_ptr<KeptLights> kept_lights;  // of that, or null
    std::optional<Work> selecting;            // by a box

    // The system's; without a window there is none.
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
    bool panel_drawn = true;  // in the last redraw: a small window has no room for it
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
    // Of the pixels that are inspected: the view, or, while its rays are seen from beside, the eye's.
    const Camera& inspected_camera() const { return rays.on ? rays.camera : camera; }
    bool has_pins() const { return inspector_shown || rays.on; }
    // The scene's light with what the command line says instead.
    Light shown_light() const;
    // Whether there is nothing to show and nothing to take back: the window offers where to begin.
    bool is_at_start() const {
        return path.empty() && !loading && scene().spheres.empty() && !document.can_undo() && !document.can_redo();
    }
    // How the window's title and questions call the scene: the file's name, or "untitled".
    std::string name() const;
};

// What a person chose in the window: it holds, and is remembered.
template <typename T>
void choose(ViewerState& state, T ViewerSettings::*setting, const T& value) {
    state.settings.*setting = state.remembered.*setting = value;
}
// Likewise the size in a dialog, if it is another than the dialog offered.
void choose_size(ViewerState& state, int ViewerSettings::*width, int ViewerSettings::*height, PictureSize size);

// What the next run is to begin with.
ViewerSettings settings_to_keep(const ViewerState& state);

// Shows a line over the picture for some seconds.
void announce(ViewerState& state, const std::string& text);

// Shows an error that has to be read before anything else.
void report_error(ViewerState& state, const std::string& title, const std::string& text);

// The view becomes the scene's own camera.
void go_home(ViewerState& state);

// Begins to move the view to where it sees everything that way; not if there is nothing to see.
void fly_to_fit(ViewerState& state, const ViewAxes& axes);

// Begins to move the view to that camera.
void fly_to(ViewerState& state, const Camera& camera);

// Moves the view on, and ends the flight if it has arrived or something else has moved the view. Returns whether it moved.
bool fly_on(ViewerState& state, Clock::time_point now);

// Brings bounds up to date; they are left as they are while something is dragged, so that what a drag is scaled by does not
// change under the pointer.
void update_bounds(ViewerState& state);

}  // namespace sphereview
