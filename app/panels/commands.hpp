// Everything a menu offers, with its shortcut: one table for the menus, the keys and the help.
#pragma once

#include <span>
#include <string_view>

namespace sphereview {

enum class CommandId {
    file_new,
    file_open,
    file_save,
    file_save_as,
    export_picture,  // asks for name and size
    export_now,      // F12: the next free name
    quit,
    undo,
    redo,
    add_sphere,
    duplicate,
    remove,
    rename,
    hide,  // or show again
    select_all,
    select_none,
    move_up,  // in the order of the list
    move_down,
    go_home,  // the scene's own camera
    center_on_selection,
    use_view_as_camera,
    toggle_panel,
    toggle_inspector,
    larger_text,
    smaller_text,
    help,
};

struct CommandInfo {
    CommandId id;
    std::string_view menu;      // "File", "Edit", "View", "Help"
    std::string_view label;     // "Save as..."
    std::string_view shortcut;  // "Ctrl+Shift+S"; "" for none; with several keys the first is shown: "Ctrl+Shift+Z|Ctrl+Y"
    std::string_view help;      // one sentence
    bool separator_before = false;
};

// In the order of the menus.
std::span<const CommandInfo> all_commands();
const CommandInfo& info_of(CommandId id);

}  // namespace sphereview
