#include "panels/look_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "look/sizes.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

constexpr std::size_t most_used = 16;
// Values of LookPanelState::size_by beside names of properties; no property has such a name. In the order of RadiiKind.
constexpr std::array<const char*, 3> radii_words = {"covalent radii", "van der Waals radii", "ionic radii"};

// An edit of the spheres that `change` gives another value. The others are left out, because an edit keeps the former values.
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
        shown_coloring(context_.document, state_);  // an undo may have brought others back
        if (choose("colour by", "the file's colours", state_.colors.property, color_choices(), own_colors_known())) {
            state_.colors.range.reset();
            state_.colors.log = false;
            state_.recolors = !state_.colors.property.empty();
            state_.own.colors_chosen = !state_.recolors;
            if (!state_.recolors) restore_colors();
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
                const auto gesture = draw_look_range(context_, state_, numbers_, *values);
                if (gesture) recolor(*gesture);
                // Only a logarithm may be impossible.
                if (gesture && !state_.fault.empty()) state_.colors.log = false;
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

    std::vector<std::string> color_choices() const {
        std::vector<std::string> names(context_.property_names.begin(), context_.property_names.end());
        for (const Property& property : scene_.properties) {
            if (std::ranges::find(names, property.name) == names.end()) names.push_back(property.name);
        }
        for (const std::string_view name : own_value_names) {
            const auto same = [&](const std::string& other) { return lower_case(other) == name; };
            if (std::ranges::none_of(names, same)) names.emplace_back(name);
        }
        return names;
    }

    // No words, as far as it is known what they are; but the radii of elements, of a file of atoms.
    std::vector<std::string> size_choices() const {
        std::vector<std::string> names = color_choices();
        const auto says_elements = [](const std::string& name) {
            return std::ranges::find(element_property_names, lower_case(name)) != element_property_names.end();
        };
        const bool has_elements = find_elements(scene_) != nullptr || std::ranges::any_of(unread(), says_elements);
        std::erase_if(names, [&](const std::string& name) {
            const Property* property = find_property(scene_.properties, name);
            return property != nullptr && is_category(*property);
        });
        if (has_elements) names.insert(names.end(), radii_words.begin(), radii_words.end());
        return names;
    }

    std::vector<std::string> unread() const {
        std::vector<std::string> names(context_.property_names.begin(), context_.property_names.end());
        std::erase_if(names, [&](const std::string& name) { return find_property(scene_.properties, name) != nullptr; });
        return names;
    }

    // Returns whether another was chosen; "", said as `own`, for the spheres' own, which may be given back where that `is_known`.
    bool choose(const char* label, const char* own, std::string& property, const std::vector<std::string>& names, bool is_known) {
        begin_field(context_, label);
        const std::string shown = property.empty() ? own : as_label(shown_text(property));
        const bool open = ImGui::BeginCombo((std::string("##") + label).c_str(), shown.c_str(), ImGuiComboFlags_HeightLarge);
        note_widget(context_, label);
        if (!open) return false;
        bool chosen = false;
        const bool enabled = is_known || property.empty();
        if (ImGui::Selectable(own, property.empty(), enabled ? 0 : ImGuiSelectableFlags_Disabled)) {
            chosen = !property.empty();
            property.clear();
        }
        note_widget(context_, std::string(label) + " own");
        explain_item(enabled ? "As the file has them, or as they were before"
                             : "Spheres have come, gone or changed places since; undo, or open the file again");
        int id = 0;
        for (const std::string& name : names) {
            ImGui::PushID(id++);
            if (ImGui::Selectable(as_label(shown_text(name)).c_str(), property == name)) {
                chosen = chosen || property != name;
                property = name;
            }
            note_widget(context_, std::string(label) + " " + name);
            ImGui::PopID();
        }
        ImGui::EndCombo();
        return chosen;
    }

    bool own_is_of_scene() const { return state_.own.order == context_.document.order_revision(); }
    bool own_colors_known() const { return own_is_of_scene() && state_.own.colors.size() == scene_.spheres.size(); }
    bool own_radii_known() const { return own_is_of_scene() && state_.own.radii.size() == scene_.spheres.size(); }

    // Before a property's take their place. What a property gave is not their own.
    void remember_own() {
        OwnLook& own = state_.own;
        if (!own_is_of_scene()) own = {.order = context_.document.order_revision()};
        if (!own_colors_known() && shown_coloring(context_.document, state_) == nullptr) {
            own.colors.clear();
            for (const Sphere& sphere : scene_.spheres) own.colors.push_back(sphere.color);
        }
        if (!own_radii_known() && !state_.has_sized) {
            own.radii.clear();
            for (const Sphere& sphere : scene_.spheres) own.radii.push_back(sphere.radius);
        }
    }

    void edit(ChangeSpheres change, const std::string& name, std::uint64_t gesture) {
        if (!change.numbers.empty()) context_.actions.emplace_back(EditScene{std::move(change), name, gesture, true});
    }

    void restore_colors() {
        state_.fault.clear();
        edit(changed(scene_, [&](Sphere& sphere, std::size_t i) { sphere.color = state_.own.colors[i]; }), "Own colours", 0);
    }

    void restore_radii() {
        state_.has_sized = false;
        edit(changed(scene_, [&](Sphere& sphere, std::size_t i) { sphere.radius = state_.own.radii[i]; }), "Own sizes", 0);
    }

    void recolor(std::uint64_t gesture) {
        state_.fault.clear();
        Property own;
        const Property* values = find_values(scene_, state_.colors.property, own);
        if (values == nullptr) return;
        try {
            const Coloring coloring = coloring_of(scene_, *values, state_.colors);
            const std::vector<Color> colors = colors_of(*values, coloring);
            remember_own();
            note_colors(state_, {state_.colors, coloring, gesture});
            edit(changed(scene_, [&](Sphere& sphere, std::size_t i) { sphere.color = colors[i]; }),
                 "Colour by " + in_quotes(values->name), gesture);
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

    void draw_sizes() {
        if (choose("size by", "the file's sizes", state_.size_by, size_choices(), own_radii_known())) {
            state_.resizes = !state_.size_by.empty();
            state_.own.sizes_chosen = !state_.resizes;
            if (!state_.resizes) restore_radii();
        }
        if (const auto kind = chosen_radii(state_)) return use(*kind);
        Property own;
        const Property* values = chosen(state_.size_by, own, state_.resizes);
        if (values == nullptr || is_category(*values)) return;
        if (std::exchange(state_.resizes, false)) {
            state_.scale = usual_scale(scene_, *values).value_or(1.0);
            resize(*values, 0);
        }
        const NumberRule rule{.above_zero = true, .help = "The radius of a value of 1"};
        const NumberChange change = draw_number_line(context_, numbers_, "scale", rule, state_.scale);
        if (change != NumberChange::none) resize(*values, change == NumberChange::dragged ? context_.gesture : 0);
    }

    void resize(const Property& values, std::uint64_t gesture) {
        std::vector<Sphere> sized = scene_.spheres;
        size_by(sized, values, state_.scale);
        give_radii(sized, "Size by " + in_quotes(values.name), gesture);
    }

    // The elements' radii, once it is read which they are.
    void use(RadiiKind kind) {
        if (!state_.resizes) return;
        const Property* elements = find_elements(scene_);
        if (elements == nullptr) {
            if (unread().empty()) {
                state_.size_by.clear();
                state_.resizes = false;
            } else {
                context_.actions.emplace_back(RequestProperties{});
            }
            return;
        }
        state_.resizes = false;
        std::vector<Sphere> sized = scene_.spheres;
        use_radii(sized, *elements, kind);
        give_radii(sized, std::string("Use ") + radii_words[static_cast<std::size_t>(kind)], 0);
    }

    void give_radii(const std::vector<Sphere>& sized, const std::string& name, std::uint64_t gesture) {
        remember_own();
        state_.has_sized = true;
        edit(changed(scene_, [&](Sphere& sphere, std::size_t i) { sphere.radius = sized[i].radius; }), name, gesture);
    }

    const PanelContext& context_;
    const Scene& scene_;
    LookPanelState& state_;
    NumberFields& numbers_;
};

}  // namespace

std::optional<RadiiKind> chosen_radii(const LookPanelState& state) {
    const auto found = std::ranges::find(radii_words, state.size_by);
    return found == radii_words.end() ? std::nullopt : std::optional(static_cast<RadiiKind>(found - radii_words.begin()));
}

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
            if (!used.coloring.is_category()) continue;
            ColorBy same = used.by;
            same.order = used.coloring.order;
            state.shown = coloring_of(document.scene(), *values, same);
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
    LookPanel(context, state, numbers).draw();
}

}  // namespace sphereview
