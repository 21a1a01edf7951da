// How panels look and what they are made of: the theme, fields, buttons, colours, numbers as text.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

enum class Theme { dark, light };

// Gives the current ImGui context our look. Sizes are times `scale`; may be called again for another.
void apply_style(float scale, Theme theme = Theme::dark);

bool is_light_theme();

// A colour of text that is readable on the dark theme's panels, as it has to be on those of the theme that is there.
ImVec4 on_panel(const ImVec4& on_dark);

// The one scale of type and room: a heading (a large line, and dim words below it), the title of a part, text, and rows in which
// text can be chosen, as high as fields.
inline constexpr float name_size = 1.6F;  // of a heading's large line, times the text's
void draw_heading(const PanelContext& context, const std::string& name, const std::string& words);
void draw_title(const PanelContext& context, const std::string& title);
float row_height();

// Writes the label at the left; the next item takes the rest of the line, or, where the line is short, the one below.
void begin_field(const PanelContext& context, const char* label);

// Buttons that run commands, side by side over as many whole lines as they need, each as much wider than its label as the others
// of its line. Their tooltips have
// the command's help and shortcut.
struct CommandButton {
    CommandId id;
    const char* label;   // may differ from the menu's
    const char* widget;  // as what it is noted
};
void draw_command_buttons(const PanelContext& context, const std::vector<CommandButton>& buttons);

// A button, noted as `widget`, which the mouse over it explains. Returns whether it was pressed.
bool draw_button(const PanelContext& context, const char* label, const std::string& widget, const std::string& help = "",
                 bool enabled = true, ImVec2 size = {0.0F, 0.0F});

// The same for a box to tick. Returns whether `value` has changed.
bool draw_checkbox(const PanelContext& context, const std::string& label, bool& value, const std::string& widget,
                   const std::string& help = "");

// A field that opens to a list of words, of which `present` is chosen. Returns the place of another one that was chosen now. Noted
// as `widget` and, for each, "WIDGET WORDS".
std::optional<std::size_t> draw_choice(const PanelContext& context, const std::string& widget,
                                       const std::vector<std::string>& words, std::size_t present, const std::string& help = "");

// In a list of words that is open: Escape closes it, also in a dialog, where ImGui's own keys are off.
void close_list_by_escape();

// How wide a button with that label is, at least.
float button_width(std::string_view label);

// Goes on in the line where so much fits, else in the next. Returns whether it does. `gap`: the usual one by default.
bool same_line_within(float width, float gap = -1.0F);
// The same for a button with that label.
void same_line_for(std::string_view label);

// The mouse over ImGui's last item, also a disabled one, says that.
void explain_item(const std::string& help);

// The next item, a box for typing, takes the keyboard.
void focus_next_box();

// A window that stays where it is put, with nothing of ImGui's around it.
inline constexpr ImGuiWindowFlags bare_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                                ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
// Likewise, and the keyboard passes it over.
inline constexpr ImGuiWindowFlags quiet_window = bare_window | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// Begins a window in the middle of all, in which a long text is read; its close button makes `open` false. To be followed by
// ImGui::End(). `size`: at first, as far as there is room.
bool begin_text_window(const PanelContext& context, const char* title, bool& open, ImVec2 size);

// Text that is continued below where the line ends, or at a place in the window.
void wrapped_text(std::string_view text, float wrap_at = 0.0F);
void colored_text(std::string_view text, const ImVec4& color);
void dim_text(const std::string& text);
inline ImVec4 fault_color() { return on_panel({1.0F, 0.45F, 0.42F, 1.0F}); }
// As one item.
void fault_text(const std::string& text);

// Of a text on one line, in pixels.
float width_of(std::string_view text);
// Of the widest of what `text_of` makes of the items.
template <typename Items, typename TextOf = std::identity>
float widest_of(const Items& items, const TextOf& text_of = {}) {
    float widest = 0.0F;
    for (const auto& item : items) widest = std::max(widest, width_of(text_of(item)));
    return widest;
}
// Of a text on lines of that width.
float wrapped_height(std::string_view text, float width);

// A square of a sphere's colour, at a place in screen coordinates.
void draw_swatch(const Color& color, ImVec2 place, float side, float scale, float opacity = 1.0F);
// The same as an item, as high as a line of text.
void draw_swatch(const PanelContext& context, const Color& color);

// Arms around a pinned pixel, which stays free, as far as `reach` at the usual scale.
inline constexpr ImU32 pin_color = IM_COL32(255, 220, 90, 255);
void draw_pin(ImDrawList& draw, ImVec2 middle, float reach, float scale);

// Whether a key, as ImGui calls it (ImGuiKey_UpArrow), went down or repeats.
bool key_pressed(ImGuiKey key);

// A swatch that opens a picker. The gesture that a change of `color` belongs to; nothing while the colour stays. Begins a gesture
// with each drag. The widget is ImGui's last item afterwards.
std::optional<std::uint64_t> draw_color_edit(const PanelContext& context, const char* label, Color& color);

// The nearest multiple of 10^exponent, as the nearest double; 0 where that is nearest.
double rounded_to(double value, int exponent);

// The exponent of the last of `digits` significant digits; 0 counts as 1.
int last_digit(double value, int digits);

// With so many significant digits at most: "0.3333", "1e+20".
std::string short_text(double value, int digits = 4);

// ImGui::InputText() whose Tab is ours: 1 where Tab was pressed in it, -1 for Shift+Tab, else 0.
int draw_text_box(const char* label, const char* hint, std::string& text, ImGuiInputTextFlags flags = 0);

}  // namespace sphereview
