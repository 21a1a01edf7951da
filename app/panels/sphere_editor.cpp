#include "panels/sphere_editor.hpp"

#include <imgui.h>

#include <algorithm>
#include <cfloat>

#include "base/text.hpp"
#include "panels/color_edit.hpp"
#include "panels/field.hpp"
#include "panels/text_input.hpp"

namespace sphereview {

namespace {

// Beyond what the scene takes up by its own size.
SliderRange center_range(const SceneBounds& bounds, glm::length_t axis) {
    const double more = std::min(bounds.extent(), DBL_MAX);
    return {std::max(-DBL_MAX, bounds.low[axis] - more), std::min(DBL_MAX, bounds.high[axis] + more)};
}

SliderRange radius_range(const SceneBounds& bounds) {
    const double largest = std::clamp(bounds.extent(), 1e-290, DBL_MAX);
    return {.low = largest / 10000.0, .high = largest, .logarithmic = true, .above_zero = true};
}

class SphereEditor {
public:
    SphereEditor(const PanelContext& context, SidePanelState& state, std::uint32_t number)
        : context_(context), state_(state), number_(number), sphere_(context.document.scene().spheres[number]) {}

    void draw() {
        draw_name();
        slider("x", center_range(context_.bounds, 0), sphere_.center.x);
        slider("y", center_range(context_.bounds, 1), sphere_.center.y);
        slider("z", center_range(context_.bounds, 2), sphere_.center.z);
        slider("radius", radius_range(context_.bounds), sphere_.radius);
        begin_field(context_, "colour");
        const auto gesture = draw_color_edit(context_, "##color", sphere_.color);
        note_widget(context_, "color");
        if (gesture) change_all("Recolour ", *gesture, [&](Sphere& sphere) { sphere.color = sphere_.color; });
        begin_field(context_, "hidden");
        const bool toggled = ImGui::Checkbox("##hidden", &sphere_.hidden);
        note_widget(context_, "hidden");
        if (toggled) change_all(sphere_.hidden ? "Hide " : "Show ", 0, [&](Sphere& sphere) { sphere.hidden = sphere_.hidden; });
    }

private:
    void draw_name() {
        const Scene& scene = context_.document.scene();
        const auto found = scene.names.find(number_);
        const std::string old = found == scene.names.end() ? "" : found->second;
        if (!state_.name_active) state_.name = old;
        begin_field(context_, "name");
        input_text("##name", "none", state_.name);
        note_widget(context_, "name");
        state_.name_active = ImGui::IsItemActive();
        if (ImGui::IsItemDeactivated() && state_.name != old) {  // Escape gave the old name back
            context_.actions.emplace_back(EditScene{RenameSphere{number_, state_.name}, "Rename " + title_of(scene, number_)});
        }
    }

    void slider(const char* name, const SliderRange& range, double& value) {
        begin_field(context_, name);
        const SliderChange change = draw_value_slider(context_, state_.typed, name, range, value);
        if (change == SliderChange::none) return;
        const std::string title = title_of(context_.document.scene(), number_);
        // sphere_ has all that changed in this frame: leaving a typed number by a click on another slider changes two.
        context_.actions.emplace_back(EditScene{ChangeSpheres{{number_}, {sphere_}},
                                                (range.logarithmic ? "Change radius of " : "Move ") + title,
                                                change == SliderChange::dragged ? context_.gesture : 0});
    }

    // Of every selected sphere.
    template <typename Change>
    void change_all(const std::string& what, std::uint64_t gesture, const Change& change) {
        const Scene& scene = context_.document.scene();
        ChangeSpheres edit;
        edit.numbers = context_.selection.numbers();
        edit.spheres.reserve(edit.numbers.size());
        for (const std::uint32_t number : edit.numbers) {
            edit.spheres.push_back(number == number_ ? sphere_ : scene.spheres[number]);
            change(edit.spheres.back());
        }
        const std::string whom = edit.numbers.size() == 1 ? title_of(scene, number_) : in_groups(edit.numbers.size()) + " spheres";
        context_.actions.emplace_back(EditScene{std::move(edit), what + whom, gesture});
    }

    const PanelContext& context_;
    SidePanelState& state_;
    std::uint32_t number_;
    Sphere sphere_;
};

}  // namespace

void draw_sphere_editor(const PanelContext& context, SidePanelState& state) {
    const std::optional<std::uint32_t> primary = context.selection.primary();
    const std::size_t count = context.document.scene().spheres.size();
    if (state.edited != primary) {
        state.edited = primary;
        state.typed = {};
        state.name_active = false;
    }
    if (!primary || *primary >= count || context.selection.numbers().back() >= count) {
        ImGui::PushTextWrapPos();
        ImGui::TextDisabled("Click a sphere, in the picture or in the list, to change it.");
        ImGui::PopTextWrapPos();
        return;
    }
    if (const std::size_t selected = context.selection.size(); selected > 1) {
        ImGui::PushTextWrapPos();
        ImGui::TextDisabled("%s selected. Colour and hidden are set for all of them, the rest for %s.", in_groups(selected).c_str(),
                            title_of(context.document.scene(), *primary).c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::PushID(static_cast<int>(*primary));
    SphereEditor(context, state, *primary).draw();
    ImGui::PopID();
}

}  // namespace sphereview
