#include "panels/sphere_list.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/row_drag.hpp"
#include "panels/row_menu.hpp"
#include "panels/sphere_filter.hpp"
#include "panels/sphere_row.hpp"
#include "panels/text_input.hpp"

namespace sphereview {

namespace {

constexpr double rows_per_click = 3.0;  // of the wheel

void keep_list(const Document& document, SidePanelState& state) {
    if (state.filter.empty()) {
        if (!state.search.filter().empty()) state.search = {};
    } else if (state.searched_names != document.names_revision() || state.search.filter() != state.filter) {
        state.search.begin(document.scene(), state.filter);
        state.searched_names = document.names_revision();
    }
    if (!state.search.done()) state.search.go_on(document.scene());
    // A number means another sphere when others come and go.
    const std::uint64_t known = std::exchange(state.drawn_revision, document.revision());
    if (known == document.revision()) return;
    const bool order = document.changes_since(known).order;
    if (order) {
        state.anchor.reset();
        state.dragged.reset();
    }
    if (order && !state.focus_rename) state.renaming.reset();
    if (state.renaming && *state.renaming >= document.scene().spheres.size()) state.renaming.reset();
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

void toggle_hidden(const PanelContext& context, std::uint32_t number) {
    const Scene& scene = context.document.scene();
    Sphere sphere = scene.spheres[number];
    sphere.hidden = !sphere.hidden;
    context.actions.emplace_back(
        EditScene{ChangeSpheres{{number}, {sphere}}, (sphere.hidden ? "Hide " : "Show ") + title_of(scene, number)});
}

// Where a key goes to from a row; nothing if it is none of these.
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
        if (result.eye) toggle_hidden(context, number);
        if (result.pressed || (result.menu && !context.selection.contains(number))) select_row(context, state, listed, row);
        if (result.double_clicked) start_renaming(state, context.document.scene(), number);
        if (result.dragging && !state.drag_cancelled) state.dragged = number;
        opens_menu = opens_menu || result.menu;
    }
    if (opens_menu) open_row_menu();
    draw_row_menu(context, state);
    const std::optional<std::size_t> renamed =
        state.renaming && !state.focus_rename ? listed.row_of(*state.renaming) : std::nullopt;
    if (renamed && (*renamed < first || *renamed >= last)) accept_name(context, state);
}

}  // namespace

void draw_sphere_list(const PanelContext& context, SidePanelState& state, float height) {
    const Scene& scene = context.document.scene();
    keep_list(context.document, state);
    if (state.focus_rename && state.renaming && !state.filter.empty() &&
        !std::ranges::binary_search(state.search.found(), *state.renaming)) {
        state.filter.clear();  // its row must be there
        keep_list(context.document, state);
    }
    const ListedSpheres listed(scene, state.filter.empty(), state.search.found());
    const float padding = 4.0F * context.scale;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding, padding});
    ImGui::BeginChild("spheres", {0.0F, height}, true, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    state.list_hovered = ImGui::IsWindowHovered();
    const float row_height = std::round(ImGui::GetFrameHeight());
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
        ImGui::TextDisabled("%s", scene.spheres.empty() ? "The scene has no spheres."
                                  : state.search.done() ? "No sphere matches the filter."
                                                        : "Looking...");
    } else {
        draw_rows(context, state, listed, places);
    }
    handle_keys(context, state, listed, seen);
    const std::optional<std::uint32_t> shown = state.focus_rename ? state.renaming : context.selection.primary();
    if (state.focus_rename || state.scroll_to_selection) {
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
    if (number >= scene.spheres.size()) return;
    const auto name = scene.names.find(number);
    state.renaming = number;
    state.new_name = name == scene.names.end() ? "" : name->second;
    state.focus_rename = true;
}

}  // namespace sphereview
