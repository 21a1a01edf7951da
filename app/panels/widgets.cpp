#include "panels/widgets.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/number.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

ImVec4 grey(float brightness, float opacity = 1.0F) {
    // A trace of blue, so that the greys of the panels differ from those of a picture.
    return {brightness * 0.97F, brightness, brightness * 1.05F, opacity};
}

ImVec4 accent(float opacity) { return {0.29F, 0.56F, 0.89F, opacity}; }

// A row for each colour that is not ImGui's own: in the dark theme and in the light one.
struct ThemeColor {
    ImGuiCol what;
    ImVec4 dark;
    ImVec4 light;
};

void set_colors(ImGuiStyle& style, Theme theme) {
    const std::array<ThemeColor, 29> colors = {{
        {ImGuiCol_Text, grey(0.90F), grey(0.12F)},
        {ImGuiCol_TextDisabled, grey(0.58F), grey(0.39F)},
        {ImGuiCol_WindowBg, grey(0.125F), grey(0.94F)},
        {ImGuiCol_ChildBg, grey(0.10F, 0.0F), grey(0.94F, 0.0F)},
        {ImGuiCol_PopupBg, grey(0.15F), grey(0.97F)},
        {ImGuiCol_MenuBarBg, grey(0.16F), grey(0.90F)},
        {ImGuiCol_Border, grey(0.30F), grey(0.70F)},
        {ImGuiCol_Separator, grey(0.26F), grey(0.76F)},
        {ImGuiCol_TitleBg, grey(0.11F), grey(0.86F)},
        {ImGuiCol_TitleBgActive, grey(0.18F), grey(0.82F)},
        {ImGuiCol_FrameBg, grey(0.20F), grey(0.85F)},
        {ImGuiCol_FrameBgHovered, grey(0.25F), grey(0.80F)},
        {ImGuiCol_FrameBgActive, grey(0.28F), grey(0.76F)},
        {ImGuiCol_Button, grey(0.25F), grey(0.80F)},
        {ImGuiCol_ButtonHovered, grey(0.31F), grey(0.74F)},
        {ImGuiCol_ButtonActive, grey(0.37F), grey(0.68F)},
        {ImGuiCol_Header, accent(0.38F), accent(0.34F)},
        {ImGuiCol_HeaderHovered, accent(0.26F), accent(0.22F)},
        {ImGuiCol_HeaderActive, accent(0.50F), accent(0.46F)},
        {ImGuiCol_CheckMark, {0.45F, 0.68F, 0.96F, 1.0F}, {0.10F, 0.36F, 0.70F, 1.0F}},
        {ImGuiCol_SliderGrab, accent(0.85F), accent(0.85F)},
        {ImGuiCol_SliderGrabActive, accent(1.0F), accent(1.0F)},
        {ImGuiCol_ScrollbarBg, grey(0.10F, 0.5F), grey(0.88F, 0.5F)},
        {ImGuiCol_ScrollbarGrab, grey(0.32F), grey(0.70F)},
        {ImGuiCol_ScrollbarGrabHovered, grey(0.40F), grey(0.62F)},
        {ImGuiCol_ScrollbarGrabActive, grey(0.46F), grey(0.54F)},
        {ImGuiCol_TableRowBgAlt, {1.0F, 1.0F, 1.0F, 0.03F}, {0.0F, 0.0F, 0.0F, 0.03F}},
        {ImGuiCol_TextSelectedBg, accent(0.45F), accent(0.40F)},
        {ImGuiCol_ModalWindowDimBg, {0.0F, 0.0F, 0.0F, 0.50F}, {0.0F, 0.0F, 0.0F, 0.30F}},
    }};
    for (const ThemeColor& color : colors) style.Colors[color.what] = theme == Theme::light ? color.light : color.dark;
    style.Colors[ImGuiCol_TableBorderLight] = style.Colors[ImGuiCol_Separator];
    style.Colors[ImGuiCol_TableHeaderBg] = style.Colors[ImGuiCol_TitleBgActive];
}

