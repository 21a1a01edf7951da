#include "panels/look_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

constexpr std::size_t bins = 64;

ImU32 drawn(const Color& color) { return IM_COL32(color.r, color.g, color.b, 255); }

// A map's colours, in a rectangle.
void draw_map(ImDrawList& draw, ColorMap map, ImVec2 low, ImVec2 high) {
    constexpr int parts = 32;
    for (int i = 0; i < parts; ++i) {
        const auto x = [&](int part) { return low.x + (high.x - low.x) * static_cast<float>(part) / parts; };
        const ImU32 left = drawn(color_of(map, static_cast<double>(i) / parts));
        const ImU32 right = drawn(color_of(map, (i + 1.0) / parts));
        draw.AddRectFilledMultiColor({x(i), low.y}, {x(i + 1), high.y}, left, right, right, left);
    }
}

Histogram histogram_of(const Property& values, const ValueRange& span, bool log) {
    Histogram histogram{span, std::vector<std::size_t>(bins)};
    for (std::size_t i = 0; i < size_of(values); ++i) {
        const double value = number_at(values, i);
        const double part = part_of(value, span, log);
        if (!std::isfinite(value) || (log && !(value > 0.0)) || !(part >= 0.0 && part <= 1.0)) continue;
        ++histogram.counts[std::min(static_cast<std::size_t>(part * bins), bins - 1)];
    }
    return histogram;
}

class LookRange {
public:
    LookRange(const PanelContext& context, LookPanelState& state, NumberFields& numbers, const Property& values)
        : context_(context), state_(state), numbers_(numbers), values_(values) {}

    std::optional<std::uint64_t> draw() {
        take_seen();
        count();
        draw_map_choice();
        draw_range();
        return changed_;
    }

private:
    // Counts anew where the values, or the span, are others.
    void count() {
        const Document& document = context_.document;
        const bool log = state_.colors.log;
        bool stale = state_.counted_property != values_.name || state_.counted_log != log;
        if (!stale && state_.counted_revision != document.revision()) {
            const ChangesSince changes = document.changes_since(state_.counted_revision);
            stale = changes.order || changes.geometry;
        }
        state_.counted_revision = document.revision();
        if (stale) {
            state_.counted_property = values_.name;
            state_.counted_log = log;
            state_.data_range = range_of(values_, log);
        }
        ValueRange span = state_.data_range.value_or(ValueRange{0.0, 1.0});
        if (state_.colors.range) {
            const auto& [low, high] = *state_.colors.range;
            span = {std::min({span.low, low, high}), std::max({span.high, low, high})};
        }
        if (state_.handle) span = state_.histogram.span;
        if (stale || span != state_.histogram.span) state_.histogram = histogram_of(values_, span, log);
    }

    ValueRange range() const { return state_.colors.range.value_or(state_.data_range.value_or(ValueRange{0.0, 1.0})); }

    void draw_map_choice() {
        begin_field(context_, "map");
        const ColorMap present = state_.colors.map.value_or(ColorMap::viridis);
        const bool open = ImGui::BeginCombo("##map", "");
        const auto on_item = [&](ColorMap map, ImVec2 low, ImVec2 high) {
            const float inset = 3.0F * context_.scale;
            draw_map(*ImGui::GetWindowDrawList(), map, {low.x + inset, low.y + inset}, {high.x - inset, high.y - inset});
        };
        note_widget(context_, "map");
        if (!open) {
            const ImVec2 high = ImGui::GetItemRectMax();
            on_item(present, ImGui::GetItemRectMin(), {high.x - ImGui::GetFrameHeight(), high.y});
            explain_item(std::string(name_of(present)));
            return;
        }
        for (std::size_t i = 0; i < color_map_names.size(); ++i) {
            const auto map = static_cast<ColorMap>(i);
            const std::string name(color_map_names[i]);
            const ImVec2 low = ImGui::GetCursorScreenPos();
            const float width = ImGui::GetContentRegionAvail().x;
            if (ImGui::Selectable(name.c_str(), map == present, 0, {0.0F, row_height()}) && map != present) {
                state_.colors.map = map;
                state_.last_map = map;
                changed_ = 0;
            }
            note_widget(context_, "map " + name);
            const float words = width_of("coolwarm") + 8.0F * context_.scale;
            on_item(map, {low.x + words, low.y}, {low.x + std::max(width, words + 60.0F * context_.scale), low.y + row_height()});
        }
        ImGui::EndCombo();
    }

