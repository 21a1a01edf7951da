#include "panels/look_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "look/sizes.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

constexpr std::size_t most_used = 16;
constexpr std::size_t bins = 64;
constexpr const char* nothing_chosen = "as they are";

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

// Those spheres alone that get another value: an edit keeps what was there before.
template <typename Change>
ChangeSpheres changed(const Scene& scene, const Change& change) {
    ChangeSpheres edit;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        Sphere sphere = scene.spheres[i];
        change(sphere, i);
        if (same_bits(sphere, scene.spheres[i])) continue;
        edit.numbers.push_back(static_cast<std::uint32_t>(i));
        edit.spheres.push_back(sphere);
    }
    return edit;
}

class LookPanel {
public:
    LookPanel(const PanelContext& context, LookPanelState& state, NumberFields& numbers)
        : context_(context), scene_(context.document.scene()), state_(state), numbers_(numbers) {}

    void draw() {
        take_seen();
        shown_coloring(context_.document, state_);  // an undo may have brought others back
        if (choose("colour by", state_.colors.property, false)) {
            state_.colors.range.reset();
            state_.colors.log = false;
            state_.recolors = true;
        }
        Property own;
        const Property* values = chosen(state_.colors.property, own, state_.recolors);
        if (values != nullptr && std::exchange(state_.recolors, false)) {
            state_.colors.map = is_of_categories(*values) ? std::nullopt : state_.last_map;
            recolor(0);
        }
        if (values != nullptr) {
            if (is_category(*values) || (!as_numbers() && is_of_categories(*values))) {
                draw_categories();
            } else {
                count(*values);
                draw_map_choice();
                draw_range();
            }
        }
        if (!state_.fault.empty()) fault_text(state_.fault);
        draw_sizes();
    }

private:
    bool as_numbers() const { return state_.colors.map || state_.colors.range || state_.colors.log; }

    // Looked at once: there may be very many numbers.
    bool is_of_categories(const Property& values) {
        const std::uint64_t order = context_.document.order_revision();
        if (state_.judged_property != values.name || state_.judged_revision != order) {
            state_.judged_property = values.name;
            state_.judged_revision = order;
            state_.by_category = shown_by_category(values);
        }
        return state_.by_category;
    }

    // The values of what is chosen; null until they are read, for which it asks where somebody `waits`.
    const Property* chosen(const std::string& name, Property& own, bool& waits) {
        const Property* values = name.empty() ? nullptr : find_values(scene_, name, own);
        const bool is_unread = std::ranges::find(context_.property_names, name) != context_.property_names.end();
        if (values != nullptr && !(values == &own && is_unread)) return values;
        waits = waits && is_unread;
        if (waits) context_.actions.emplace_back(RequestProperties{});
        return nullptr;
    }

    // What can be chosen: for sizes no words, as far as it is known what they are.
    std::vector<std::string> choices(bool numbers_only) const {
        std::vector<std::string> names(context_.property_names.begin(), context_.property_names.end());
        for (const Property& property : scene_.properties) {
            if (std::ranges::find(names, property.name) == names.end()) names.push_back(property.name);
        }
        std::erase_if(names, [&](const std::string& name) {
            const Property* property = find_property(scene_.properties, name);
            return numbers_only && property != nullptr && is_category(*property);
        });
        for (const std::string_view name : own_value_names) {
            const auto same = [&](const std::string& other) { return lower_case(other) == name; };
            if (std::ranges::none_of(names, same)) names.emplace_back(name);
        }
        return names;
    }

