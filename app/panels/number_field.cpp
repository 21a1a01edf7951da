#include "panels/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number.hpp"
#include "base/text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

constexpr double steps_of_own_size = 100.0;  // pixels that change a number by about its own size
constexpr double factor_per_step = 0.01;     // of what is above 0
constexpr int factor_digits = 4;             // significant, of what such a drag gives
constexpr double fine = 0.1;
constexpr double coarse = 10.0;
constexpr float click_reach = 3.0F;  // pixels, times the scale: a click may move so far

bool has_ends(const NumberRule& rule) { return std::isfinite(rule.high - rule.low); }

// What a pixel of a drag that begins there changes: 1, 2 or 5 times a power of ten.
double step_from(const NumberRule& rule, double from) {
    return round_number_below(std::max(std::fabs(from), rule.usual_size) / steps_of_own_size);
}

double value_after(const NumberRule& rule, const NumberFields::Drag& drag, double steps) {
    if (steps == 0.0) return drag.from;
    const int finer = drag.finest < 1.0 ? 1 : 0;
    if (rule.above_zero) {
        const double value = drag.from * std::exp(factor_per_step * steps);
        const double least = std::max(rule.low, std::numeric_limits<double>::min());
        return std::clamp(rounded_to(value, last_digit(value, factor_digits + finer)), least, rule.high);
    }
    const double value = std::clamp(drag.from + steps * drag.step, rule.low, rule.high);
    if (rule.whole) return std::round(value);
    // Rounded ends may lie beyond the rule's.
    return std::clamp(rounded_to(value, last_digit(drag.step, 1 + finer)), rule.low, rule.high) + 0.0;  // -0 becomes 0
}

// From where the button went down, without what a click may move: so there and back is 0.
double dragged_by(float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    const float pixels = (io.MousePos.x - io.MouseClickedPos[0].x) / scale;
    return static_cast<double>(std::copysign(std::max(std::fabs(pixels) - click_reach, 0.0F), pixels));
}

double pace_now() {
    const ImGuiIO& io = ImGui::GetIO();
    return io.KeyShift ? fine : io.KeyCtrl ? coarse : 1.0;
}

void begin_drag(const PanelContext& context, NumberFields& fields, const NumberRule& rule, double value) {
    ++context.gesture;
    const double pace = pace_now();
    fields.drag = {.from = value, .step = step_from(rule, value), .pace = pace, .finest = pace};
}

double drag_on(NumberFields::Drag& drag, const NumberRule& rule, float scale) {
    const double by = dragged_by(scale);
    if (by != 0.0) drag.moved = true;
    if (const double pace = pace_now(); pace != drag.pace) {
        drag.steps += (by - drag.anchor) * drag.pace;
        drag.anchor = by;
        drag.pace = pace;
        drag.finest = std::min(drag.finest, pace);
    }
    if (key_pressed(ImGuiKey_Escape)) drag.cancelled = true;
    return drag.cancelled ? drag.from : value_after(rule, drag, drag.steps + (by - drag.anchor) * drag.pace);
}

void open_box(NumberFields& fields, const std::string& name) {
    fields.typed = name;
    fields.focus = true;
    fields.opens = true;
    if (fields.refused == name) fields.refused.clear();
}

std::string ends_in_words(const NumberRule& rule) {
    if (rule.above_zero && rule.low <= 0.0) return "a number above 0 is expected";
    return std::string(rule.whole ? "a whole number from " : "a number from ") + shortest(rule.low) + " to " + shortest(rule.high) +
           " is expected";
}

ExpressionValue entered(std::string_view text, const NumberRule& rule) {
    ExpressionValue result = evaluate(text);
    if (!result.fault.empty()) return result;
    const bool allowed = result.value >= rule.low && result.value <= rule.high && (!rule.above_zero || result.value > 0.0) &&
                         (!rule.whole || result.value == std::round(result.value));
    if (!allowed) result.fault = ends_in_words(rule);
    return result;
}

