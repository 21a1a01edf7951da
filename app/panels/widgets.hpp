// The building blocks of panels: theme, fields, buttons, colours, numbers as text.
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

// Gives the current ImGui context our style, with sizes times `scale`. May be called again.
void apply_style(float scale, Theme theme = Theme::dark);

bool is_light_theme();

// A colour of text, chosen for the dark theme's panels, adapted to the present theme.
ImVec4 on_panel(const ImVec4& on_dark);

// Sizes of text: a heading (a large line with dim words below), the title of a part, and rows of text to choose from, as high as
// fields.
inline constexpr float name_size = 1.6F;  // size of a heading's large line by the text's
void draw_heading(const PanelContext& context, const std::string& name, const std::string& words);
void draw_title(const PanelContext& context, const std::string& title);
float row_height();

// Writes the label at the left; the next item takes the rest of the line, or, where the line is short, the one below.
void begin_field(const PanelContext& context, const char* label);

// Buttons that run commands, over whole lines, each as much wider than its label as the others of its line. Tooltips have the
// command's help and shortcut.
struct CommandButton {
    CommandId id;
    const char* label;   // may differ from the menu's
    const char* widget;  // the name to note it by
};
void draw_command_buttons(const PanelContext& context, const std::vector<CommandButton>& buttons);

// A button, noted as `widget`, with `help` as tooltip. Returns whether it was pressed.
bool draw_button(const PanelContext& context, const char* label, const std::string& widget, const std::string& help = "",
                 bool enabled = true, ImVec2 size = {0.0F, 0.0F});

// The same for a box to tick. Returns whether `value` has changed.
bool draw_checkbox(const PanelContext& context, const std::string& label, bool& value, const std::string& widget,
                   const std::string& help = "");

// A field that opens to a list of words, with `present` chosen. Returns the place of a new choice. Noted as `widget` and, for each,
// "WIDGET WORDS".
std::optional<std::size_t> draw_choice(const PanelContext& context, const std::string& widget,
                                       const std::vector<std::string>& words, std::size_t present, const std::string& help = "");

// Lets Escape close an open list of words, also in a dialog, where ImGui's own keys are off.
void close_list_by_escape();

// The least width of a button with that label.
float button_width(std::string_view label);

// Stays in the line if `width` fits, else goes to the next. Returns whether it stays. `gap`: the usual one by default.
bool same_line_within(float width, float gap = -1.0F);
// The same for a button with that label.
void same_line_for(std::string_view label);

// Gives ImGui's last item, also a disabled one, a tooltip.
void explain_item(const std::string& help);

// Gives the keyboard to the next item, a text box.
void focus_next_box();

// A fixed window without ImGui's decorations.
inline constexpr ImGuiWindowFlags bare_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                                ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
// Likewise, and skipped by the keyboard.
inline constexpr ImGuiWindowFlags quiet_window = bare_window | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// Begins a window for a long text in the middle; its close button makes `open` false. Call ImGui::End() afterwards. `size`: the
// first size, if there is room.
bool begin_text_window(const PanelContext& context, const char* title, bool& open, ImVec2 size);

// Text that wraps at the line's end, or at `wrap_at`.
void wrapped_text(std::string_view text, float wrap_at = 0.0F);
void colored_text(std::string_view text, const ImVec4& color);
void dim_text(const std::string& text);
inline ImVec4 fault_color() { return on_panel({1.0F, 0.45F, 0.42F, 1.0F}); }
// Text in fault_color(), as one item.
void fault_text(const std::string& text);

// The width of a text on one line, in pixels.
float width_of(std::string_view text);
// The width of the widest of the items' texts.
template <typename Items, typename TextOf = std::identity>
float widest_of(const Items& items, const TextOf& text_of = {}) {
    float widest = 0.0F;
    for (const auto& item : items) widest = std::max(widest, width_of(text_of(item)));
    return widest;
}
// The height of a text on lines of that width.
float wrapped_height(std::string_view text, float width);

// A square of a sphere's colour, at a place in screen coordinates.
void draw_swatch(const Color& color, ImVec2 place, float side, float scale, float opacity = 1.0F);
// The same as an item, as high as a line of text.
void draw_swatch(const PanelContext& context, const Color& color);

// Arms around a pinned pixel, which stays visible; `reach`: their length at scale 1.
inline constexpr ImU32 pin_color = IM_COL32(255, 220, 90, 255);
void draw_pin(ImDrawList& draw, ImVec2 middle, float reach, float scale);

// Whether ImGui's key, such as ImGuiKey_UpArrow, went down or repeats.
bool key_pressed(ImGuiKey key);

// A swatch that opens a picker. Returns the gesture of a change of `color`, one for each drag; nothing while it stays. The swatch
// is ImGui's last item afterwards.
std::optional<std::uint64_t> draw_color_edit(const PanelContext& context, const char* label, Color& color);

// The nearest multiple of 10^exponent, as the nearest double; 0 where that is nearest.
double rounded_to(double value, int exponent);

// The power of ten of the last of `digits` significant digits; 0 counts as 1.
int last_digit(double value, int digits);

// `value` with at most `digits` significant digits: "0.3333", "1e+20".
std::string short_text(double value, int digits = 4);

// ImGui::InputText() that leaves Tab to us. Returns 1 for Tab, -1 for Shift+Tab, else 0.
int draw_text_box(const char* label, const char* hint, std::string& text, ImGuiInputTextFlags flags = 0);

}  // namespace sphereview