    // Returns whether another property was chosen.
    bool choose(const char* label, std::string& property, bool numbers_only) {
        begin_field(context_, label);
        const std::string shown = property.empty() ? nothing_chosen : as_label(shown_text(property));
        const bool open = ImGui::BeginCombo((std::string("##") + label).c_str(), shown.c_str());
        note_widget(context_, label);
        if (!open) return false;
        bool chosen = false;
        int id = 0;
        for (const std::string& name : choices(numbers_only)) {
            ImGui::PushID(id++);
            if (ImGui::Selectable(as_label(shown_text(name)).c_str(), property == name)) {
                chosen = property != name;
                property = name;
            }
            note_widget(context_, std::string(label) + " " + name);
            ImGui::PopID();
        }
        ImGui::EndCombo();
        return chosen;
    }

    void recolor(std::uint64_t gesture) {
        state_.fault.clear();
        Property own;
        const Property* values = find_values(scene_, state_.colors.property, own);
        if (values == nullptr) return;
        try {
            const Coloring coloring = coloring_of(scene_, *values, state_.colors);
            const std::vector<Color> colors = colors_of(*values, coloring);
            ChangeSpheres edit = changed(scene_, [&](Sphere& sphere, std::size_t i) { sphere.color = colors[i]; });
            note_colors(state_, {state_.colors, coloring, gesture});
            if (!edit.numbers.empty()) {
                context_.actions.emplace_back(EditScene{std::move(edit), "Colour by " + in_quotes(values->name), gesture});
            }
        } catch (const InputError& error) {
            state_.fault = shown_text(error.what());
        }
    }

    void draw_categories() {
        const Coloring* shown = shown_coloring(context_.document, state_);
        if (shown == nullptr || !shown->is_category()) return;
        const std::size_t count = shown->categories.size();
        dim_text(in_groups(count) + (count == 1 ? " category" : " categories"));
    }

    // Counts anew where the values, or the span, are others.
    void count(const Property& values) {
        const Document& document = context_.document;
        const bool log = state_.colors.log;
        bool stale = state_.counted_property != values.name || state_.counted_log != log;
        if (!stale && state_.counted_revision != document.revision()) {
            const ChangesSince changes = document.changes_since(state_.counted_revision);
            stale = changes.order || changes.geometry;
        }
        state_.counted_revision = document.revision();
        if (stale) {
            state_.counted_property = values.name;
            state_.counted_log = log;
            state_.data_range = range_of(values, log);
        }
        ValueRange span = state_.data_range.value_or(ValueRange{0.0, 1.0});
        if (state_.colors.range) {
            const auto& [low, high] = *state_.colors.range;
            span = {std::min({span.low, low, high}), std::max({span.high, low, high})};
        }
        if (state_.handle) span = state_.histogram.span;
        if (stale || span != state_.histogram.span) state_.histogram = histogram_of(values, span, log);
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
                recolor(0);
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
        recolor(gesture);
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
            begin_field(context_, name);
            const NumberChange change = draw_number(context_, numbers_, name, rule, *value);
            draw_refusal(context_, numbers_, name);
            changed = changed || change != NumberChange::none;
            if (change == NumberChange::dragged) gesture = context_.gesture;
        }
        if (changed) set_range(typed, gesture);
        begin_field(context_, "range");
        const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
        if (ImGui::Button("Data", {button_width("Data"), 0.0F})) {
            state_.colors.range.reset();
            recolor(0);
        }
        note_widget(context_, "range of data");
        explain_item("From the least number to the greatest");
        ImGui::SameLine(0.0F, gap);
        if (ImGui::Button("Seen", {button_width("Seen"), 0.0F})) state_.asks_for_seen = true;
        note_widget(context_, "range of seen");
        explain_item("From the least number to the greatest of the spheres that the picture shows");
        ImGui::SameLine(0.0F, 2.0F * gap);
        bool log = state_.colors.log;
        if (ImGui::Checkbox("log", &log)) {
            state_.colors.log = log;
            if (log) state_.colors.range.reset();  // which may not be above 0
            recolor(0);
            if (!state_.fault.empty()) state_.colors.log = false;
        }
        note_widget(context_, "logarithm");
        explain_item("Colours by the logarithm of the numbers");
    }

    void take_seen() {
        const std::optional<std::vector<std::uint32_t>> seen = std::exchange(state_.seen, std::nullopt);
        Property own;
        const Property* values = seen ? find_values(scene_, state_.colors.property, own) : nullptr;
        if (values == nullptr) return;
        if (const auto range = range_of(*values, state_.colors.log, &*seen)) set_range(*range, 0);
    }

    // The bars in their colours, and the range as two handles.
    void draw_histogram() {
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0F);
        const float knob = 5.0F * context_.scale;
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
            draw.AddTriangleFilled({x, bottom}, {x + knob, bottom + 1.7F * knob}, {x - knob, bottom + 1.7F * knob},
                                   held ? ImGui::GetColorU32(ImGuiCol_SliderGrabActive) : line);
        }
        if (hovered && !state_.handle) {
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

    void draw_sizes() {
        if (choose("size by", state_.size_by, true)) state_.resizes = true;
        Property own;
        const Property* values = chosen(state_.size_by, own, state_.resizes);
        if (values == nullptr || is_category(*values)) return;
        if (std::exchange(state_.resizes, false)) {
            state_.scale = usual_scale(scene_, *values);
            resize(*values, 0);
        }
        begin_field(context_, "scale");
        const NumberRule rule{.above_zero = true, .help = "The radius of a value of 1"};
        const NumberChange change = draw_number(context_, numbers_, "scale", rule, state_.scale);
        draw_refusal(context_, numbers_, "scale");
        if (change != NumberChange::none) resize(*values, change == NumberChange::dragged ? context_.gesture : 0);
    }

    void resize(const Property& values, std::uint64_t gesture) {
        std::vector<Sphere> sized = scene_.spheres;
        size_by(sized, values, state_.scale);
        ChangeSpheres edit = changed(scene_, [&](Sphere& sphere, std::size_t i) { sphere.radius = sized[i].radius; });
        if (!edit.numbers.empty()) {
            context_.actions.emplace_back(EditScene{std::move(edit), "Size by " + in_quotes(values.name), gesture});
        }
    }

    const PanelContext& context_;
    const Scene& scene_;
    LookPanelState& state_;
    NumberFields& numbers_;
};

}  // namespace

