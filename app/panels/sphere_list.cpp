#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "panels/listed_spheres.hpp"
#include "panels/side_panel.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

// Where rows are, in screen coordinates.
struct RowPlaces {
    double top;  // of row 0
    float left;
    float width;
    float height;  // of a row

    float of(std::size_t row) const { return static_cast<float>(top + static_cast<double>(row) * height); }
    // The row whose upper edge is nearest to y, 0..rows.
    std::size_t gap_at(float y, std::size_t rows) const {
        return static_cast<std::size_t>(std::clamp(std::round((y - top) / height), 0.0, static_cast<double>(rows)));
    }
};

// What was done with a row.
struct RowResult {
    bool eye = false;             // pressed
    bool pressed = false;         // left button, elsewhere
    bool double_clicked = false;  // likewise
    bool menu = false;            // right button
    bool dragging = false;        // the row is held and was moved
};

// Two lids and a pupil, or one closed lid.
void draw_eye(ImVec2 middle, float size, bool open, ImU32 color) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float half = 0.32F * size;
    const float line = std::max(1.0F, 0.06F * size);
    const ImVec2 left{middle.x - half, middle.y};
    const ImVec2 right{middle.x + half, middle.y};
    const auto lid = [&](float height) {
        const ImVec2 bend{middle.x, middle.y + height};
        list.AddBezierQuadratic(left, bend, right, color, line);
    };
    lid(0.36F * size);
    if (!open) return;
    lid(-0.36F * size);
    list.AddCircleFilled(middle, 0.1F * size, color);
}

// Ends the renaming that goes on.
void accept_name(const PanelContext& context, SidePanelState& state) {
    const Renaming ended = std::exchange(state.renaming, {});
    const auto number = static_cast<std::uint32_t>(*ended.of);
    const Scene& scene = context.document.scene();
    if (ended.name == name_of(scene, number)) return;
    context.actions.emplace_back(EditScene{RenameSphere{number, ended.name}, "Rename " + title_of(scene, number)});
}

void draw_name_field(const PanelContext& context, SidePanelState& state, ImVec2 place, float width) {
    ImGui::SetCursorScreenPos(place);
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2.0F * context.scale, ImGui::GetStyle().FramePadding.y});
    const bool ended = draw_renaming(context, state.renaming, "rename");
    ImGui::PopStyleVar();
    if (ended) accept_name(context, state);
}

// Hidden spheres are dimmed. A title that does not fit is cut off, and told in full by a tooltip.
void draw_words(const PanelContext& context, std::uint32_t number, ImVec2 place, float right, bool hovered) {
    const Scene& scene = context.document.scene();
    const Sphere& sphere = scene.spheres[number];
    const std::string name = name_of(scene, number);
    const std::string title = name.empty() ? title_of(scene, number) : shown_text(name);
    const std::string radius = short_text(sphere.radius);
    const float radius_left = right - ImGui::CalcTextSize(radius.c_str()).x;
    const float title_right = radius_left - ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorScreenPos(place);
    ImGui::PushClipRect(place, {std::max(place.x, title_right), place.y + ImGui::GetTextLineHeight()}, true);
    const ImVec4 color = ImGui::GetStyleColorVec4(sphere.hidden ? ImGuiCol_TextDisabled : ImGuiCol_Text);
    ImGui::TextColored(color, "%s", title.c_str());
    ImGui::PopClipRect();
    ImGui::SetCursorScreenPos({radius_left, place.y});
    ImGui::TextDisabled("%s", radius.c_str());
    if (hovered && place.x + ImGui::CalcTextSize(title.c_str()).x > title_right) ImGui::SetTooltip("%s", title.c_str());
}

