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
// Of the panel: the rest is for the parts below, so that one can be opened without moving its heading.
constexpr float most_of_panel = 0.45F;

void draw_buttons(const PanelContext& context, SidePanelState& state) {
    // The command shows the selected spheres again when all of them are hidden.
    const SharedValues& shared = shared_of_selection(context, state);
    const char* hide = shared.count > 0 && shared.hidden == shared.count ? "Show###hide" : "Hide###hide";
    draw_command_buttons(context, {{CommandId::add_sphere, "Add", "add"},
                                   {CommandId::duplicate, "Duplicate", "duplicate"},
                                   {CommandId::remove, "Delete", "delete"},
                                   {CommandId::hide, hide, "hide"}});
}

// Nothing where it is not looked for yet: what was typed in this redraw is in the next.
std::optional<std::vector<std::uint32_t>> filtered(const PanelContext& context, SidePanelState& state) {
    if (!is_searched(context.document, state)) return std::nullopt;
    state.search.finish(context.document.scene());
    return state.search.found();
}

void select_filtered(const PanelContext& context, SidePanelState& state) {
    auto numbers = filtered(context, state);
    if (!numbers) return;
    if (ImGui::GetIO().KeyCtrl) {
        const auto& others = context.selection.numbers();
        numbers->insert(numbers->begin(), others.begin(), others.end());
    }
    Selection selection;
    selection.set(std::move(*numbers));
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
    const std::string all = counted(count, "sphere");
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
    const bool clicked = ImGui::IsItemToggledOpen();
    if (again) {
        state.toggled->open = open;
    } else if (clicked) {
        state.toggled = ToggledPart{part, ImGui::GetIO().MousePos, open};
    }
    if ((again || clicked) && open) state.opened = OpenedPart{part};
    if (state.opened && state.opened->part == part) {
        state.opened->heading = ImGui::GetItemRectMin().y;
        if (!open) state.opened.reset();
    }
    return open;
}

// To be called where the part's contents end.
void end_part(SidePanelState& state, const std::string& part) {
    if (state.opened && state.opened->part == part) state.opened->end = ImGui::GetCursorScreenPos().y;
}

// The lower edge, on the screen, of what the panel can show.
float bottom_of_panel() { return ImGui::GetWindowPos().y + ImGui::GetWindowHeight(); }

// While the pointer is in the panel, or something there is held, typed or chosen, what is under it should stay.
bool is_in_use() {
    const ImVec2 low = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    return ImGui::IsMouseHoveringRect(low, {low.x + size.x, low.y + size.y}, false) || ImGui::IsAnyItemActive() ||
           ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

// How high the list is now. It has a place for each row, as far as that leaves room for what is below; where that is too much, the
// panel scrolls. While the pointer is in the panel the list only gives way, and for a part that is opened only where that has no
// room below its heading; it grows when the pointer has left.
float height_of_list(const PanelContext& context, SidePanelState& state) {
    const float least = fewest_rows * ImGui::GetFrameHeight();
    // A row more: a click there selects none.
    const float rows = (static_cast<float>(context.document.scene().spheres.size()) + 1.0F) * row_height() + 8.0F * context.scale;
    const float rest = ImGui::GetContentRegionAvail().y - state.below_list;
    if (!is_in_use() || state.list_height == 0.0F) {
        state.opened.reset();
        return std::max(least, std::min({rows, rest, most_of_panel * ImGui::GetWindowHeight()}));
    }
    if (state.opened && state.opened->redraws > 0 && state.opened->end > bottom_of_panel()) state.opened->has_room = false;
    const bool stays = state.opened && state.opened->has_room;
    return stays ? state.list_height : std::max(least, std::min(state.list_height, rest));
}

// Where the list cannot give way any more the panel scrolls to what was opened, as far as the heading stays in view.
void scroll_to_opened(std::optional<OpenedPart>& opened) {
    if (!opened) return;
    constexpr int settles_within = 4;  // redraws
    if (++opened->redraws > settles_within || opened->has_room) return;
    const float hidden = opened->end - bottom_of_panel();
    const float above = opened->heading - ImGui::GetWindowPos().y - ImGui::GetStyle().WindowPadding.y;
    const float by = std::min(hidden, above);
    if (by > 0.0F) ImGui::SetScrollY(ImGui::GetScrollY() + by);
}

// A part that was closed leaves its room until the pointer has left the panel, which would scroll under it.
void keep_scrolled() {
    const float end = ImGui::GetScrollY() + ImGui::GetWindowHeight() - ImGui::GetStyle().WindowPadding.y;
    if (ImGui::GetScrollY() == 0.0F || ImGui::GetCursorPosY() >= end || !is_in_use()) return;
    ImGui::SetCursorPosY(end - 1.0F);
    ImGui::Dummy({1.0F, 1.0F});
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
    state.list_height = height_of_list(context, state);
    draw_sphere_list(context, state, state.list_height);
    const float below = ImGui::GetCursorPosY();
    ImGui::TextDisabled("%s", count_in_words(context, state).c_str());
    const auto part = [&](const char* name, const std::string& heading, const auto& draw_contents, ImGuiTreeNodeFlags flags = 0) {
        if (!draw_part(context, state, name, heading, flags)) return;
        ImGui::PushID(name);
        draw_contents();
        ImGui::PopID();
        end_part(state, name);
    };
    part(
        "sphere", sphere_heading(context), [&] { draw_sphere_editor(context, state); }, ImGuiTreeNodeFlags_DefaultOpen);
    part("look", "Colour and size", [&] { draw_look_panel(context, state.look, state.numbers); });
    part("light", "Light", [&] { draw_light_panel(context, state); });
    if (std::exchange(state.open_camera, false)) ImGui::SetNextItemOpen(true);
    part("camera", "Camera", [&] {
        draw_camera_panel(context, state);
        draw_saved_views(context, state);
    });
    part(
        "scene", "Scene", [&] { draw_background(context); }, ImGuiTreeNodeFlags_DefaultOpen);
    state.below_list = ImGui::GetCursorPosY() - below + ImGui::GetStyle().ItemSpacing.y;
    scroll_to_opened(state.opened);
    keep_scrolled();
    draw_place_of_click(context, state.toggled);
}

}  // namespace sphereview
