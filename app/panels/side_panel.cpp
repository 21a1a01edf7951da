#include "panels/side_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

constexpr std::array<const char*, 3> usual_backgrounds = {"black", "white", "transparent"};
constexpr Background first_of_others = {{128, 128, 128}, false};  // until another is chosen

void change_background(const PanelContext& context, const Background& background, std::uint64_t gesture) {
    if (background == context.document.scene().background) return;
    context.actions.emplace_back(EditScene{ChangeBackground{background}, "Change background", gesture});
}

void draw_background(const PanelContext& context) {
    const Background& present = context.document.scene().background;
    const std::string spelling = to_string(present);
    const bool usual = !spelling.starts_with('#');
    begin_field(context, "background");
    const float swatch = usual ? 0.0F : ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(std::max(1.0F, ImGui::GetContentRegionAvail().x - swatch));
    std::vector<std::string> words(usual_backgrounds.begin(), usual_backgrounds.end());
    words.emplace_back("colour");
    const std::size_t colour = words.size() - 1;
    const auto chosen_now = static_cast<std::size_t>(std::ranges::find(words, usual ? spelling : "colour") - words.begin());
    if (const auto chosen = draw_choice(context, "background", words, chosen_now)) {
        Background background = first_of_others;
        if (*chosen != colour) parse_background(words[*chosen], background);
        change_background(context, background, 0);
    }
    if (usual) return;
    ImGui::SameLine(0.0F, ImGui::GetStyle().ItemInnerSpacing.x);
    Background edited = present;
    const auto gesture = draw_color_edit(context, "##background color", edited.color);
    note_widget(context, "background color");
    if (gesture) change_background(context, edited, *gesture);
}

constexpr float fewest_rows = 5.0F;

void draw_buttons(const PanelContext& context, SidePanelState& state) {
    // The command shows the selected spheres again when all of them are hidden.
    const SharedValues& shared = shared_of_selection(context, state);
    const char* hide = shared.count > 0 && shared.hidden == shared.count ? "Show###hide" : "Hide###hide";
    draw_command_buttons(context, {{CommandId::add_sphere, "Add", "add"},
                                   {CommandId::duplicate, "Duplicate", "duplicate"},
                                   {CommandId::remove, "Delete", "delete"},
                                   {CommandId::hide, hide, "hide"}});
}

// Nothing where it is not looked for yet: what was typed in this frame is in the next.
std::optional<std::vector<std::uint32_t>> filtered(const PanelContext& context, SidePanelState& state) {
    if (!is_searched(context.document, state)) return std::nullopt;
    state.search.finish(context.document.scene());
    return state.search.found();
}

void select_filtered(const PanelContext& context, SidePanelState& state) {
    auto found = filtered(context, state);
    if (!found) return;
    std::vector<std::uint32_t> numbers = std::move(*found);
    if (ImGui::GetIO().KeyCtrl) {
        const auto& others = context.selection.numbers();
        numbers.insert(numbers.begin(), others.begin(), others.end());
    }
    Selection selection;
    selection.set(std::move(numbers));
    context.actions.emplace_back(SelectSpheres{std::move(selection)});
}

void hide_filtered(const PanelContext& context, SidePanelState& state) {
    const auto found = filtered(context, state);
    if (found && !found->empty()) context.actions.emplace_back(hide_or_show(context.document.scene(), *found));
}

void draw_filter_fault(const PanelContext& context, const SidePanelState& state) {
    const bool is_wrong =
        is_searched(context.document, state) && !state.search.fault().empty() && !state.search.waits_for(context.property_names);
    if (!is_wrong) return;
    const ImVec2 place = ImGui::GetCursorScreenPos();
    ImGui::PushTextWrapPos(0.0F);
    // What the file holds besides is only read when somebody asks for it by its name.
    std::vector<std::string> unread;
    constexpr std::size_t most_listed = 12;
    for (const std::string& name : context.property_names) {
        if (find_property(context.document.scene().properties, name) == nullptr && unread.size() < most_listed)
            unread.push_back(name);
    }
    const bool lists = !state.search.unknown().empty() && !unread.empty();
    const std::string fault = state.search.fault() + (lists ? "; the file has " + listed(unread, "and") : "");
    ImGui::TextDisabled("%s", shown_text(fault).c_str());
    ImGui::PopTextWrapPos();
    note_rectangle(context, "filter fault", place, ImGui::GetItemRectSize());
}

// As much as there is room for: all of it holds for every scene.
const char* filter_hint(float width) {
    const float room = width - 2.0F * ImGui::GetStyle().FramePadding.x;
    for (const char* hint : {"Filter: name, number, radius > 2", "Filter: name, number"}) {
        if (width_of(hint) <= room) return hint;
    }
    return "Filter";
}

