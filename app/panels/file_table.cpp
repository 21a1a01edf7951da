#include <imgui.h>

#include <algorithm>
#include <utility>

#include "panels/file_listing.hpp"
#include "panels/panel_context.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

void right_aligned(const std::string& text) {
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, ImGui::GetContentRegionAvail().x - width_of(text)));
    ImGui::TextUnformatted(text.c_str());
}

// How many of the columns there is room for: the names, by which files are known, come first, then the sizes, then the dates.
int columns_within(float width) {
    const float names = 13.0F * ImGui::GetFontSize();
    const float size = width_of("Size") + 2.5F * ImGui::GetFontSize();
    const float date = width_of("2026-12-28 00:00") + ImGui::GetFontSize();
    return width >= names + size + date ? 3 : width >= names + size ? 2 : 1;
}

Clicked draw_entry(const PanelContext& context, const FileEntry& entry, bool chosen, int columns) {
    Clicked clicked = Clicked::nothing;
    ImGui::TableNextColumn();
    const ImVec2 begin = ImGui::GetCursorScreenPos();
    // The name is drawn apart, because a label must not hold every character that a file's name may.
    if (ImGui::Selectable("##entry", chosen, ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_SpanAllColumns)) {
        clicked = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) ? Clicked::twice : Clicked::entry;
    }
    note_widget(context, "entry " + entry.name);
    const std::string shown = shown_text(entry.name) + (entry.is_folder ? "/" : "");
    const ImU32 color = ImGui::GetColorU32(entry.is_folder ? ImGuiCol_CheckMark : ImGuiCol_Text);
    const bool is_cut = width_of(shown) > ImGui::GetContentRegionAvail().x;
    ImGui::GetWindowDrawList()->AddText(begin, color, shown.data(), shown.data() + shown.size());
    if (is_cut) explain_item(shown);
    if (entry.name == "..") return clicked;
    if (columns >= 2) {
        ImGui::TableNextColumn();
        if (!entry.is_folder) right_aligned(size_text(entry.bytes));
    }
    if (columns >= 3) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(date_text(entry.changed).c_str());
    }
    return clicked;
}

// A click on a column's head sorts by that column; a second one the other way round.
void draw_heads(const PanelContext& context, FileBrowser& browser, int columns) {
    const ImGuiTableColumnFlags fixed_column = ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_PreferSortDescending;
    const float arrow = ImGui::GetFontSize();
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch | ImGuiTableColumnFlags_DefaultSort);
    if (columns >= 2) ImGui::TableSetupColumn("Size", fixed_column, width_of("Size") + 1.5F * arrow);
    if (columns >= 3) ImGui::TableSetupColumn("Changed", fixed_column, width_of("2026-12-28 00:00"));
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (const auto& [head, widget] : {std::pair("Name", "name"), {"Size", "size"}, {"Changed", "date"}}) {
        if (columns-- == 0) break;
        ImGui::TableNextColumn();
        ImGui::TableHeader(head);
        note_widget(context, std::string("browser sort ") + widget);
    }
    const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
    if (specs == nullptr || specs->SpecsCount == 0) return;
    const FileOrder order{static_cast<FileColumn>(specs->Specs[0].ColumnIndex),
                          specs->Specs[0].SortDirection == ImGuiSortDirection_Descending};
    if (order == browser.order) return;
    browser.order = order;
    sort_entries(browser.entries, order);
}

}  // namespace

ClickedEntry draw_entries(const PanelContext& context, FileBrowser& browser, float height) {
    ClickedEntry result;
    const ImGuiTableFlags flags = ImGuiTableFlags_Sortable | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersOuter |
                                  ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;
    const int columns = columns_within(ImGui::GetContentRegionAvail().x);
    if (!ImGui::BeginTable(("entries" + std::to_string(columns)).c_str(), columns, flags, {0.0F, height})) return result;
    if (std::exchange(browser.to_top, false)) ImGui::SetScrollY(0.0F);
    draw_heads(context, browser, columns);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(browser.entries.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const FileEntry& entry = browser.entries[static_cast<std::size_t>(i)];
            ImGui::TableNextRow();
            ImGui::PushID(i);
            const Clicked clicked = draw_entry(context, entry, !entry.is_folder && entry.name == browser.name, columns);
            ImGui::PopID();
            if (clicked != Clicked::nothing) result = {clicked, entry};
        }
    }
    ImGui::EndTable();
    return result;
}

}  // namespace sphereview