// At a place in screen coordinates. Draws the field for the name instead of the title while the sphere is renamed.
RowResult draw_sphere_row(const PanelContext& context, SidePanelState& state, std::uint32_t number, ImVec2 place, ImVec2 size) {
    const Sphere& sphere = context.document.scene().spheres[number];
    const std::string row = context.rectangles != nullptr ? "row " + std::to_string(number) : "";
    const float padding = ImGui::GetStyle().FramePadding.x;
    const float line = ImGui::GetTextLineHeight();
    const float text_top = place.y + 0.5F * (size.y - line);
    RowResult result;
    ImGui::PushID(static_cast<int>(number));

    ImGui::SetCursorScreenPos(place);
    result.eye = ImGui::InvisibleButton("eye", {size.y, size.y});
    note_widget(context, row + " eye");
    const bool eye_hovered = ImGui::IsItemHovered();
    explain_item(sphere.hidden ? "Show" : "Hide");

    const bool renaming = state.renaming.of == number;
    bool hovered = eye_hovered;
    ImGui::SetCursorScreenPos({place.x + size.y, place.y});
    const ImVec2 rest{std::max(1.0F, size.x - size.y), size.y};
    if (renaming) {
        ImGui::Dummy(rest);
    } else {
        ImGui::InvisibleButton("row", rest);
        hovered = hovered || ImGui::IsItemHovered();
        result.pressed = ImGui::IsItemActivated();
        result.double_clicked = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        result.menu = ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
        result.dragging = ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left);
    }
    note_widget(context, row);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{place.x + size.x, place.y + size.y};
    if (context.selection.contains(number)) list.AddRectFilled(place, end, ImGui::GetColorU32(ImGuiCol_Header));
    if (hovered || context.hovered == number) list.AddRectFilled(place, end, ImGui::GetColorU32(ImGuiCol_HeaderHovered, 0.6F));
    if (hovered) context.hovered = number;
    draw_eye({place.x + 0.5F * size.y, place.y + 0.5F * size.y}, size.y, !sphere.hidden,
             ImGui::GetColorU32(sphere.hidden || !eye_hovered ? ImGuiCol_TextDisabled : ImGuiCol_Text));
    const ImVec2 corner{place.x + size.y + padding, text_top};
    draw_swatch(sphere.color, corner, line, context.scale, sphere.hidden ? 0.4F : 1.0F);
    const float title_left = corner.x + line + 2.0F * padding;
    if (renaming) {
        draw_name_field(context, state, {title_left, place.y + 0.5F * (size.y - ImGui::GetFrameHeight())},
                        std::max(1.0F, end.x - title_left));
    } else {
        draw_words(context, number, {title_left, text_top}, end.x - padding, hovered);
    }
    ImGui::PopID();
    return result;
}

// Draws a line where the sphere that is being dragged would go, and moves the sphere there when the button goes up. Escape
// cancels.
void drag_row(const PanelContext& context, SidePanelState& state, const ListedSpheres& listed, const RowPlaces& places) {
    const bool down = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (state.dragged && key_pressed(ImGuiKey_Escape)) {
        state.dragged.reset();
        state.drag_cancelled = true;
    }
    state.drag_cancelled = state.drag_cancelled && down;
    if (!state.dragged || listed.size() == 0) return;
    const float mouse = ImGui::GetMousePos().y;
    const std::size_t gap = places.gap_at(mouse, listed.size());
    const float y = places.of(gap);
    ImGui::GetWindowDrawList()->AddLine({places.left, y}, {places.left + places.width, y}, ImGui::GetColorU32(ImGuiCol_CheckMark),
                                        2.0F * context.scale);
    const std::uint32_t from = *state.dragged;
    if (down) {
        ImGui::SetTooltip("%s", title_of(context.document.scene(), from).c_str());
        // Near the ends the list runs along.
        const double step = 20.0 * static_cast<double>(ImGui::GetIO().DeltaTime);
        const float low = ImGui::GetWindowPos().y + 0.5F * places.height;
        const float high = ImGui::GetWindowPos().y + ImGui::GetWindowHeight() - 0.5F * places.height;
        if (mouse < low) state.scroll.by(-step);
        if (mouse > high) state.scroll.by(step);
        return;
    }
    const std::uint32_t before = gap < listed.size() ? listed[gap] : listed[listed.size() - 1] + 1;
    const std::uint32_t to = before > from ? before - 1 : before;
    if (to != from)
        context.actions.emplace_back(EditScene{ReorderSphere{from, to}, "Reorder " + title_of(context.document.scene(), from)});
    state.dragged.reset();
}

constexpr const char* row_menu = "row menu";

// Returns whether the item was chosen.
bool draw_row_menu_item(const PanelContext& context, CommandId id) {
    const CommandInfo& info = info_of(context.commands, id);
    const std::string label(info.label);
    const bool chosen = ImGui::MenuItem(label.c_str(), first_shortcut(info.shortcut).c_str(), false, info.enabled);
    note_widget(context, "row menu " + label);
    return chosen;
}