int leading_digit(double value) {
    return value == 0.0 || !std::isfinite(value) ? 0 : static_cast<int>(std::floor(std::log10(std::fabs(value))));
}

void draw_command_button(const PanelContext& context, const CommandButton& button, float width) {
    const CommandInfo& info = info_of(context.commands, button.id);
    const std::string help = std::string(info.help) + (info.shortcut.empty() ? "" : "\n" + every_shortcut(info.shortcut));
    if (draw_button(context, button.label, button.widget, help, info.enabled, {width, 0.0F}))
        context.actions.emplace_back(RunCommand{button.id});
}

// So that a colour is seen on a panel of the same colour.
void draw_edge(ImVec2 low, ImVec2 high, float scale) {
    ImGui::GetWindowDrawList()->AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Text, 0.55F), 2.0F * scale);
}

}  // namespace

void apply_style(float scale, Theme theme) {
    ImGuiStyle style;
    if (theme == Theme::light) {
        ImGui::StyleColorsLight(&style);
    } else {
        ImGui::StyleColorsDark(&style);
    }
    set_colors(style, theme);
    style.WindowPadding = ImVec2(10.0F, 10.0F);
    style.FramePadding = ImVec2(8.0F, 4.0F);
    style.ItemSpacing = ImVec2(8.0F, 6.0F);
    style.ItemInnerSpacing = ImVec2(6.0F, 4.0F);
    style.CellPadding = ImVec2(6.0F, 3.0F);
    style.ScrollbarSize = 13.0F;
    style.GrabMinSize = 10.0F;
    style.WindowRounding = 6.0F;
    style.PopupRounding = 6.0F;
    style.ChildRounding = 4.0F;
    style.FrameRounding = 4.0F;
    style.GrabRounding = 4.0F;
    style.ScrollbarRounding = 6.0F;
    style.WindowTitleAlign = ImVec2(0.5F, 0.5F);
    style.ScaleAllSizes(scale);
    // Lines are whole pixels, or they blur; ScaleAllSizes() leaves them alone.
    const float line = std::max(1.0F, std::floor(scale));
    style.WindowBorderSize = line;
    style.PopupBorderSize = line;
    style.ChildBorderSize = line;
    style.FrameBorderSize = 0.0F;
    ImGui::GetStyle() = style;
}

bool is_light_theme() { return ImGui::GetStyle().Colors[ImGuiCol_WindowBg].x > 0.5F; }

ImVec4 on_panel(const ImVec4& on_dark) {
    constexpr float darker = 0.5F;
    return is_light_theme() ? ImVec4(darker * on_dark.x, darker * on_dark.y, darker * on_dark.z, on_dark.w) : on_dark;
}

void draw_heading(const PanelContext& context, const std::string& name, const std::string& words) {
    ImGui::BeginGroup();
    ImGui::SetWindowFontScale(name_size);
    ImGui::TextUnformatted(name.c_str());
    ImGui::SetWindowFontScale(1.0F);
    dim_text(words);
    ImGui::EndGroup();
    ImGui::Dummy({1.0F, 2.0F * context.scale});
}

void draw_title(const PanelContext& context, const std::string& title) {
    ImGui::Dummy({1.0F, 4.0F * context.scale});
    colored_text(title, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
}

float row_height() { return std::round(ImGui::GetFrameHeight()); }

void begin_field(const PanelContext& context, const char* label) {
    const float column = ImGui::CalcTextSize("background").x + 10.0F * context.scale;  // the longest
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    // Where the line is too short for both, the field goes below.
    const float narrowest = 5.0F * ImGui::GetFontSize();
    const float begin = std::max(column, width_of(label) + ImGui::GetStyle().ItemSpacing.x);
    if (ImGui::GetContentRegionAvail().x >= begin + narrowest) {
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + begin);  // not SameLine()'s: that counts from the group
    }
    ImGui::SetNextItemWidth(std::max(1.0F, ImGui::GetContentRegionAvail().x));
}

