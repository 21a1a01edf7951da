#include "viewer/scene_file.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/path.hpp"
#include "base/text.hpp"
#include "formats/scene_format.hpp"
#include "viewer/frame_player.hpp"
#include "viewer/scene_properties.hpp"
#include "viewer/scene_saving.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

// The background of data in the window: a dark grey-blue, on which dark atoms are visible, too.
constexpr Background quiet_background{{32, 36, 48}, false};

// What readers say ends with options of the command line; in a window it is done otherwise.
std::string in_terms_of_window(std::string line) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> ends = {
        {{"; --radius gives another", "; Ctrl+A and the radius of the panel Sphere give another"},
         {"; --color-by and --size-by can use them", "; the panel Colour and size can use them"},
         {", or not with --no-virtual", ""}}};
    for (const auto& [option, other] : ends) {
        if (line.ends_with(option)) line.replace(line.size() - option.size(), option.size(), other);
    }
    return line;
}

// What is to be said of a file that was read all the same, below `first`, if that is not "".
void announce_reading(ViewerState& state, const std::string& first, const LoadedScene& loaded) {
    std::vector<std::string> lines = {first};
    lines.insert(lines.end(), loaded.warnings.begin(), loaded.warnings.end());
    lines.insert(lines.end(), loaded.notes.begin(), loaded.notes.end());
    std::erase(lines, "");
    std::ranges::transform(lines, lines.begin(), in_terms_of_window);
    if (!lines.empty()) announce(state, joined(lines, "\n"));
}

void read_scene(ViewerState& state, const std::string& path) {
    // The stamp is of before the reading: what is written meanwhile shows as a change.
    const auto accept = unless_edited(state, [&state, path, stamp = file_states(path)](LoadedScene loaded) {
        adopt(state, std::move(loaded), path);
        state.stamp = state.read_stamp = stamp;
    });
    const auto fail = [&state, path](const std::string& why) {
        // A broken file can be repaired, and is then looked for where it was.
        if (std::error_code error; !fs::exists(path_from(path), error)) remove_recent(state.settings, path);
        report_error(state, "The scene cannot be opened", why);
        look_at_file(state);
    };
    start_loading(state, {path, load_options(state, path, 0), accept, fail, [&state] { look_at_file(state); }});
}

// The colours that the spheres have, in the same range, and the sizes that were chosen last, if they have them.
void keep_chosen_look(const ViewerState& state, LookOptions& options) {
    const LookPanelState& look = state.side_panel.look;
    if (look.shown && look.shown_revision == state.document.revision()) {
        options.color_by = look.shown->property;
        const bool by_category = look.shown->is_category();
        options.map = by_category ? std::nullopt : std::optional(look.shown->map);
        options.range =
            by_category || look.shown->range.low == look.shown->range.high ? std::nullopt : std::optional(look.shown->range);
        options.log = look.shown->log;
        options.order = by_category ? std::optional(look.shown->order) : std::nullopt;
    } else if (look.own.colors_chosen) {
        options.color_by.reset();
        options.map.reset();
        options.range.reset();
        options.log = false;
        options.order.reset();
    }
    Property own;
    const Property* sizes = look.size_by.empty() ? nullptr : find_values(state.scene(), look.size_by, own);
    if (sizes != nullptr && part_with_sizes(state.scene(), *sizes, look.scale) > 0.5) {
        options.size_by = look.size_by;
        options.scale = look.scale;
        options.radii.reset();
    } else if (const auto radii = chosen_radii(look); radii && look.has_sized) {
        options.size_by.reset();
        options.scale.reset();
        options.radii = radii;
    } else if (look.own.sizes_chosen) {
        options.size_by.reset();
        options.scale.reset();
        options.radii.reset();
        options.radius_scale.reset();
    }
}

// What the command line, or the window before another frame, has asked for.
void note_look(ViewerState& state, const LoadedScene& loaded) {
    LookPanelState& look = state.side_panel.look;
    look.own.order = state.document.order_revision();
    look.own.colors = loaded.look.own_colors;
    look.own.radii = loaded.look.own_radii;
    look.has_sized = !loaded.look.own_radii.empty();
    if (loaded.look.coloring) {
        look.colors = loaded.look.colored_by;
        look.colors.order.reset();  // a person's next choice has its own
        note_colors(look, {look.colors, *loaded.look.coloring});
    }
    if (loaded.look.sizing) {
        look.size_by = loaded.look.sized_by;
        look.scale = loaded.look.sizing->scale;
    }
}