// What a right click on a row offers for the selected spheres.
void draw_row_menu(const PanelContext& context, SidePanelState& state) {
    if (!ImGui::BeginPopup(row_menu)) return;
    const std::optional<std::uint32_t> primary = context.selection.primary();
    if (draw_row_menu_item(context, CommandId::rename) && primary) start_renaming(state, context.document.scene(), *primary);
    for (const CommandId id : {CommandId::duplicate, CommandId::hide, CommandId::remove, CommandId::move_up, CommandId::move_down,
                               CommandId::center_on_selection}) {
        if (id == CommandId::move_up || id == CommandId::center_on_selection) ImGui::Separator();
        if (draw_row_menu_item(context, id)) context.actions.emplace_back(RunCommand{id});
    }
    ImGui::EndPopup();
}

constexpr double rows_per_click = 3.0;  // of the wheel

std::uint64_t searched_revision(const Document& document, const SidePanelState& state) {
    return is_condition(state.filter) ? document.revision() : document.names_revision();
}

void keep_list(const PanelContext& context, SidePanelState& state) {
    const Document& document = context.document;
    if (state.filter.empty()) {
        if (!state.search.filter().empty()) state.search = {};
    } else if (!is_searched(document, state)) {
        state.search.begin(document.scene(), state.filter);
        state.searched = searched_revision(document, state);
    }
    if (state.search.waits_for(context.property_names)) context.actions.emplace_back(RequestProperties{});
    if (!state.search.done()) state.search.go_on(document.scene());
    // A number means another sphere when others come and go.
    const std::uint64_t known = std::exchange(state.drawn_revision, document.revision());
    if (known == document.revision()) return;
    const bool order = document.changes_since(known).order;
    if (order) {
        state.anchor.reset();
        state.dragged.reset();
    }
    const auto& renamed = state.renaming.of;
    if ((order && !state.renaming.focus) || (renamed && *renamed >= document.scene().spheres.size())) state.renaming = {};
}

void select_row(const PanelContext& context, SidePanelState& state, const ListedSpheres& listed, std::size_t row) {
    const std::uint32_t number = listed[row];
    const ImGuiIO& io = ImGui::GetIO();
    Selection selection = context.selection;
    const std::optional<std::size_t> from = state.anchor ? listed.row_of(*state.anchor) : std::nullopt;
    if (io.KeyShift && from) {
        std::vector<std::uint32_t> numbers = listed.between(*from, row);
        if (io.KeyCtrl) numbers.insert(numbers.end(), selection.numbers().begin(), selection.numbers().end());
        numbers.push_back(number);  // the last is the primary one
        selection.set(std::move(numbers));
    } else {
        state.anchor = number;
        if (io.KeyCtrl) {
            selection.toggle(number);
        } else {
            selection.set_only(number);
        }
    }
    context.actions.emplace_back(SelectSpheres{std::move(selection)});
}

// The row that a pressed key leads to from a row; nothing where no such key is pressed.
std::optional<std::size_t> row_for_key(std::optional<std::size_t> row, std::size_t rows, std::size_t page) {
    const std::size_t last = rows - 1;
    if (key_pressed(ImGuiKey_UpArrow)) return row && *row > 0 ? *row - 1 : 0;
    if (key_pressed(ImGuiKey_DownArrow)) return row ? std::min(*row + 1, last) : 0;
    if (key_pressed(ImGuiKey_PageUp)) return row && *row > page ? *row - page : 0;
    if (key_pressed(ImGuiKey_PageDown)) return row ? std::min(*row + page, last) : std::min(page, last);
    if (key_pressed(ImGuiKey_Home)) return 0;
    if (key_pressed(ImGuiKey_End)) return last;
    return std::nullopt;
}

void handle_keys(const PanelContext& context, SidePanelState& state, const ListedSpheres& listed, double seen) {
    state.list_has_keys = ImGui::IsWindowFocused() && !ImGui::IsAnyItemActive() && listed.size() > 0;
    if (!state.list_has_keys) return;
    const std::optional<std::uint32_t> primary = context.selection.primary();
    const std::optional<std::size_t> row = primary ? listed.row_of(*primary) : std::nullopt;
    const auto page = static_cast<std::size_t>(std::max(1.0, std::floor(seen) - 1.0));
    const std::optional<std::size_t> next = row_for_key(row, listed.size(), page);
    if (!next || ImGui::GetIO().KeyCtrl) return;  // with Ctrl the sphere itself is moved
    select_row(context, state, listed, *next);
    state.scroll.show(*next);
}