void draw_command_buttons(const PanelContext& context, const std::vector<CommandButton>& buttons) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const auto needed = [](const CommandButton& button) { return button_width(button.label); };
    const float whole = ImGui::GetContentRegionAvail().x;
    for (std::size_t begin = 0, end = 0; begin < buttons.size(); begin = end) {
        // As many as the line has room for, without a label cut off.
        float left = whole;
        while (end < buttons.size() && (end == begin || left >= gap + needed(buttons[end]))) {
            left -= needed(buttons[end]) + (end == begin ? 0.0F : gap);
            ++end;
        }
        const float more = std::max(0.0F, left / static_cast<float>(end - begin));
        for (std::size_t i = begin; i < end; ++i) {
            if (i != begin) ImGui::SameLine();
            draw_command_button(context, buttons[i], needed(buttons[i]) + more);
        }
    }
}

bool draw_button(const PanelContext& context, const char* label, const std::string& widget, const std::string& help, bool enabled,
                 ImVec2 size) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label, size);
    ImGui::EndDisabled();
    note_widget(context, widget);
    if (!help.empty()) explain_item(help);
    return pressed;
}

bool draw_checkbox(const PanelContext& context, const std::string& label, bool& value, const std::string& widget,
                   const std::string& help) {
    const bool changed = ImGui::Checkbox(label.c_str(), &value);
    note_widget(context, widget);
    if (!help.empty()) explain_item(help);
    return changed;
}

std::optional<std::size_t> draw_choice(const PanelContext& context, const std::string& widget,
                                       const std::vector<std::string>& words, std::size_t present, const std::string& help) {
    const bool open = ImGui::BeginCombo(("##" + widget).c_str(), words[present].c_str());
    note_widget(context, widget);
    if (!open) {
        if (!help.empty()) explain_item(help);
        return std::nullopt;
    }
    close_list_by_escape();
    std::optional<std::size_t> chosen;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (ImGui::Selectable(words[i].c_str(), i == present) && i != present) chosen = i;
        note_widget(context, widget + " " + words[i]);
    }
    ImGui::EndCombo();
    return chosen;
}

void close_list_by_escape() {
    if (key_pressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
}

float button_width(std::string_view label) {
    return ImGui::CalcTextSize(label.data(), label.data() + label.size(), true).x + 2.0F * ImGui::GetStyle().FramePadding.x;
}

bool same_line_within(float width, float gap) {
    ImGui::SameLine(0.0F, gap);
    const bool fits = ImGui::GetContentRegionAvail().x >= width;
    if (!fits) ImGui::NewLine();
    return fits;
}

void same_line_for(std::string_view label) { same_line_within(button_width(label)); }

void explain_item(const std::string& help) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", help.c_str());
}

void focus_next_box() {
    ImGui::SetWindowFocus();  // since ImGui 1.89 only a window with the focus hands the keyboard on
    ImGui::SetKeyboardFocusHere();
}

bool begin_text_window(const PanelContext& context, const char* title, bool& open, ImVec2 size) {
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport->GetWorkCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({std::min(size.x * context.scale, 0.95F * viewport->WorkSize.x),
                              std::min(size.y * context.scale, 0.9F * viewport->WorkSize.y)},
                             ImGuiCond_Appearing);
    return ImGui::Begin(title, &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
}

void wrapped_text(std::string_view text, float wrap_at) {
    const std::string safe = shown_lines(text);
    ImGui::PushTextWrapPos(wrap_at);
    ImGui::TextUnformatted(safe.data(), safe.data() + safe.size());
    ImGui::PopTextWrapPos();
}

void colored_text(std::string_view text, const ImVec4& color) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    wrapped_text(text);
    ImGui::PopStyleColor();
}

void dim_text(const std::string& text) { colored_text(text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled)); }

void fault_text(const std::string& text) {
    ImGui::BeginGroup();
    colored_text(text, fault_color());
    ImGui::EndGroup();
}

float width_of(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

float wrapped_height(std::string_view text, float width) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size(), false, width).y;
}

void draw_swatch(const Color& color, ImVec2 place, float side, float scale, float opacity) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{place.x + side, place.y + side};
    const ImU32 fill = IM_COL32(color.r, color.g, color.b, static_cast<int>(std::lround(255.0F * opacity)));
    list.AddRectFilled(place, end, fill, 2.0F * scale);
    draw_edge(place, end, scale);
}

