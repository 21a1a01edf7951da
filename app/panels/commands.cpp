#include "panels/commands.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "base/text.hpp"

namespace sphereview {

namespace {

using enum CommandId;

constexpr auto written = std::to_array<CommandInfo>({
    {file_new, "File", "New", "Ctrl+N", "Begins an empty scene."},
    {file_open, "File", "Open...", "Ctrl+O", "Opens a scene file."},
    {file_save, "File", "Save", "Ctrl+S", "Writes the scene to its file.", true},
    {file_save_as, "File", "Save as...", "Ctrl+Shift+S", "Writes the scene to another file."},
    {export_picture, "File", "Export picture...", "Ctrl+E", "Asks for a name and a size and writes the view as a PNG.", true},
    {export_now, "File", "Export now", "F12", "Writes the view as a PNG at once, under the next free name beside the scene."},
    {quit, "File", "Quit", "Ctrl+Q", "Closes the window.", true},

    {undo, "Edit", "Undo", "Ctrl+Z", "Takes the last change of the scene back."},
    {redo, "Edit", "Redo", "Ctrl+Shift+Z|Ctrl+Y", "Makes the change again that was taken back."},
    {add_sphere, "Edit", "Add sphere", "Insert", "Adds a sphere in the middle of the view.", true},
    {duplicate, "Edit", "Duplicate", "Ctrl+D", "Adds copies of the selected spheres."},
    {remove, "Edit", "Delete", "Delete|Backspace", "Deletes the selected spheres."},
    {rename, "Edit", "Rename", "F2", "Gives the selected sphere a name."},
    {hide, "Edit", "Hide or show", "H", "Hides the selected spheres, or shows them again."},
    {select_all, "Edit", "Select all", "Ctrl+A", "Selects every sphere.", true},
    {select_none, "Edit", "Select none", "Ctrl+Shift+A|Escape", "Selects no sphere."},
    {invert_selection, "Edit", "Invert selection", "Ctrl+I", "Selects the spheres that are not selected, and no others."},
    {select_same_color, "Edit", "Select same colour", "Ctrl+L", "Selects every sphere that has a selected one's colour."},
    {select_hidden, "Edit", "Select hidden", "Ctrl+H", "Selects every hidden sphere."},
    {move_up, "Edit", "Move up", "Ctrl+Up", "Moves the selected sphere up in the list; of two equal hits the upper sphere is seen.",
     true},
    {move_down, "Edit", "Move down", "Ctrl+Down", "Moves the selected sphere down in the list."},

    {go_home, "View", "Go home", "Home", "Returns to the scene's own camera."},
    {center_on_selection, "View", "Centre on selection", "C|.", "Brings the selected spheres to the middle of the picture."},
    {fit_all, "View", "Fit everything", "F", "Moves the view so that it sees everything, the way it looks.", true},
    {view_front, "View", "From the front", "1", "Fits everything, seen along z."},
    {view_right, "View", "From the right", "2", "Fits everything, seen against x."},
    {view_top, "View", "From the top", "3", "Fits everything, seen from above."},
    {view_iso, "View", "From a corner", "4", "Fits everything, seen isometrically: all three axes equally long."},
    {use_view_as_camera, "View", "Use this view as the scene's camera", "Ctrl+Home",
     "An edit like any other: Home returns here then.", true},
    {next_frame, "View", "Next frame", "Page Down", "Shows the next frame of a file of several; the view stays.", true},
    {previous_frame, "View", "Previous frame", "Page Up", "Shows the frame before."},
    {toggle_panel, "View", "Side panel", "Tab|F9", "Shows or hides the side panel.", true},
    {toggle_inspector, "View", "Pixel inspector", "I", "Shows or hides the arithmetic of the pixel under the pointer."},
    {toggle_export_area, "View", "Area of the export", "M", "Marks what an export shows, where the window shows more or less."},
    {no_anti_aliasing, "View", "Anti-aliasing off", "Alt+1", "A pixel shows what is at its centre.", true},
    {anti_aliasing_4, "View", "4 samples a pixel", "Alt+4",
     "When nothing moves, and in exports, a pixel is the average of 4 points."},
    {anti_aliasing_16, "View", "16 samples a pixel", "Alt+6", "The average of 16 points."},
    {larger_text, "View", "Larger text", "Ctrl++|Ctrl+=", "Makes text and panels larger.", true},
    {smaller_text, "View", "Smaller text", "Ctrl+-", "Makes text and panels smaller."},

    {help, "Help", "Keys and mouse", "F1|?", "Lists every shortcut and what the mouse does."},
});

// With the shading modes in their place.
constexpr auto commands = [] {
    constexpr std::array<std::string_view, 9> keys = {"Ctrl+1", "Ctrl+2", "Ctrl+3", "Ctrl+4", "Ctrl+5",
                                                      "Ctrl+6", "Ctrl+7", "Ctrl+8", "Ctrl+9"};
    std::array<CommandInfo, written.size() + shading_modes.size()> all{};
    auto* next = all.data();
    for (const CommandInfo& command : written) {
        for (std::size_t i = 0; command.id == toggle_panel && i < shading_modes.size(); ++i) {
            const auto id = static_cast<CommandId>(static_cast<std::size_t>(first_shading) + i);
            *next++ = {id, "View", shading_modes[i].title, keys.at(i), shading_modes[i].help, false, "Shading"};
        }
        *next++ = command;
    }
    return all;
}();

}  // namespace

std::span<const CommandInfo> all_commands() { return commands; }

const CommandInfo& info_of(CommandId id) {
    const auto info = std::ranges::find(commands, id, &CommandInfo::id);
    assert(info != commands.end());
    return *info;
}

namespace {

// A key with what must be held.
struct Keys {
    bool control = false;
    bool shift = false;
    bool alt = false;
    std::string_view key;
};

bool take(std::string_view& text, std::string_view beginning) {
    // What is only a modifier's name is a key: the "+" of "Ctrl++" must stay.
    if (!text.starts_with(beginning) || text.size() == beginning.size()) return false;
    text.remove_prefix(beginning.size());
    return true;
}

Keys keys_of(std::string_view text) {
    Keys keys;
    keys.control = take(text, "Ctrl+");
    keys.shift = take(text, "Shift+");
    keys.alt = take(text, "Alt+");
    keys.key = text;
    return keys;
}

std::vector<std::string_view> alternatives(std::string_view shortcut) {
    std::vector<std::string_view> found;
    while (!shortcut.empty()) {
        const std::size_t end = std::min(shortcut.find('|'), shortcut.size());
        found.push_back(shortcut.substr(0, end));
        shortcut.remove_prefix(std::min(end + 1, shortcut.size()));
    }
    return found;
}

// One printable ASCII character that is neither a letter nor a digit.
bool is_symbol(std::string_view key) {
    if (key.size() != 1 || key[0] <= ' ' || key[0] > '~') return false;
    const char c = lower_case(key)[0];
    return !(c >= 'a' && c <= 'z') && !(c >= '0' && c <= '9');
}

}  // namespace

std::string first_shortcut(std::string_view shortcut) { return std::string(shortcut.substr(0, shortcut.find('|'))); }

std::string every_shortcut(std::string_view shortcut) {
    std::string text;
    for (const std::string_view one : alternatives(shortcut)) text += (text.empty() ? "" : " or ") + std::string(one);
    return text;
}

bool matches(std::string_view shortcut, std::string_view key_name, bool control, bool shift, bool alt) {
    return std::ranges::any_of(alternatives(shortcut), [&](std::string_view one) {
        const Keys keys = keys_of(one);
        const bool shift_fits = keys.shift == shift || (shift && is_symbol(keys.key));
        return keys.control == control && keys.alt == alt && shift_fits && lower_case(keys.key) == lower_case(key_name);
    });
}

std::optional<CommandId> command_for_key(std::string_view key_name, bool control, bool shift, bool alt) {
    if (is_symbol(key_name) && !control && !alt) return std::nullopt;
    for (const CommandInfo& info : all_commands()) {
        if (matches(info.shortcut, key_name, control, shift, alt)) return info.id;
    }
    return std::nullopt;
}

std::optional<CommandId> command_for_character(char32_t character) {
    if (character > U'~') return std::nullopt;
    const char key = static_cast<char>(character);
    if (!is_symbol({&key, 1})) return std::nullopt;
    for (const CommandInfo& info : all_commands()) {
        if (matches(info.shortcut, {&key, 1}, false, false, false)) return info.id;
    }
    return std::nullopt;
}

}  // namespace sphereview