// Where a file of the scene's would be looked for first.
std::string usual_folder(const ViewerState& state) {
    std::error_code error;
    if (!state.path.empty()) return text_from(path_from(state.path).parent_path());
    if (!state.settings.recent.empty()) {
        const fs::path folder = path_from(state.settings.recent.front()).parent_path();
        if (fs::is_directory(folder, error)) return text_from(folder);
    }
    return text_from(fs::current_path(error));
}

// The first is all of them, packed or not.
std::vector<FileKind> read_kinds() {
    std::vector<FileKind> kinds = kinds_of([](const SceneFormat&) { return true; });
    FileKind all{"All scenes", format_endings()};
    all.endings.emplace_back(".gz");
    kinds.insert(kinds.begin(), all);
    kinds.push_back({"All files", {}});
    return kinds;
}

void reload(ViewerState& state, LoadedScene loaded) {
    state.format = loaded.format;
    const bool differs = loaded.scene != state.scene();
    if (differs) note_edits_before_reload(state, loaded.scene);
    const PlayClock clock = state.player.clock;
    begin_frames(state, loaded);
    state.read_stamp = state.stamp;
    state.player.clock = clock;
    state.frame = std::min(state.frame, state.frames - 1);  // the file may have become shorter
    if (differs) {
        state.document.apply(ReplaceScene{std::move(loaded.scene)}, "Reload of " + in_quotes(state.name()));
        state.selection.keep_below(state.scene().spheres.size());
        state.hovered.reset();
        note_look(state, loaded);
        shown_coloring(state.document, state.side_panel.look);  // the next frame is read with it
        announce_reading(state, "Reloaded " + on_one_line(state.path), loaded);
    }
    note_properties(state, loaded);
    state.document.mark_saved();
}

// The scene is in the window alone now: closing asks about it, and a copy is kept.
void note_gone(ViewerState& state) {
    state.gone_at = state.document.is_changed() ? 0 : state.document.revision();
    state.document.mark_unsaved();
    std::error_code error;
    const bool replaced = fs::exists(path_from(state.path), error);
    state.messages.scene_gone =
        on_one_line(state.path) +
        (replaced ? ": not while something else than a regular file stands there; save under another name" : "");
}

void note_back(ViewerState& state) {
    if (!state.gone_at) return;
    if (*state.gone_at == state.document.revision()) state.document.mark_saved();
    state.gone_at.reset();
    state.messages.scene_gone.clear();
    announce(state, on_one_line(state.path) + " is there again");
}

void offer_reload(ViewerState& state, LoadedScene loaded) {
    state.messages.scene_error.clear();
    const bool shows_all = loaded.scene == state.scene() && !lacks_edited_spheres(state);
    if (!state.document.is_changed() || shows_all) return reload(state, std::move(loaded));
    ask(state, {.id = "reload",
                .title = "The file has changed on disk",
                .text = in_quotes(state.name()) + " was changed by another program, and has changes here that are not saved.\n" +
                        "(Undo brings yours back after a reload.)",
                .answers = {"Reload the file", "Keep mine"},
                .cancel = 1,
                .answer = [&state, loaded = std::make_shared<LoadedScene>(std::move(loaded))](int answer) {
                    if (answer == 0) reload(state, std::move(*loaded));
                    if (answer == 1) state.document.mark_unsaved();
                }});
}

}  // namespace

std::vector<FileKind> kinds_of(bool (*wanted)(const SceneFormat&)) {
    std::vector<FileKind> kinds;
    for (const SceneFormat& format : scene_formats()) {
        if (wanted(format)) kinds.push_back({std::string(format.name), endings_of(format)});
    }
    return kinds;
}

void forget_file_messages(ViewerState& state) {
    state.gone_at.reset();
    state.messages.scene_gone.clear();
    state.messages.scene_error.clear();
}

LoadOptions load_options(const ViewerState& state, const std::string& path, std::int64_t frame) {
    LoadOptions options;
    options.data_background = quiet_background;
    options.counts_frames = false;
    options.data = state.options.data;
    options.data.frame = frame;
    options.data.all_properties_up_to = most_spheres_with_properties;
    if (state.all_properties && path == state.path) options.data.all_properties = true;
    // The columns are those of the table that the command line names, and the look is that file's.
    const auto& first = state.options.scene;
    if (first && absolute_path(*first) == absolute_path(path)) {
        options.look = state.options.look;
    } else {
        options.data.columns.clear();
    }
    // What was chosen in the window is kept for other frames, and where the file has changed, of files that hold no colours.
    if (state.format.is_data && !state.path.empty() && absolute_path(path) == state.path) keep_chosen_look(state, options.look);
    options.fit = state.options.fit;
    if (options.fit.wanted.value_or(false)) options.fit.wanted.reset();
    // The projection is for the first view, not for later scenes.
    options.fit.projection.reset();
    options.fit.saved_view.reset();
    return options;
}