void draw_swatch(const PanelContext& context, const Color& color) {
    const float side = ImGui::GetTextLineHeight();
    draw_swatch(color, ImGui::GetCursorScreenPos(), side, context.scale);
    ImGui::Dummy({side, side});
}

void draw_pin(ImDrawList& draw, ImVec2 middle, float reach, float scale) {
    const auto arms = [&](float from, float to, float thickness, ImU32 color) {
        for (const auto& [x, y] : {std::pair{1.0F, 0.0F}, std::pair{-1.0F, 0.0F}, std::pair{0.0F, 1.0F}, std::pair{0.0F, -1.0F}}) {
            draw.AddLine({middle.x + x * from * scale, middle.y + y * from * scale},
                         {middle.x + x * to * scale, middle.y + y * to * scale}, color, thickness * scale);
        }
    };
    arms(3.0F, reach, 4.0F, IM_COL32(0, 0, 0, 190));
    arms(4.0F, reach - 1.0F, 2.0F, pin_color);
}

bool key_pressed(ImGuiKey key) {
#if IMGUI_VERSION_NUM < 18700
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
#else
    return ImGui::IsKeyPressed(key);
#endif
}

std::optional<std::uint64_t> draw_color_edit(const PanelContext& context, const char* label, Color& color) {
    std::array<float, 3> parts = {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b)};
    for (float& part : parts) part /= static_cast<float>(color_max);
    const bool changed = ImGui::ColorEdit3(
        label, parts.data(), ImGuiColorEditFlags_Uint8 | ImGuiColorEditFlags_NoDragDrop | ImGuiColorEditFlags_NoInputs);
    const ImVec2 end = ImGui::GetItemRectMax();
    draw_edge({end.x - ImGui::GetFrameHeight(), ImGui::GetItemRectMin().y}, end, context.scale);
    // ImGui counts the swatch and the picker as one item: a drag in the picker activates the item.
    if (ImGui::IsItemActivated()) ++context.gesture;
    if (!changed) return std::nullopt;
    const auto byte = [](float part) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0F, 1.0F) * static_cast<float>(color_max)));
    };
    const Color edited{byte(parts[0]), byte(parts[1]), byte(parts[2])};
    if (edited == color) return std::nullopt;
    color = edited;
    // What comes from no drag, such as a pasted colour, is a step of its own.
    return ImGui::IsItemActive() || ImGui::IsItemDeactivated() ? context.gesture : 0;
}

int draw_text_box(const char* label, const char* hint, std::string& text, ImGuiInputTextFlags flags) {
    int step = 0;
    const auto note_tab = [](ImGuiInputTextCallbackData* data) {
        *static_cast<int*>(data->UserData) = ImGui::GetIO().KeyShift ? -1 : 1;
        return 0;
    };
    // ImGui leaves Tab to a box that completes words.
    ImGui::InputTextWithHint(label, hint, &text, flags | ImGuiInputTextFlags_CallbackCompletion, note_tab, &step);
    // Since 1.90 it does so only without Shift.
    if (ImGui::IsItemActive() && ImGui::GetIO().KeyShift && key_pressed(ImGuiKey_Tab)) step = -1;
    return step;
}

double rounded_to(double value, int exponent) {
    if (value == 0.0 || !std::isfinite(value)) return value;
    const int digits = leading_digit(value) - exponent;  // behind the first
    if (digits > 16) return value;
    if (digits < 0) {
        const double unit = std::pow(10.0, exponent);
        return std::fabs(value) < 0.5 * unit ? 0.0 : std::copysign(unit, value);
    }
    // Through text, which rounds in decimal: no power of ten is inexact there.
    double rounded = value;
    parse_double(decimal(value, std::chars_format::scientific, digits), rounded);
    return rounded;
}

int last_digit(double value, int digits) { return leading_digit(value) - digits + 1; }

std::string short_text(double value, int digits) { return decimal(value + 0.0, std::chars_format::general, digits); }

}  // namespace sphereview