void draw_rows(const PanelContext& context, SidePanelState& state, const ListedSpheres& listed, const RowPlaces& places) {
    const double first_place = std::floor((ImGui::GetWindowPos().y - places.top) / places.height);
    const auto first = static_cast<std::size_t>(std::max(0.0, first_place));
    const std::size_t last =
        std::min(listed.size(), first + 2 + static_cast<std::size_t>(ImGui::GetWindowHeight() / places.height));
    bool opens_menu = false;
    for (std::size_t row = first; row < last; ++row) {
        const std::uint32_t number = listed[row];
        const RowResult result =
            draw_sphere_row(context, state, number, {places.left, places.of(row)}, {places.width, places.height});
        if (result.eye) context.actions.emplace_back(hide_or_show(context.document.scene(), {number}));
        if (result.pressed || (result.menu && !context.selection.contains(number))) select_row(context, state, listed, row);
        if (result.double_clicked) start_renaming(state, context.document.scene(), number);
        if (result.dragging && !state.drag_cancelled) state.dragged = number;
        opens_menu = opens_menu || result.menu;
    }
    if (opens_menu) ImGui::OpenPopup(row_menu);
    draw_row_menu(context, state);
    const std::optional<std::size_t> renamed =
        state.renaming.of && !state.renaming.focus ? listed.row_of(static_cast<std::uint32_t>(*state.renaming.of)) : std::nullopt;
    if (renamed && (*renamed < first || *renamed >= last)) accept_name(context, state);
}

}  // namespace

bool is_searched(const Document& document, const SidePanelState& state) {
    return state.search.filter() == state.filter && state.searched == searched_revision(document, state);
}

void draw_sphere_list(const PanelContext& context, SidePanelState& state, float height) {
    const Scene& scene = context.document.scene();
    keep_list(context, state);
    if (state.renaming.focus && !state.filter.empty() && !std::ranges::binary_search(state.search.found(), *state.renaming.of)) {
        state.filter.clear();  // its row must be there
        keep_list(context, state);
    }
    const ListedSpheres listed(scene, state.filter.empty(), state.search.found());
    const float padding = 4.0F * context.scale;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding, padding});
    ImGui::BeginChild("spheres", {0.0F, height}, true, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    state.list_hovered = ImGui::IsWindowHovered();
    const float row_height = sphereview::row_height();
    const float inner_height = std::max(1.0F, ImGui::GetWindowHeight() - 2.0F * padding);
    const double seen = static_cast<double>(inner_height) / row_height;
    state.scroll.set_size(listed.size(), seen);
    if (state.list_hovered && ImGui::GetIO().MouseWheel != 0.0F) {
        state.scroll.by(-rows_per_click * static_cast<double>(ImGui::GetIO().MouseWheel));
    }
    const float bar = state.scroll.is_needed() ? ImGui::GetStyle().ScrollbarSize : 0.0F;
    const double top = static_cast<double>(ImGui::GetWindowPos().y) + padding;
    const float left = ImGui::GetWindowPos().x + padding;
    const float width = std::max(1.0F, ImGui::GetWindowWidth() - 2.0F * padding - bar);
    if (bar > 0.0F) state.scroll.draw_bar(context, left + width, static_cast<float>(top), bar, inner_height);
    const RowPlaces places{top - std::round(state.scroll.above() * row_height), left, width, row_height};
    if (listed.size() == 0) {
        const char* const why = scene.spheres.empty()                            ? "The scene has no spheres."
                                : state.search.waits_for(context.property_names) ? "Reading..."
                                : !state.search.fault().empty()                  ? "The condition has a fault."
                                : state.search.done()                            ? "No sphere matches the filter."
                                                                                 : "Looking...";
        ImGui::TextDisabled("%s", why);
    } else {
        draw_rows(context, state, listed, places);
    }
    handle_keys(context, state, listed, seen);
    if (state.renaming.focus || state.scroll_to_selection) {
        const auto renamed = static_cast<std::uint32_t>(state.renaming.of.value_or(0));
        const std::optional<std::uint32_t> shown = state.renaming.focus ? renamed : context.selection.primary();
        if (const auto row = shown ? listed.row_of(*shown) : std::nullopt) state.scroll.show(*row);
        state.scroll_to_selection = false;
    }
    drag_row(context, state, listed, places);
    if (ImGui::IsWindowHovered() && !ImGui::IsAnyItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
        !context.selection.empty()) {
        context.actions.emplace_back(SelectSpheres{});
    }
    ImGui::EndChild();
}

void start_renaming(SidePanelState& state, const Scene& scene, std::uint32_t number) {
    if (has_sphere(scene, number)) state.renaming.start(number, name_of(scene, number));
}

}  // namespace sphereview