    void set_range(const ValueRange& range, std::uint64_t gesture) {
        if (range.low == range.high || state_.colors.range == range) return;
        if (state_.colors.log && !(range.low > 0.0 && range.high > 0.0)) return;
        state_.colors.range = range;
        changed_ = gesture;
    }

    void draw_range() {
        draw_histogram();
        ValueRange typed = range();
        const double span = std::abs(typed.high - typed.low);
        NumberRule rule;
        rule.usual_size = std::isfinite(span) && span > 0.0 ? span : 1.0;
        rule.above_zero = state_.colors.log;
        bool changed = false;
        std::uint64_t gesture = 0;
        for (const auto& [name, value] : {std::pair("from", &typed.low), std::pair("to", &typed.high)}) {
            const NumberChange change = draw_number_line(context_, numbers_, name, rule, *value);
            changed = changed || change != NumberChange::none;
            if (change == NumberChange::dragged) gesture = context_.gesture;
        }
        if (changed) set_range(typed, gesture);
        begin_field(context_, "range");
        const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
        if (draw_button(context_, "Data", "range of data", "From the least number to the greatest")) {
            state_.colors.range.reset();
            changed_ = 0;
        }
        ImGui::SameLine(0.0F, gap);
        if (draw_button(context_, "Seen", "range of seen",
                        "From the least number to the greatest of the spheres that the picture shows")) {
            state_.asks_for_seen = true;
        }
        ImGui::SameLine(0.0F, 2.0F * gap);
        bool log = state_.colors.log;
        if (draw_checkbox(context_, "log", log, "logarithm", "Colours by the logarithm of the numbers")) {
            state_.colors.log = log;
            if (log) state_.colors.range.reset();  // which may not be above 0
            changed_ = 0;
        }
    }

    void take_seen() {
        const std::optional<std::vector<std::uint32_t>> seen = std::exchange(state_.seen, std::nullopt);
        if (!seen) return;
        if (const auto range = range_of(values_, state_.colors.log, &*seen)) set_range(*range, 0);
    }