// Below the box that was drawn last, so that it covers none of what is typed.
void say_below(const ExpressionValue& result) {
    ImGui::SetNextWindowPos({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + ImGui::GetStyle().ItemInnerSpacing.y});
    ImGui::BeginTooltip();
    if (result.fault.empty()) {
        ImGui::Text("= %s", shortest(result.value).c_str());
    } else {
        ImGui::TextColored(fault_color(), "%s", result.fault.c_str());
    }
    ImGui::EndTooltip();
}

NumberChange draw_box(const PanelContext& context, NumberFields& fields, const NumberRule& rule, double& value,
                      const std::string& several) {
    if (std::exchange(fields.opens, false)) {
        fields.text = several.empty() ? shortest(value) : "";
        fields.opened_with = fields.text;
    }
    const bool untouched = fields.text == fields.opened_with || trimmed(fields.text).empty();
    const ExpressionValue shown = untouched ? ExpressionValue{} : entered(fields.text, rule);
    if (fields.focus) focus_next_box();
    // What was refused is in red until it changes, in words below as well.
    const bool refused = fields.refused == fields.typed;
    ImGui::PushStyleColor(ImGuiCol_Text, !refused && shown.fault.empty() ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : fault_color());
    const int step = draw_text_box("##typed", "", fields.text, ImGuiInputTextFlags_AutoSelectAll);
    ImGui::PopStyleColor();
    note_widget(context, "slider " + fields.typed);
    if (refused && ImGui::IsItemEdited()) fields.refused.clear();
    if (ImGui::IsItemActive()) {
        fields.focus = false;
        note_widget(context, "typed " + fields.typed);  // now, and not before, it takes what is typed
    }
    if (!ImGui::IsItemDeactivated() && step == 0) {
        if (!untouched && !refused && (!shown.fault.empty() || is_calculation(fields.text))) say_below(shown);
        return NumberChange::none;
    }
    // Escape gave back the text that the box had when it got the keyboard, which may be a refused one.
    const std::string text = fields.text;
    const bool given_up = step == 0 && key_pressed(ImGuiKey_Escape);
    const bool same = given_up || text == fields.opened_with || trimmed(text).empty();
    const std::string name = fields.typed;
    const std::string before = fields.last_drawn;
    // Not the drag: a press on a field above has begun one already.
    fields.typed.clear();
    fields.just_typed = name;
    fields.focus = false;
    fields.passes_on = step > 0;
    fields.left_by_key = step != 0 || key_pressed(ImGuiKey_Enter);
    if (same && refused) fields.refused.clear();
    if (step < 0) open_box(fields, before);
    if (same) return NumberChange::none;
    const ExpressionValue result = entered(text, rule);
    if (!result.fault.empty()) {
        refuse_number(fields, name, in_quotes(text) + ": " + result.fault);
        return NumberChange::none;
    }
    fields.refused.clear();
    if (result.value == value && several.empty()) return NumberChange::none;
    value = result.value;
    return NumberChange::typed;
}

void say_what_it_is(const std::string& name, const NumberRule& rule, const std::string& shown) {
    const std::string help = *rule.help == '\0' ? "" : std::string(rule.help) + "\n";
    const std::string text =
        name + " = " + shown + "\n" + help + "Drag it (Shift finer, Ctrl coarser), or click and type, also 50+3*2.";
    // Beside the panel, where there is room: below the pointer are the next fields.
    const ImGuiStyle& style = ImGui::GetStyle();
    const float needed = ImGui::CalcTextSize(text.c_str()).x + 2.0F * style.WindowPadding.x + style.ItemSpacing.x;
    const ImVec2 window = ImGui::GetWindowPos();
    if (window.x >= needed) {
        ImGui::SetNextWindowPos({window.x - style.ItemSpacing.x, ImGui::GetItemRectMin().y}, ImGuiCond_Always, {1.0F, 0.0F});
    }
    ImGui::SetTooltip("%s", text.c_str());
}

// Where the number is between its ends, on the field's lower edge: beside the digits, not on them.
void draw_place_between_ends(const NumberRule& rule, double value, float scale) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const auto part = static_cast<float>(std::clamp((value - rule.low) / (rule.high - rule.low), 0.0, 1.0));
    const float margin = ImGui::GetStyle().FrameRounding;
    const float end = low.x + margin + part * (high.x - low.x - 2.0F * margin);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x + margin, high.y - 2.0F * scale}, {end, high.y},
                                              ImGui::GetColorU32(ImGuiCol_SliderGrab));
}

