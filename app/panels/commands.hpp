// The commands of the menus, with their shortcuts and help. The table is in viewer/command_table.cpp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "shade/shading.hpp"

namespace sphereview {

enum class CommandId {
    file_new,
    file_open,
    file_save,
    file_save_as,
    export_picture,   // asks for name and size
    export_film,      // likewise
    export_now,       // F12: the next free name
    compare_picture,  // of another ray tracer
    quit,
    undo,
    redo,
    cut,
    copy,
    paste,
    add_sphere,
    duplicate,
    remove,
    rename,
    hide,  // or show again
    select_all,
    select_none,
    invert_selection,
    select_same_color,
    select_hidden,
    move_up,  // in the order of the list
    move_down,
    go_home,  // the scene's own camera
    center_on_selection,
    fit_all,  // the way the view looks
    view_front,
    view_back,
    view_right,
    view_left,
    view_top,
    view_bottom,
    view_iso,
    orthographic,  // or perspective again
    trackball,     // or turntable again
    use_view_as_camera,
    save_view,
    play,  // the frames of a file of several, or pause
    next_frame,
    previous_frame,
    first_frame,
    last_frame,
    play_faster,
    play_slower,
    loop,            // from the last frame to the first
    back_and_forth,  // from the last frame back
    first_shading,   // one for each of shading_modes, in their order
    last_shading = first_shading + static_cast<int>(shading_modes.size()) - 1,
    toggle_panel,
    toggle_inspector,
    pin_pixel,    // that the inspector shows
    toggle_rays,  // in space, seen from beside
    measure,
    toggle_export_area,
    toggle_axes,
    toggle_scale_bar,
    toggle_legend,
    toggle_exported_marks,
    no_anti_aliasing,
    anti_aliasing_4,
    anti_aliasing_16,
    light_theme,
    larger_text,
    smaller_text,
    help,
    about,
};

struct CommandInfo {
    CommandId id;
    std::string_view menu;      // "File", "Edit", "View", "Help"
    std::string_view label;     // "Save as..."
    std::string_view shortcut;  // "Ctrl+Shift+S"; "" for none; with several keys the first is shown: "Ctrl+Shift+Z|Ctrl+Y"
    std::string_view help;      // one sentence
    bool separator_before = false;
    std::string_view submenu = {};  // within the menu; "": in the menu itself
    bool enabled = true;            // the command has something to do now
    bool checked = false;           // the menu marks it as the present choice
};

// The command of that id, which must be among `commands`.
const CommandInfo& info_of(std::span<const CommandInfo> commands, CommandId id);

// The alternatives of a shortcut.
std::string first_shortcut(std::string_view shortcut);  // "Ctrl+Shift+Z"
std::string every_shortcut(std::string_view shortcut);  // "Ctrl+Shift+Z or Ctrl+Y"

// Whether a key, by KeyChanged's name, is one of the shortcut's alternatives. On some keyboards a symbol such as "+" needs Shift,
// so Shift may always be held for symbols, and must be held only if the shortcut names it.
bool matches(std::string_view shortcut, std::string_view key_name, bool control, bool shift, bool alt);

// The command of a pressed key: the first enabled one. Symbols without Ctrl and Alt, such as "?", are left to
// command_for_character(): a key's name is its character without Shift, so only the typed character tells which key is "?".
std::optional<CommandId> command_for_key(std::span<const CommandInfo> commands, std::string_view key_name, bool control, bool shift,
                                         bool alt);
std::optional<CommandId> command_for_character(std::span<const CommandInfo> commands, char32_t character);

}  // namespace sphereview
