#include "panels/row_drag.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/text_input.hpp"

namespace sphereview {

std::size_t RowPlaces::gap_at(float y, std::size_t rows) const {
    return static_cast<std::size_t>(std::clamp(std::round((y - top) / height), 0.0, static_cast<double>(rows)));
}

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

}  // namespace sphereview