NumberChange draw_drag(const PanelContext& context, NumberFields& fields, const std::string& name, const NumberRule& rule,
                       double& value, const std::string& several) {
    const float width = ImGui::CalcItemWidth();
    const float room = width - 2.0F * ImGui::GetStyle().FramePadding.x;
    std::string shown = several.empty() ? fitting_text(value, room) : several;
    if (width_of(rule.prefix + shown) <= room) shown.insert(0, rule.prefix);
    if (width_of(shown + rule.unit) <= room) shown += rule.unit;
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_FrameBgHovered));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, ImGui::GetStyleColorVec4(ImGuiCol_FrameBgActive));
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, ImVec2(0.0F, 0.5F));  // where the box has it
    ImGui::Button((shown + "###drag").c_str(), {width, 0.0F});
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(3);
    note_widget(context, "slider " + name);
    if (several.empty() && has_ends(rule)) draw_place_between_ends(rule, value, context.scale);
    const bool active = ImGui::IsItemActive();
    if (ImGui::IsItemHovered() || active) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (fields.just_typed == name && !ImGui::IsItemHovered()) fields.just_typed.clear();
    // What is said below the field, and fields that are typed into, are not covered.
    if (ImGui::IsItemHovered() && !active && fields.typed.empty() && fields.just_typed != name) {
        say_what_it_is(name, rule, several.empty() ? shortest(value) : several);
    }
    if (ImGui::IsItemActivated()) begin_drag(context, fields, rule, value);
    // A redraw's movement comes before its release.
    if (!active && !ImGui::IsItemDeactivated()) return NumberChange::none;
    const double next = drag_on(fields.drag, rule, context.scale);
    // Also where the field is no longer under the pointer: what is said below another one may have gone meanwhile.
    if (!active && !fields.drag.moved && !fields.drag.cancelled) open_box(fields, name);
    if (next == value) return NumberChange::none;
    fields.refused.clear();
    value = next;
    return NumberChange::dragged;
}

}  // namespace

bool takes_keyboard(NumberFields& fields) { return std::exchange(fields.passes_on, false); }

NumberChange draw_number(const PanelContext& context, NumberFields& fields, const std::string& name, const NumberRule& rule,
                         double& value, const std::string& several) {
    ImGui::PushID(name.c_str());
    if (fields.typed.empty() && takes_keyboard(fields)) open_box(fields, name);
    const NumberChange change = fields.typed == name ? draw_box(context, fields, rule, value, several)
                                                     : draw_drag(context, fields, name, rule, value, several);
    ImGui::PopID();
    fields.last_drawn = name;
    return change;
}

void refuse_number(NumberFields& fields, const std::string& name, const std::string& fault) {
    fields.refused = name;
    fields.fault = fault;
    if (!std::exchange(fields.left_by_key, false)) return;
    fields.typed = name;
    fields.focus = true;
    fields.opens = false;  // with the text that was typed
    fields.passes_on = false;
}

void draw_refusal(const PanelContext& context, const NumberFields& fields, const std::string& name) {
    if (fields.refused != name || name.empty()) return;
    fault_text(fields.fault + ".");
    note_widget(context, "refusal " + name);
}

NumberChange draw_number_line(const PanelContext& context, NumberFields& fields, const char* name, const NumberRule& rule,
                              double& value) {
    begin_field(context, name);
    const NumberChange change = draw_number(context, fields, name, rule, value);
    draw_refusal(context, fields, name);
    return change;
}

std::string fitting_text(double value, float width) {
    constexpr int most_digits = 16;
    std::string text = shortest(value);
    for (int digits = most_digits; digits > 0 && width_of(text) > width; --digits) {
        const std::string shorter = short_text(value, digits);
        if (width_of(shorter) < width_of(text)) text = shorter;  // 144 is not: 1e+02 takes more room
    }
    return text;
}

std::string range_text(double low, double high) {
    constexpr int digits = 5;
    return short_text(low, digits) + " to " + short_text(high, digits);
}

}  // namespace sphereview