    // The bars in their colours, and the range as two handles.
    void draw_histogram() {
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0F);
        const float knob = 0.5F * ImGui::GetFontSize();  // half as wide as a handle, which a hand has to hit
        const float height = 3.5F * ImGui::GetFrameHeight();
        ImGui::InvisibleButton("##histogram", {width, height});
        note_widget(context_, "histogram");
        const bool hovered = ImGui::IsItemHovered();
        const ValueRange span = state_.histogram.span;
        const bool log = state_.colors.log;
        const float inner = width - 2.0F * knob;
        const auto x_of = [&](double value) {
            return low.x + knob + inner * static_cast<float>(std::clamp(part_of(value, span, log), 0.0, 1.0));
        };
        drag_handles(x_of, low.x + knob, inner);
        const ValueRange shown = range();
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const float bottom = low.y + height - 2.0F * knob;
        draw.AddRectFilled({low.x, low.y}, {low.x + width, bottom}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                           ImGui::GetStyle().FrameRounding);
        std::size_t most = 1;
        for (const std::size_t one : state_.histogram.counts) most = std::max(most, one);
        const float room = bottom - low.y - 2.0F * context_.scale;
        for (std::size_t i = 0; i < state_.histogram.counts.size(); ++i) {
            const std::size_t one = state_.histogram.counts[i];
            if (one == 0) continue;
            const double middle = value_at((static_cast<double>(i) + 0.5) / bins, span, log);
            const Color color = color_of(state_.colors.map.value_or(ColorMap::viridis), part_of(middle, shown, log));
            // Square roots: what is rare is seen, too.
            const float tall =
                std::max(room * std::sqrt(static_cast<float>(one) / static_cast<float>(most)), 1.5F * context_.scale);
            const auto x = [&](std::size_t bin) { return low.x + knob + inner * static_cast<float>(bin) / bins; };
            draw.AddRectFilled({x(i), bottom - tall}, {x(i + 1), bottom}, drawn(color));
        }
        const ImU32 line = ImGui::GetColorU32(ImGuiCol_Text);
        for (const int handle : {0, 1}) {
            const float x = x_of(handle == 0 ? shown.low : shown.high);
            const bool held = state_.handle == handle;
            draw.AddLine({x, low.y}, {x, bottom}, ImGui::GetColorU32(ImGuiCol_Text, held ? 1.0F : 0.6F), 1.0F * context_.scale);
            note_rectangle(context_, handle == 0 ? "handle from" : "handle to", {x - knob, bottom}, {2.0F * knob, 1.7F * knob});
            draw.AddTriangleFilled({x, bottom}, {x + knob, bottom + 1.7F * knob}, {x - knob, bottom + 1.7F * knob},
                                   held ? ImGui::GetColorU32(ImGuiCol_SliderGrabActive) : line);
        }
        if (state_.handle) {
            const double value = state_.handle == 0 ? shown.low : shown.high;
            // Above, where it covers neither the handle nor the fields.
            ImGui::SetNextWindowPos({x_of(value), low.y}, ImGuiCond_Always, {0.5F, 1.0F});
            ImGui::SetTooltip("%s %s", state_.handle == 0 ? "from" : "to", shortest(value).c_str());
        } else if (hovered) {
            ImGui::SetTooltip("How many spheres have which value; drag the ends of the range.");
        }
    }

    template <typename Place>
    void drag_handles(const Place& x_of, float left, float inner) {
        const float mouse = ImGui::GetIO().MousePos.x;
        const ValueRange present = range();
        if (ImGui::IsItemActivated()) {
            ++context_.gesture;
            const float to_low = std::abs(mouse - x_of(present.low));
            const float to_high = std::abs(mouse - x_of(present.high));
            // Where both are at one place, the one that can go that way.
            state_.handle = to_low < to_high || (to_low == to_high && mouse < x_of(present.low)) ? 0 : 1;
        }
        if (!ImGui::IsItemActive()) {
            state_.handle.reset();
            return;
        }
        if (ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0F).x == 0.0F) return;
        const ValueRange span = state_.histogram.span;
        const double part = std::clamp(static_cast<double>((mouse - left) / std::max(inner, 1.0F)), 0.0, 1.0);
        double value = value_at(part, span, state_.colors.log);
        // Short numbers, but the ends as they are.
        const double grain = state_.colors.log ? value : 0.1 * (span.high - span.low);
        if (part > 0.0 && part < 1.0 && std::isfinite(grain) && grain > 0.0) value = rounded_to(value, last_digit(grain, 2));
        ValueRange moved = present;
        (*state_.handle == 0 ? moved.low : moved.high) = value;
        set_range(moved, context_.gesture);
    }

    const PanelContext& context_;
    LookPanelState& state_;
    NumberFields& numbers_;
    const Property& values_;
    std::optional<std::uint64_t> changed_;  // in this redraw, in that gesture
};

}  // namespace

std::optional<std::uint64_t> draw_look_range(const PanelContext& context, LookPanelState& state, NumberFields& numbers,
                                             const Property& values) {
    return LookRange(context, state, numbers, values).draw();
}

}  // namespace sphereview