void adopt(ViewerState& state, LoadedScene loaded, const std::string& path) {
    state.loading.reset();
    state.document = Document(std::move(loaded.scene));
    state.player.reloads = {};
    state.all_properties = false;
    note_properties(state, loaded);
    state.bounds_revision = 0;
    state.selection.clear();
    state.hovered.reset();
    state.side_panel = {};
    state.comparing.reset();
    state.comparison.reset();
    state.rays = {.choice = state.rays.choice};
    forget_file_messages(state);
    const bool has_file = !path.empty() && path != standard_stream;
    const std::string before = std::exchange(state.path, has_file ? absolute_path(path) : "");
    state.format = loaded.format;
    state.frame = 0;
    if (state.path != before) state.player.choices.speed.recorded.reset();  // another file's time is no measure of this one's
    state.stamp.clear();
    if (has_file) {
        state.stamp = file_states(state.path);
        add_recent(state.settings, state.path);
    }
    state.read_stamp = state.stamp;
    begin_frames(state, loaded);
    go_home(state);
    note_look(state, loaded);
    announce_reading(state, joined(loaded.look.lines, "\n"), loaded);
}

void new_scene(ViewerState& state) {
    with_edits_safe(state, [&state] { adopt(state, {{}, "", SceneFormat::toml}, ""); });
}

void open_scene(ViewerState& state, const std::string& path) {
    with_edits_safe(state, [&state, path] { read_scene(state, path); });
}

FileBrowser file_dialog(const ViewerState& state) {
    FileBrowser browser;
    browser.folder = usual_folder(state);
    for (const std::string& path : state.settings.recent) {
        const std::string folder = text_from(path_from(path).parent_path());
        if (std::ranges::find(browser.places, folder) == browser.places.end()) browser.places.push_back(folder);
    }
    return browser;
}

FileBrowser saving_dialog(const ViewerState& state, const std::string& title, const std::string& path, const std::string& fault) {
    FileBrowser browser = file_dialog(state);
    browser.saving = true;
    browser.title = title;
    browser.folder = text_from(path_from(path).parent_path());
    browser.name = text_from(path_from(path).filename());
    browser.error = fault;
    return browser;
}

void ask_for_scene(ViewerState& state) {
    FileBrowser browser = file_dialog(state);
    browser.title = "Open a scene";
    browser.kinds = read_kinds();
    browser.accept = [&state](const std::string& path, PictureSize) { open_scene(state, path); };
    state.dialogs.push_back(std::move(browser));
}

void adopt_frame(ViewerState& state, std::int64_t frame, LoadedScene loaded, const FileStates& stamp, const std::string& first) {
    const bool same_spheres = loaded.scene.spheres.size() == state.scene().spheres.size();
    const bool measures = state.measuring.revision == state.document.names_revision();
    take_shared_edits(state, loaded.scene.spheres.size());
    state.document = Document(std::move(loaded.scene));
    note_properties(state, loaded);
    state.bounds_revision = 0;
    if (!same_spheres) {
        state.selection.clear();
        state.hovered.reset();
    }
    forget_file_messages(state);
    state.frame = frame;
    state.player.time = loaded.time;
    state.stamp = state.read_stamp = stamp;
    note_look(state, loaded);
    give_shared_edits(state);
    shown_coloring(state.document, state.side_panel.look);  // the next frame is read with it
    if (same_spheres && measures) state.measuring.revision = state.document.names_revision();
    const auto was_said = [&](const std::string& line) {
        return !state.player.said.insert(line).second && state.player.clock.plays();
    };
    std::erase_if(loaded.warnings, was_said);
    std::erase_if(loaded.notes, was_said);
    announce_reading(state, was_said(first) ? "" : first, loaded);
}

void look_at_file(ViewerState& state) {
    // What is being written is our own, and what is being opened will take its place.
    if (state.path.empty() || state.saving || (state.loading && !state.loading->reload)) return;
    FileStates stamp = file_states(state.path);
    if (stamp == state.stamp) return;
    state.stamp = std::move(stamp);
    if (state.stamp.empty()) return note_gone(state);
    start_loading(state, {.path = state.path,
                          .options = load_options(state, state.path, state.frame),
                          .accept =
                              [&state](LoadedScene loaded) {
                                  note_back(state);
                                  offer_reload(state, std::move(loaded));
                              },
                          .fail =
                              [&state](const std::string& why) {
                                  // Something is there, but not the scene: that is still in the window alone.
                                  state.messages.scene_gone.clear();
                                  state.messages.scene_error = why;
                              },
                          .cancel = [&state] { state.document.mark_unsaved(); },
                          .reload = true,
                          .or_last_frame = true});
}

}  // namespace sphereview
