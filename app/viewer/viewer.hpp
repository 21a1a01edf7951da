// The window's loop: input, panels, edits, picture; it sleeps when there is nothing to do.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/file_watcher.hpp"
#include "gpu/live_picture.hpp"
#include "panels/status.hpp"
#include "viewer/event_routing.hpp"
#include "viewer/imgui_bridge.hpp"
#include "viewer/input_queue.hpp"
#include "viewer/layout.hpp"
#include "viewer/mouse_control.hpp"
#include "viewer/pacing.hpp"
#include "viewer/redraw_log.hpp"
#include "viewer/rest_view.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

class Viewer {
public:
    // The window's context must be current.
    Viewer(ViewerState& state, Window& window);

    // Runs until the person quits, or interrupted() is true after a wake(). Throws RenderError when the window's context is lost.
    void run(const std::function<bool()>& interrupted);

private:
    bool plays() const;      // a film
    bool autosaves() const;  // whether unsaved edits are to be kept now
    // Writes the settings when another file was opened, so that other windows offer the file, and a kill does not lose it.
    void keep_recent_files();
    void wait_for_work();
    // Whether to draw nothing before the next frame of a film.
    bool is_between_frames() const;
    void redraw();
    // Brings the picture up to date, as LivePicture::update(). Returns whether it has changed.
    bool update_picture(int step, double patience);
    // Draws a part of a finer picture while nothing moves. Returns whether the picture is complete.
    bool refine_picture();
    void use_mouse(const PanelContext& context, bool cancelled);
    void show(const Rectangle& area);
    // Gives a panel that asked the spheres that the picture shows.
    void give_seen();
    void note_facts();
    void end_announcement();
    void follow_work();
    void follow_frames();
    std::optional<Pixel> pixel_under_pointer() const;
    // The pixel that the inspector follows: the one under the pointer, or the eye's while its rays are shown. `sphere`: the one
    // under the pointer.
    std::optional<PinnedPixel> pointed_pixel(const std::optional<Pixel>& pixel, const std::optional<std::uint32_t>& sphere) const;
    // Pins the pixel that a click in the picture means.
    void pin_clicked(const glm::dvec2& place, bool beside);
    void draw_rays_in_space();

    ViewerState& state_;
    Window& window_;
    ImguiBridge imgui_;
    LivePicture picture_;
    FileWatcher files_;
    RedrawLog log_;
    InputQueue input_;
    MouseControl mouse_;
    Pacing pacing_;
    EventRouting routing_{state_, mouse_, pacing_};
    PictureTexture difference_;
    PictureTexture seen_by_eye_;
    RestView rest_;
    LostHint lost_hint_;
    bool shaders_changed_ = false;  // read them once the edits are kept
    std::shared_ptr<const BackgroundJob> edits_kept_{};
    std::vector<std::string> kept_recent_;          // the recent files that were written last
    std::optional<BackgroundJob> settings_kept_{};  // a job: a disk may hang

    Clock::time_point last_redraw_ = Clock::now();
    std::uint64_t redraw_number_ = 0;
    std::uint64_t explanations_ = 0;  // made for the inspector
    Rectangle area_;                  // of the picture, in screen coordinates
    double pixels_ = 1.0;             // a screen coordinate's
    bool pointer_in_picture_ = false;
    RedrawFacts facts_;
    WidgetRectangles widgets_;
    Clock::time_point work_shown_;
    static constexpr auto work_shown_every = std::chrono::milliseconds(100);
    bool in_hand_ = false;  // something is dragged or typed
    Clock::time_point film_shown_;
    static constexpr double film_shown_every = 0.1;  // seconds
};

}  // namespace sphereview
