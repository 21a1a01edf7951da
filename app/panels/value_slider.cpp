#include "panels/value_slider.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/number.hpp"
#include "base/text.hpp"
#include "panels/number_text.hpp"
#include "panels/text_input.hpp"

namespace sphereview {

namespace {

constexpr int radius_digits = 4;  // significant, of what a logarithmic slider gives

// ImGui's own sliders take no range as wide as a double's, and round to a format. So ours slides from 0 to 1.
double part_of(const SliderRange& range, double value) {
    const double part = range.logarithmic ? std::log(value / range.low) / std::log(range.high / range.low)
                                          : (0.5 * value - 0.5 * range.low) / (0.5 * range.high - 0.5 * range.low);
    return std::clamp(part, 0.0, 1.0);
}

// The last digit that a drag gives: some 10,000 steps or more for the whole range.
int digit_of(const SliderRange& range, double value) {
    if (range.logarithmic) return last_digit(value, radius_digits);
    return last_digit(0.5 * range.high - 0.5 * range.low, 5);
}

double value_at(const SliderRange& range, double part) {
    const double value =
        range.logarithmic ? range.low * std::pow(range.high / range.low, part) : (1.0 - part) * range.low + part * range.high;
    return rounded_to(value, digit_of(range, value)) + 0.0;  // -0 becomes 0
}

std::optional<double> parsed(std::string_view text, const SliderRange& range) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return std::nullopt;
    text = text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
    double value = 0.0;
    if (parse_double(text, value) != NumberFault::none || !std::isfinite(value)) return std::nullopt;
    return range.above_zero && !(value > 0.0) ? std::nullopt : std::optional(value);
}

// The mouse went down with Ctrl where the next item will be.
bool is_ctrl_clicked() {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + ImGui::CalcItemWidth(), low.y + ImGui::GetFrameHeight()};
    return ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::IsWindowHovered() &&
           ImGui::IsMouseHoveringRect(low, high);
}

SliderChange draw_typed(const PanelContext& context, TypedNumber& typed, const SliderRange& range, double& value, bool several) {
    const bool refused = !parsed(typed.text, range);
    if (typed.focus) ImGui::SetKeyboardFocusHere();
    ImGui::PushStyleColor(ImGuiCol_Text, refused ? ImVec4(1.0F, 0.4F, 0.4F, 1.0F) : ImGui::GetStyleColorVec4(ImGuiCol_Text));
    input_text("##typed", "", typed.text, ImGuiInputTextFlags_AutoSelectAll);
    ImGui::PopStyleColor();
    note_widget(context, "slider " + typed.field);
    if (ImGui::IsItemActive()) typed.focus = false;
    const bool ended = ImGui::IsItemDeactivated();
    if (refused && !ended) ImGui::SetTooltip("%s", range.above_zero ? "A number above 0 is expected." : "A number is expected.");
    if (!ended) return SliderChange::none;
    const std::optional<double> given = parsed(typed.text, range);  // Escape gave the old text back
    typed = {};
    if (!given || (*given == value && !several)) return SliderChange::none;
    value = *given;
    return SliderChange::typed;
}

}  // namespace

SliderChange draw_value_slider(const PanelContext& context, TypedNumber& typed, const std::string& name, const SliderRange& range,
                               double& value, const std::string& several) {
    ImGui::PushID(name.c_str());
    SliderChange change = SliderChange::none;
    if (typed.field != name && is_ctrl_clicked()) typed = {name, several.empty() ? shortest(value) : "", true};
    if (typed.field == name) {
        change = draw_typed(context, typed, range, value, !several.empty());
    } else {
        constexpr double zero = 0.0;
        constexpr double one = 1.0;
        double part = part_of(range, value);
        const std::string shown = several.empty() ? rounded_text(value, digit_of(range, value)) : several;
        const bool moved = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &part, &zero, &one, shown.c_str(),
                                               ImGuiSliderFlags_NoRoundToFormat | ImGuiSliderFlags_NoInput);
        note_widget(context, "slider " + name);
        if (ImGui::IsItemActivated()) ++context.gesture;
        const double dragged = moved ? value_at(range, part) : value;
        if (dragged != value) {
            value = dragged;
            change = SliderChange::dragged;
        }
        if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
            ImGui::SetTooltip("%s = %s\nCtrl+click to type a number.", name.c_str(),
                              several.empty() ? shortest(value).c_str() : several.c_str());
        }
    }
    ImGui::PopID();
    return change;
}

std::string range_text(const SliderRange& range, double low, double high) {
    return rounded_text(low, digit_of(range, low)) + " to " + rounded_text(high, digit_of(range, high));
}

}  // namespace sphereview