const Coloring* shown_coloring(const Document& document, LookPanelState& state) {
    if (state.shown_revision != document.revision()) {
        // Else the panel has just chosen others, which the spheres are about to get.
        const bool others_changed_it = state.shown_revision != 0;
        state.shown_revision = document.revision();
        state.shown.reset();
        double best = 0.5;  // most of them
        const ColorBy* by = nullptr;
        for (const UsedColors& used : state.used) {
            Property own;
            const Property* values = find_values(document.scene(), used.coloring.property, own);
            const double part = values == nullptr ? 0.0 : part_with_colors(document.scene(), *values, used.coloring);
            if (!(part > best)) continue;
            best = part;
            by = &used.by;
            state.shown = used.coloring;
            // Spheres may have been hidden or removed.
            if (used.coloring.is_category()) state.shown = coloring_of(document.scene(), *values, used.by);
        }
        // What an undo has brought back is what the panel shows.
        if (by != nullptr && others_changed_it && !state.handle && !state.recolors) state.colors = *by;
    }
    return state.shown ? &*state.shown : nullptr;
}

void note_colors(LookPanelState& state, UsedColors colors) {
    std::erase_if(state.used, [&](const UsedColors& used) {
        return used.by == colors.by || (colors.gesture != 0 && used.gesture == colors.gesture);
    });
    state.used.insert(state.used.begin(), std::move(colors));
    if (state.used.size() > most_used) state.used.resize(most_used);
    state.shown_revision = 0;
}

void draw_look_panel(const PanelContext& context, LookPanelState& state, NumberFields& numbers) {
    ImGui::PushID("look");
    LookPanel(context, state, numbers).draw();
    ImGui::PopID();
}

}  // namespace sphereview
