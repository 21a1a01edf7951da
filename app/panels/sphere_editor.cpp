#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.hpp"
#include "panels/number_field.hpp"
#include "panels/side_panel.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

class SphereEditor {
public:
    // `shared`: of the selected spheres, of which `number` is the primary one.
    SphereEditor(const PanelContext& context, SidePanelState& state, const SharedValues& shared, std::uint32_t number)
        : context_(context),
          state_(state),
          shared_(shared),
          number_(number),
          sphere_(context.document.scene().spheres[number]),
          numbers_(context.selection.numbers()) {}

    void draw() {
        if (numbers_.size() == 1) draw_name();
        const NumberRule coordinate = coordinate_rule(context_.bounds);
        number_line("x", coordinate, SphereValue::x);
        number_line("y", coordinate, SphereValue::y);
        number_line("z", coordinate, SphereValue::z);
        number_line("radius", {.above_zero = true}, SphereValue::radius);
        draw_color();
        begin_field(context_, "hidden");
        constexpr int all = 3;  // one of its two bits: some
        int hidden = shared_.hidden == shared_.count ? all : shared_.hidden > 0 ? 1 : 0;
        const bool toggled = ImGui::CheckboxFlags("##hidden", &hidden, all);
        note_widget(context_, "hidden");
        if (!toggled) return;
        change_all(hidden == all ? "Hide " : "Show ", 0, [&](Sphere& sphere, std::size_t) { sphere.hidden = hidden == all; });
    }

private:
    void draw_name() {
        const Scene& scene = context_.document.scene();
        const std::string old = name_of(scene, number_);
        if (!state_.name_active) state_.name = old;
        begin_field(context_, "name");
        if (draw_text_box("##name", "none", state_.name) > 0) state_.numbers.passes_on = true;
        note_widget(context_, "name");
        state_.name_active = ImGui::IsItemActive();
        if (ImGui::IsItemDeactivated() && state_.name != old) {  // Escape gave the old name back
            context_.actions.emplace_back(EditScene{RenameSphere{number_, state_.name}, "Rename " + title_of(scene, number_)});
        }
    }

    // Three numbers and a swatch, which opens a picker. Where a line has no room for them, each number has a line of its own.
    void draw_color() {
        struct Channel {
            const char* name;
            const char* prefix;
            SphereValue value;
        };
        constexpr std::array<Channel, 3> channels{
            {{"red", "R ", SphereValue::red}, {"green", "G ", SphereValue::green}, {"blue", "B ", SphereValue::blue}}};
        begin_field(context_, "colour");
        const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
        const float left = ImGui::GetCursorPosX();
        const float whole = ImGui::CalcItemWidth() - ImGui::GetFrameHeight();
        float needed = width_of("255");
        for (const Channel& channel : channels) needed = std::max(needed, width_of(in_words_if_several(channel.value)));
        needed += 2.0F * ImGui::GetStyle().FramePadding.x;
        const float third = whole / static_cast<float>(channels.size()) - gap;
        const bool beside = third >= needed;
        for (const Channel& channel : channels) {
            if (!beside) ImGui::SetCursorPosX(left);
            ImGui::SetNextItemWidth(std::max(beside ? third : whole - gap, 1.0F));
            number(channel.name,
                   {.low = 0.0, .high = color_max, .whole = true, .usual_size = 100.0, .help = "", .prefix = channel.prefix},
                   channel.value);
            if (beside || &channel == &channels.back()) ImGui::SameLine(0.0F, gap);
        }
        const auto gesture = draw_color_edit(context_, "##color", sphere_.color);
        note_widget(context_, "color");
        for (const Channel& channel : channels) draw_refusal(context_, state_.numbers, channel.name);
        if (gesture) change_all("Recolour ", *gesture, [&](Sphere& sphere, std::size_t) { sphere.color = sphere_.color; });
    }

    // What the spheres have, where that is not the same; "" where it is.
    std::string in_words_if_several(SphereValue which) const {
        const SharedValues::Range& values = shared_.range(which);
        return values.low == values.high ? "" : range_text(values.low, values.high);
    }

    void number_line(const char* name, const NumberRule& rule, SphereValue which) {
        begin_field(context_, name);
        number(name, rule, which);
        draw_refusal(context_, state_.numbers, name);
    }