void draw_filter(const PanelContext& context, SidePanelState& state) {
    const float side = ImGui::GetFrameHeight();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float select = button_width("Select");
    // A condition is long: its buttons have a line of their own.
    const bool below = is_condition(state.filter);
    const float beside = below ? 0.0F : select + gap;
    const float buttons = state.filter.empty() ? 0.0F : side + gap + beside;
    const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x - buttons);
    ImGui::SetNextItemWidth(width);
    ImGui::InputTextWithHint("##filter", filter_hint(width), &state.filter);
    note_widget(context, "filter");
    if (state.filter.empty()) return;
    const auto draw_clear = [&] {
        ImGui::SameLine(0.0F, gap);
        if (draw_button(context, "x##clear filter", "clear filter", "Show all spheres", true, {side, side})) state.filter.clear();
    };
    if (below) {
        draw_clear();
    } else {
        ImGui::SameLine(0.0F, gap);
    }
    if (draw_button(context, "Select##filtered", "select filtered",
                    "Select what the filter shows; with Ctrl, besides what is selected")) {
        select_filtered(context, state);
    }
    if (!below) return draw_clear();
    ImGui::SameLine(0.0F, gap);
    if (draw_button(context, "Hide##filtered", "hide filtered", "Hide what the filter shows, or show it again", true,
                    {select, 0.0F})) {
        hide_filtered(context, state);
    }
    draw_filter_fault(context, state);
}

std::string count_in_words(const PanelContext& context, const SidePanelState& state) {
    const std::size_t count = context.document.scene().spheres.size();
    const std::string all = spheres_in_words(count);
    const std::size_t selected = context.selection.size();
    const std::string and_selected = selected > 0 ? ", " + in_groups(selected) + " selected" : "";
    if (!state.filter.empty()) {
        const std::string found = in_groups(state.search.found().size()) + " of " + all;
        return state.search.done() ? found + and_selected : found + ", " + fixed(100.0 * state.search.part(), 0) + " % looked at";
    }
    return all + and_selected;
}

// "Sphere", of a single one with its number and name; always the same widget.
std::string sphere_heading(const PanelContext& context) {
    const Scene& scene = context.document.scene();
    const auto& numbers = context.selection.numbers();
    std::string heading = "sphere";
    if (numbers.size() == 1 && has_sphere(scene, numbers.front())) heading = as_label(title_of(scene, numbers.front()));
    heading.front() = 'S';
    return heading + "###sphere";
}

// The heading of a part, noted as `part`.
bool draw_part(const PanelContext& context, SidePanelState& state, const std::string& part, const std::string& heading,
               ImGuiTreeNodeFlags flags = 0) {
    const bool again = state.toggled && state.toggled->part == part && std::exchange(state.toggled->clicked_again, false);
    if (again) ImGui::SetNextItemOpen(!state.toggled->open);
    const bool open = ImGui::CollapsingHeader(heading.c_str(), flags);
    note_widget(context, part);
    if (again) {
        state.toggled->open = open;
    } else if (ImGui::IsItemToggledOpen()) {
        state.toggled = ToggledPart{part, ImGui::GetIO().MousePos, open};
    }
    return open;
}

// Where the heading was clicked, over all that the panel has there now.
void draw_place_of_click(const PanelContext& context, std::optional<ToggledPart>& toggled) {
    if (!toggled) return;
    const float reach = std::round(4.0F * context.scale);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (std::fabs(mouse.x - toggled->at.x) > reach || std::fabs(mouse.y - toggled->at.y) > reach) return toggled.reset();
    const ImVec2 size{2.0F * reach, 2.0F * reach};
    ImGui::SetCursorScreenPos({toggled->at.x - reach, toggled->at.y - reach});
    ImGui::BeginChild("##again", size, false, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (ImGui::InvisibleButton("##again", size)) toggled->clicked_again = true;
    ImGui::EndChild();
}

}  // namespace

void draw_side_panel(const PanelContext& context, SidePanelState& state) {
    draw_buttons(context, state);
    draw_filter(context, state);
    // The list takes what the rest leaves; where that is too little, the panel scrolls.
    const float least = fewest_rows * ImGui::GetFrameHeight();
    draw_sphere_list(context, state, std::max(least, ImGui::GetContentRegionAvail().y - state.below_list));
    const float below = ImGui::GetCursorPosY();
    ImGui::TextDisabled("%s", count_in_words(context, state).c_str());
    const auto part = [&](const char* name, const std::string& heading, ImGuiTreeNodeFlags flags = 0) {
        return draw_part(context, state, name, heading, flags);
    };
    if (part("sphere", sphere_heading(context), ImGuiTreeNodeFlags_DefaultOpen)) draw_sphere_editor(context, state);
    if (part("look", "Colour and size")) draw_look_panel(context, state.look, state.numbers);
    if (part("light", "Light")) draw_light_panel(context, state);
    if (std::exchange(state.open_camera, false)) ImGui::SetNextItemOpen(true);
    if (part("camera", "Camera")) {
        draw_camera_panel(context, state);
        draw_saved_views(context, state);
    }
    if (part("scene", "Scene", ImGuiTreeNodeFlags_DefaultOpen)) draw_background(context);
    state.below_list = ImGui::GetCursorPosY() - below + ImGui::GetStyle().ItemSpacing.y;
    draw_place_of_click(context, state.toggled);
}

}  // namespace sphereview
