// Every command of the menus: what it is called, what it does, and when.
#include <algorithm>
#include <array>
#include <functional>

#include "edit/selection.hpp"
#include "viewer/film_export.hpp"
#include "viewer/frame_player.hpp"
#include "viewer/perform.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/scene_saving.hpp"
#include "viewer/selection_edits.hpp"

namespace sphereview {

namespace {

EditScene use_view_as_camera(const ViewerState& state) {
    return {ChangeCamera{state.inspected_camera()}, "Use of this view as the camera", 0};
}

void scale_text(ViewerState& state, double factor) {
    state.settings.text_scale = text_scale_range.nearest(state.settings.text_scale * factor);
}

void center_on_selection(ViewerState& state) {
    const auto primary = state.selection.primary();
    if (!primary) return;
    state.pivot = state.scene().spheres[*primary].center;
    state.camera = centered_on(state.camera, state.pivot);
}

void change_projection(ViewerState& state) {
    const double depth = depth_of(state.camera, state.pivot);
    const Projection other = state.camera.orthographic() ? Projection::perspective : Projection::orthographic;
    state.flight.reset();
    state.camera = with_projection(state.camera, other, depth > 0.0 ? depth : 1.0);
}

void save_view(ViewerState& state) {
    const std::vector<SavedView>& views = state.scene().views;
    const auto same = std::ranges::find(views, state.camera, &SavedView::camera);
    const auto view = static_cast<std::size_t>(same - views.begin());
    if (same == views.end()) {
        apply(state, saved_view_of(state.scene(), state.camera));
    } else {
        announce(state, "This view is saved already, as '" + shown_text(same->name) + "'.");
    }
    state.panel_shown = true;
    start_renaming_view(state.side_panel, state.scene(), view);
}

// Everything about a command.
struct Command {
    CommandInfo info;
    std::function<void(ViewerState&)> run;
    std::function<bool(const ViewerState&)> enabled{};  // whether it has something to do; none: always
    std::function<bool(const ViewerState&)> checked{};  // whether it stands for what is chosen now; none: never
};

// What a command does that edits the scene.
std::function<void(ViewerState&)> edits(EditScene (*edit)(const ViewerState&)) {
    return [edit](ViewerState& state) { apply(state, edit(state)); };
}

bool selects_any(const ViewerState& state) { return !state.selection.empty(); }

// A command that fits everything, seen from an azimuth and an elevation.
Command side(const CommandInfo& info, double azimuth, double elevation) {
    return {info, [azimuth, elevation](ViewerState& s) { fly_to_fit(s, axes_from(azimuth, elevation)); }};
}

// A command that shows and hides something.
Command toggle(const CommandInfo& info, bool ViewerState::*shown) {
    return {info, [shown](ViewerState& s) { s.*shown = !(s.*shown); }, {}, [shown](const ViewerState& s) { return s.*shown; }};
}

// A command that switches a setting.
Command setting(const CommandInfo& info, bool ViewerSettings::*on) {
    return {info,
            [on](ViewerState& s) { s.settings.*on = !(s.settings.*on); },
            {},
            [on](const ViewerState& s) { return s.settings.*on; }};
}

// A command that chooses one of several values.
template <typename T>
Command choice(const CommandInfo& info, T ViewerSettings::*setting, T value) {
    return {info,
            [setting, value](ViewerState& s) { choose(s, setting, value); },
            {},
            [setting, value](const ViewerState& s) { return s.settings.*setting == value; }};
}

Command shade(std::size_t mode) {
    constexpr std::array<std::string_view, 9> keys = {"Ctrl+1", "Ctrl+2", "Ctrl+3", "Ctrl+4", "Ctrl+5",
                                                      "Ctrl+6", "Ctrl+7", "Ctrl+8", "Ctrl+9"};
    const auto id = static_cast<CommandId>(static_cast<std::size_t>(CommandId::first_shading) + mode);
    const ShadingMode& words = shading_modes.at(mode);
    return choice({id, "View", words.title, keys.at(mode), words.help, false, "Shading"}, &ViewerSettings::shading,
                  static_cast<Shading>(mode));
}

// A command of the film, which needs a file of several frames.
Command of_frames(const CommandInfo& info, std::function<void(ViewerState&)> run,
                  std::function<bool(const ViewerState&)> enabled = has_several_frames,
                  std::function<bool(const ViewerState&)> checked = {}) {
    Command command{info, std::move(run), std::move(enabled), std::move(checked)};
    command.info.submenu = "Frames";
    return command;
}

// A command that shows another frame.
Command goes(const CommandInfo& info, std::int64_t (*frame)(const ViewerState&)) {
    return of_frames(
        info, [frame](ViewerState& s) { stop_at_frame(s, frame(s)); },
        [frame](const ViewerState& s) { return has_frame(s, frame(s)) && frame(s) != s.frame; });
}

Command repeats(const CommandInfo& info, Repeat repeat) {
    return of_frames(
        info,
        [repeat](ViewerState& s) {
            Repeat& chosen = s.player.choices.repeat;
            chosen = chosen == repeat ? Repeat::once : repeat;
        },
        has_several_frames, [repeat](const ViewerState& s) { return s.player.choices.repeat == repeat; });
}

Command changes_speed(const CommandInfo& info, int by) {
    return of_frames(
        info, [by](ViewerState& s) { s.player.choices.speed = next_speed(s.player.choices.speed, s.player.usual_step, by); },
        [by](const ViewerState& s) {
            const PlaySpeed& speed = s.player.choices.speed;
            return has_several_frames(s) && next_speed(speed, s.player.usual_step, by) != speed;
        });
}

// Where a frame is on its way, the next step goes on from that one.
std::int64_t latest_frame(const ViewerState& s) { return s.player.wanted ? s.player.wanted->frame : s.frame; }

// Behind the command that pins a pixel by the same key, where there is one to pin.
void add_frame_commands(std::vector<Command>& commands) {
    using Id = CommandId;
    const std::vector<Command> frames = {
        of_frames({Id::play, "View", "Play", "Space|K",
                   "Plays the frames of the file, or pauses. Where the pixel inspector or the rays have a pixel, Space pins it."},
                  play_or_pause, has_several_frames, [](const ViewerState& s) { return s.player.clock.plays(); }),
        goes({Id::next_frame, "View", "Next frame", "Page Down", "Shows the next frame of a file of several; the view stays."},
             [](const ViewerState& s) { return latest_frame(s) + 1; }),
        goes({Id::previous_frame, "View", "Previous frame", "Page Up", "Shows the frame before."},
             [](const ViewerState& s) { return latest_frame(s) - 1; }),
        goes({Id::first_frame, "View", "First frame", "Ctrl+Page Up", "Shows the first frame."},
             [](const ViewerState&) { return std::int64_t{0}; }),
        goes({Id::last_frame, "View", "Last frame", "Ctrl+Page Down", "Shows the last frame that is known."},
             [](const ViewerState& s) { return s.frames - 1; }),
        changes_speed({Id::play_faster, "View", "Faster", "]", "More frames a second."}, 1),
        changes_speed({Id::play_slower, "View", "Slower", "[", "Fewer frames a second."}, -1),
        repeats({Id::loop, "View", "Loop", "Shift+K", "Goes on with the first frame behind the last."}, Repeat::loop),
        repeats({Id::back_and_forth, "View", "Back and forth", "Ctrl+K",
                 "Plays backward from the last frame, and forward from the first."},
                Repeat::back_and_forth),
    };
    const auto place = std::ranges::find(commands, Id::toggle_export_area, [](const Command& command) { return command.info.id; });
    commands.insert(place, frames.begin(), frames.end());
}

std::vector<Command> make_commands() {
    using Id = CommandId;
    std::vector<Command> commands = {
        {{Id::file_new, "File", "New", "Ctrl+N", "Begins an empty scene."}, new_scene},
        {{Id::file_open, "File", "Open...", "Ctrl+O", "Opens a scene file."}, ask_for_scene},
        {{Id::file_save, "File", "Save", "Ctrl+S", "Writes the scene to its file.", true}, [](ViewerState& s) { save_scene(s); }},
        {{Id::file_save_as, "File", "Save as...", "Ctrl+Shift+S", "Writes the scene to another file."},
         [](ViewerState& s) { save_scene_as(s); }},
        {{Id::export_picture, "File", "Export picture...", "Ctrl+E", "Asks for a file and a size and writes the view as a PNG.",
          true},
         ask_for_export},
        {{Id::export_film, "File", "Export film...", "Shift+F12",
          "Asks for a file and writes a film of the frames, or around the scene: mp4, webm, gif, png, mkv, or pictures."},
         ask_for_film,
         [](const ViewerState& s) { return !s.filming && !s.is_at_start(); }},
        {{Id::export_now, "File", "Export now", "F12",
          "Writes the view as a PNG at once, under the next free name beside the scene."},
         export_now},
        {{Id::compare_picture, "File", "Compare with picture...", "Ctrl+Shift+E",
          "Says what is wrong in a picture that somebody's own ray tracer has made of this scene."},
         ask_for_comparison},
        {{Id::quit, "File", "Quit", "Ctrl+Q", "Closes the window.", true}, quit},
        {{Id::undo, "Edit", "Undo", "Ctrl+Z", "Takes the last change of the scene back."},
         undo,
         [](const ViewerState& s) { return s.document.can_undo(); }},
        {{Id::redo, "Edit", "Redo", "Ctrl+Shift+Z|Ctrl+Y", "Makes the change again that was taken back."},
         redo,
         [](const ViewerState& s) { return s.document.can_redo(); }},
        {{Id::cut, "Edit", "Cut", "Ctrl+X", "Copies the selected spheres, then deletes them.", true}, cut_selected, selects_any},
        {{Id::copy, "Edit", "Copy", "Ctrl+C", "Puts the selected spheres on the clipboard, as the text of a scene."},
         [](ViewerState& s) { copy_selected(s); },
         selects_any},
        {{Id::paste, "Edit", "Paste", "Ctrl+V", "Adds the spheres that the text on the clipboard describes."}, paste},
        {{Id::add_sphere, "Edit", "Add sphere", "Insert", "Adds a sphere in the middle of the view, beside what is there.", true},
         edits(add_sphere)},
        {{Id::duplicate, "Edit", "Duplicate", "Ctrl+D", "Adds copies of the selected spheres."},
         edits(duplicate_selected),
         selects_any},
        {{Id::remove, "Edit", "Delete", "Delete|Backspace", "Deletes the selected spheres."}, edits(remove_selected), selects_any},
        {{Id::rename, "Edit", "Rename", "F2", "Gives the selected sphere a name."},
         [](ViewerState& s) { start_renaming(s.side_panel, s.scene(), s.selection.numbers().front()); },
         [](const ViewerState& s) { return s.selection.size() == 1; }},
        {{Id::hide, "Edit", "Hide or show", "H", "Hides the selected spheres, or shows them again."},
         edits(hide_or_show_selected),
         selects_any},
        {{Id::select_all, "Edit", "Select all", "Ctrl+A", "Selects every sphere.", true},
         [](ViewerState& s) { s.selection.set_all(s.scene().spheres.size()); },
         [](const ViewerState& s) { return s.selection.size() < s.scene().spheres.size(); }},
        {{Id::select_none, "Edit", "Select none", "Ctrl+Shift+A|Escape", "Selects no sphere."},
         [](ViewerState& s) { s.selection.clear(); },
         selects_any},
        {{Id::invert_selection, "Edit", "Invert selection", "Ctrl+I", "Selects the spheres that are not selected, and no others."},
         [](ViewerState& s) { s.selection.invert(s.scene().spheres.size()); },
         [](const ViewerState& s) { return !s.scene().spheres.empty(); }},
        {{Id::select_same_color, "Edit", "Select same colour", "Ctrl+L", "Selects every sphere that has a selected one's colour."},
         [](ViewerState& s) { s.selection.set(colored_like(s.scene().spheres, s.selection.numbers())); },
         selects_any},
        {{Id::select_hidden, "Edit", "Select hidden", "Ctrl+H", "Selects every hidden sphere."},
         [](ViewerState& s) { s.selection.set(hidden_ones(s.scene().spheres)); }},
        {{Id::move_up, "Edit", "Move up", "Ctrl+Up",
          "Moves the selected sphere up in the list; of two equal hits the upper sphere is seen.", true},
         edits(move_up),
         [](const ViewerState& s) { return s.selection.size() == 1 && s.selection.numbers().front() > 0; }},
        {{Id::move_down, "Edit", "Move down", "Ctrl+Down", "Moves the selected sphere down in the list."},
         edits(move_down),
         [](const ViewerState& s) {
             return s.selection.size() == 1 && s.selection.numbers().front() + 1 < s.scene().spheres.size();
         }},
        {{Id::go_home, "View", "Go home", "Home", "Returns to the scene's own camera."}, go_home},
        {{Id::center_on_selection, "View", "Centre on selection", "C|.",
          "Brings the selected spheres to the middle of the picture."},
         center_on_selection,
         selects_any},
        {{Id::fit_all, "View", "Fit everything", "F",
          "Moves the view so that it sees everything, in the direction that it looks and with the usual field of view.", true},
         [](ViewerState& s) { fly_to_fit(s, axes_of(s.camera)); }},
        side({Id::view_front, "View", "From the front", "1", "Fits everything, seen along z."}, 0.0, 0.0),
        side({Id::view_back, "View", "From the back", "Shift+1", "Fits everything, seen against z."}, 180.0, 0.0),
        side({Id::view_right, "View", "From the right", "2", "Fits everything, seen against x."}, 90.0, 0.0),
        side({Id::view_left, "View", "From the left", "Shift+2", "Fits everything, seen along x."}, 270.0, 0.0),
        side({Id::view_top, "View", "From the top", "3", "Fits everything, seen from above."}, 0.0, 90.0),
        side({Id::view_bottom, "View", "From the bottom", "Shift+3", "Fits everything, seen from below."}, 0.0, -90.0),
        {{Id::view_iso, "View", "From a corner", "4", "Fits everything, seen isometrically: all three axes equally long."},
         [](ViewerState& s) { fly_to_fit(s, isometric_axes()); }},
        {{Id::orthographic, "View", "Orthographic", "O",
          "Parallel rays: how large a sphere looks does not depend on how far it is.", true},
         change_projection,
         {},
         [](const ViewerState& s) { return s.camera.orthographic(); }},
        setting({Id::trackball, "View", "Trackball", "T",
                 "Orbits as if a ball were turned: no upright, and the poles can be passed. Else the world's y stays upright."},
                &ViewerSettings::trackball),
        {{Id::use_view_as_camera, "View", "Use this view as the scene's camera", "Ctrl+Home",
          "An edit like any other: Home returns here then.", true},
         edits(use_view_as_camera),
         [](const ViewerState& s) { return s.camera != s.scene().camera; }},
        {{Id::save_view, "View", "Save this view", "V",
          "Keeps the view under a name, in the scene, to come back to it. A view that is saved already can be renamed."},
         save_view},
        toggle({Id::toggle_panel, "View", "Side panel", "Tab|F9", "Shows or hides the side panel.", true},
               &ViewerState::panel_shown),
        toggle({Id::toggle_inspector, "View", "Pixel inspector", "I", "Shows or hides the arithmetic of a pixel."},
               &ViewerState::inspector_shown),
        {{Id::pin_pixel, "View", "Pin the pixel", "Space", "Holds the pixel inspector at its pixel; again: lets the pixel go."},
         [](ViewerState& s) { grant(s, s.pins.first ? InspectorWish::unpin : InspectorWish::pin); },
         [](const ViewerState& s) { return s.has_pins() && (s.pins.first || s.pins.last); },
         [](const ViewerState& s) { return s.has_pins() && s.pins.first; }},
        {{Id::toggle_rays, "View", "Rays", "R",
          "Shows the view from beside: its eye, its screen with the picture on it, and its rays; Escape goes back."},
         [](ViewerState& s) { s.rays.on ? end_rays(s) : show_rays(s); },
         [](const ViewerState& s) { return s.rays.on || !s.is_at_start(); },
         [](const ViewerState& s) { return s.rays.on; }},
        {{Id::measure, "View", "Measure", "D",
          "Clicks on spheres give distances, and of three the angle, of four the dihedral; Escape ends it."},
         [](ViewerState& s) { s.measuring = Measuring{.on = !s.measuring.on}; },
         {},
         [](const ViewerState& s) { return s.measuring.on; }},
        toggle({Id::toggle_export_area, "View", "Area of the export", "M",
                "Marks what an export shows, where the window shows more or less."},
               &ViewerState::export_area_shown),
        setting({Id::toggle_axes, "View", "Axes", "A", "Shows in a corner where x, y and z point; click an end to look along it."},
                &ViewerSettings::axes_shown),
        setting({Id::toggle_scale_bar, "View", "Scale bar", "B",
                 "Shows how long a length of the scene is; in perspective as deep as the point that the view turns about."},
                &ViewerSettings::scale_bar_shown),
        setting({Id::toggle_legend, "View", "Legend", "L",
                 "Shows what the colours stand for, where they were chosen by a property of the file."},
                &ViewerSettings::legend_shown),
        setting({Id::toggle_exported_marks, "View", "Axes, scale bar and legend in exports", "Shift+A",
                 "Draws what is shown of the three into exports as well."},
                &ViewerSettings::marks_exported),
        choice({Id::no_anti_aliasing, "View", "Anti-aliasing off", "Alt+1", "A pixel shows what is at its centre.", true},
               &ViewerSettings::samples, 1),
        choice({Id::anti_aliasing_4, "View", "4 samples a pixel", "Alt+4",
                "When nothing moves, and in exports, a pixel is the average of 4 points."},
               &ViewerSettings::samples, 4),
        choice({Id::anti_aliasing_16, "View", "16 samples a pixel", "Alt+6", "The average of 16 points."}, &ViewerSettings::samples,
               16),
        setting({Id::light_theme, "View", "Light theme", "Ctrl+T", "Dark text on light panels, instead of light on dark.", true},
                &ViewerSettings::light_theme),
        {{Id::larger_text, "View", "Larger text", "Ctrl++|Ctrl+=", "Makes text and panels larger."},
         [](ViewerState& s) { scale_text(s, 1.1); }},
        {{Id::smaller_text, "View", "Smaller text", "Ctrl+-", "Makes text and panels smaller."},
         [](ViewerState& s) { scale_text(s, 1.0 / 1.1); }},
        toggle({Id::help, "Help", "Keys and mouse", "F1|?", "Lists every shortcut and what the mouse does."},
               &ViewerState::help_shown),
        {{Id::about, "Help", "About", "Shift+F1", "The version, what renders, and the licences of the parts."},
         [](ViewerState& s) { s.about.shown = !s.about.shown; },
         {},
         [](const ViewerState& s) { return s.about.shown; }},
    };
    add_frame_commands(commands);
    auto place = std::ranges::find(commands, Id::toggle_panel, [](const Command& command) { return command.info.id; });
    for (std::size_t mode = 0; mode < shading_modes.size(); ++mode) place = commands.insert(place, shade(mode)) + 1;
    return commands;
}

const std::vector<Command>& all_commands() {
    static const std::vector<Command> commands = make_commands();
    return commands;
}

const Command& command_of(CommandId id) {
    return *std::ranges::find(all_commands(), id, [](const Command& command) { return command.info.id; });
}

bool is_enabled(const ViewerState& state, const Command& command) { return !command.enabled || command.enabled(state); }

bool is_checked(const ViewerState& state, const Command& command) { return command.checked && command.checked(state); }

}  // namespace

std::vector<CommandInfo> commands_of(const ViewerState& state) {
    std::vector<CommandInfo> infos;
    for (const Command& command : all_commands()) {
        infos.push_back(command.info);
        infos.back().enabled = is_enabled(state, command);
        infos.back().checked = is_checked(state, command);
    }
    return infos;
}

void run_command(ViewerState& state, CommandId id) {
    if (const Command& command = command_of(id); is_enabled(state, command)) command.run(state);
}

}  // namespace sphereview