    void number(const char* name, const NumberRule& rule, SphereValue which) {
        const std::string several = in_words_if_several(which);
        double value = value_of(sphere_, which);
        const NumberChange change = draw_number(context_, state_.numbers, name, rule, value, several);
        if (change == NumberChange::none) return;
        const std::string what = is_color(which) ? "Recolour " : which == SphereValue::radius ? "Change radius of " : "Move ";
        set_value(sphere_, which, value);
        if (change == NumberChange::typed) {
            change_all(what, 0, [&](Sphere& sphere, std::size_t) { set_value(sphere, which, value); });
            return;
        }
        const ValueDrag& drag = drag_of(which);
        const double from = drag.values[drag.primary];
        const auto dragged = [&](std::size_t i) {
            if (i == drag.primary) return value;
            if (is_color(which)) return std::clamp(drag.values[i] + (value - from), rule.low, rule.high);
            return which == SphereValue::radius ? drag.values[i] * (value / from) : drag.values[i] + (value - from);
        };
        for (std::size_t i = 0; i < drag.values.size(); ++i) {
            const double next = dragged(i);
            if (!std::isfinite(next) || (which == SphereValue::radius && !(next > 0.0))) return;
        }
        change_all(what, context_.gesture, [&](Sphere& sphere, std::size_t i) { set_value(sphere, which, dragged(i)); });
    }

    // What the spheres had when the drag began, so that nothing adds up.
    const ValueDrag& drag_of(SphereValue which) {
        ValueDrag& drag = state_.value_drag;
        if (drag.gesture == context_.gesture && drag.selection == context_.selection.version()) return drag;
        drag = {context_.gesture, context_.selection.version(), {}, 0};
        drag.values.reserve(numbers_.size());
        for (const std::uint32_t number : numbers_) {
            drag.values.push_back(value_of(context_.document.scene().spheres[number], which));
        }
        drag.primary = static_cast<std::size_t>(std::ranges::lower_bound(numbers_, number_) - numbers_.begin());
        return drag;
    }

    // change(sphere, i) of every selected sphere; i is its place among them.
    template <typename Change>
    void change_all(const std::string& what, std::uint64_t gesture, const Change& change) {
        const Scene& scene = context_.document.scene();
        // Leaving a typed number by a drag of another changes two values in one redraw.
        const ChangeSpheres* earlier =
            last_ ? &std::get<ChangeSpheres>(std::get<EditScene>(context_.actions[*last_]).edit) : nullptr;
        ChangeSpheres edit;
        edit.numbers = numbers_;
        edit.spheres.reserve(numbers_.size());
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            edit.spheres.push_back(earlier != nullptr ? earlier->spheres[i] : scene.spheres[numbers_[i]]);
            change(edit.spheres.back(), i);
        }
        last_ = context_.actions.size();
        context_.actions.emplace_back(EditScene{std::move(edit), what + title_of(scene, numbers_), gesture});
    }

    const PanelContext& context_;
    SidePanelState& state_;
    const SharedValues& shared_;
    std::uint32_t number_;
    Sphere sphere_;  // with all that changed in this redraw
    const std::vector<std::uint32_t>& numbers_;
    std::optional<std::size_t> last_;  // the latest of the redraw's actions that is an edit from here
};

std::string in_words(const SharedValues& shared) {
    std::string text = counted(shared.count, "sphere");
    if (!shared.color) text += ", of several colours";
    if (shared.hidden > 0) text += ", " + (shared.hidden == shared.count ? "all" : in_groups(shared.hidden)) + " hidden";
    return text + ". A drag moves all by as much, or scales all alike; a number that is typed is set for all.";
}

}  // namespace

void draw_sphere_editor(const PanelContext& context, SidePanelState& state) {
    const std::optional<std::uint32_t> primary = context.selection.primary();
    const std::size_t count = context.document.scene().spheres.size();
    if (state.edited != primary) {
        state.edited = primary;
        state.numbers = {};
        state.name_active = false;
    }
    if (!primary || *primary >= count || context.selection.numbers().back() >= count) {
        dim_text(count == 0 ? "Add a sphere, or open a file." : "Click a sphere, in the picture or in the list, to change it.");
        return;
    }
    const SharedValues& shared = shared_of_selection(context, state);
    if (shared.count > 1) dim_text(in_words(shared));
    ImGui::PushID(static_cast<int>(*primary));
    SphereEditor(context, state, shared, *primary).draw();
    ImGui::PopID();
}

const SharedValues& shared_of_selection(const PanelContext& context, SidePanelState& state) {
    const std::vector<Sphere>& spheres = context.document.scene().spheres;
    const std::uint64_t revision = context.document.revision();
    if (state.shared_revision != revision || state.shared_selection != context.selection.version()) {
        const bool there = !context.selection.empty() && context.selection.numbers().back() < spheres.size();
        state.shared = there ? shared_values(spheres, context.selection.numbers()) : SharedValues{};
        state.shared_revision = revision;
        state.shared_selection = context.selection.version();
    }
    return state.shared;
}

}  // namespace sphereview
