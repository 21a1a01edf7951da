#include "panels/file_listing.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <tuple>
#include <utility>

#include "base/text.hpp"
#include "base/user_folders.hpp"
#include "panels/panel_context.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace fs = std::filesystem;

fs::path typed_path(std::string_view typed, const fs::path& folder) {
    std::string_view text = trimmed(typed);
    fs::path path;
    if (text == "~" || text.starts_with("~/")) {
        text.remove_prefix(text == "~" ? 1 : 2);
        path = home_folder() / path_from(text);
    } else {
        path = path_from(text);
        if (!is_network_name(path)) path = folder / path;  // an absolute path replaces the folder
    }
    path = normal_path(path);
    // "/a/b/" is the folder "/a/b".
    return path.has_filename() || !path.has_relative_path() ? path : path.parent_path();
}

namespace {

bool is_wanted(const FileEntry& entry, const std::vector<std::string>& endings, bool hidden_files) {
    if (!hidden_files && entry.name.starts_with('.')) return false;
    if (entry.is_folder || endings.empty()) return true;
    return std::ranges::any_of(endings, [&](const std::string& ending) { return has_ending(entry.name, ending); });
}

// Size and time are 0 where the file system does not know them: of a link that leads nowhere.
void add_facts(const fs::directory_entry& entry, FileEntry& found) {
    using namespace std::chrono;
    std::error_code error;
    if (!found.is_folder) found.bytes = entry.file_size(error);
    if (error) found.bytes = 0;
    const fs::file_time_type changed = entry.last_write_time(error);
    // Not every library can convert a file's time; both clocks tell the present.
    const auto ago = fs::file_time_type::clock::now() - changed;
    const auto at = system_clock::now() - duration_cast<system_clock::duration>(ago);
    if (!error) found.changed = duration_cast<seconds>(at.time_since_epoch()).count();
}

}  // namespace

void sort_entries(std::vector<FileEntry>& entries, const FileOrder& order) {
    // In lower case once for each, not once for each comparison: a folder may hold many thousands.
    struct Keyed {
        int rank;
        std::string key;
        FileEntry entry;
    };
    std::vector<Keyed> keyed;
    keyed.reserve(entries.size());
    for (FileEntry& entry : entries) {
        const int rank = !entry.is_folder ? 2 : entry.name == ".." ? 0 : 1;
        keyed.push_back({rank, lower_case(entry.name), std::move(entry)});
    }
    std::ranges::sort(keyed, [&](const Keyed& a, const Keyed& b) {
        if (a.rank != b.rank) return a.rank < b.rank;
        const auto& [x, y] = order.descending ? std::tie(b, a) : std::tie(a, b);
        if (order.by == FileColumn::size && x.entry.bytes != y.entry.bytes) return x.entry.bytes < y.entry.bytes;
        if (order.by == FileColumn::date && x.entry.changed != y.entry.changed) return x.entry.changed < y.entry.changed;
        const bool backwards = order.by == FileColumn::name && order.descending;
        return std::tie(a.key, a.entry.name) < std::tie(b.key, b.entry.name) ? !backwards : backwards;
    });
    std::ranges::transform(keyed, entries.begin(), [](Keyed& one) { return std::move(one.entry); });
}

Listing list_folder(const fs::path& folder, const std::vector<std::string>& endings, bool hidden_files) {
    Listing listing;
    if (folder.has_relative_path()) listing.entries.push_back({"..", true});
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        std::error_code unknown;  // a link that leads nowhere is a file
        FileEntry found{text_from(entry->path().filename()), entry->is_directory(unknown)};
        if (!is_wanted(found, endings, hidden_files)) continue;
        add_facts(*entry, found);
        listing.entries.push_back(std::move(found));
    }
    if (error) return {{}, "Cannot read " + text_from(folder) + ": " + error.message()};
    return listing;
}

std::string size_text(std::uint64_t bytes) {
    if (bytes < 1000) return std::to_string(bytes) + " B";
    auto value = static_cast<double>(bytes);
    const char* unit = "";
    for (const char* next : {" kB", " MB", " GB", " TB"}) {
        if (value < 999.5) break;
        value /= 1000.0;
        unit = next;
    }
    return fixed(value, value < 9.95 ? 1 : 0) + unit;
}

std::string date_text(std::int64_t seconds) {
    const auto time = static_cast<std::time_t>(seconds);
    const std::tm* local = std::localtime(&time);
    std::array<char, 32> text{};
    if (local == nullptr) return "";
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", local)};
}

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
