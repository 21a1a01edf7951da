#include "panels/menus.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "panels/file_listing.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

constexpr auto mouse_table = std::to_array<std::pair<const char*, const char*>>({
    {"Left-drag on a selected sphere", "Moves the selected spheres parallel to the screen; with Shift in depth."},
    {"Ctrl+wheel over a selected sphere", "Scales the selected spheres."},
    {"Left-drag elsewhere", "Orbits about the point under the pointer, or, beside all spheres, the middle of what is seen."},
    {"Middle-drag or Shift+left-drag", "Pans."},
    {"Right-drag or wheel", "Zooms at the pointer; out until the scene fills a quarter of the picture."},
    {"Click on a sphere", "Selects it; a click beside all spheres selects none."},
    {"Ctrl+click on a sphere", "Adds it to the selection, or takes it out."},
    {"Ctrl+left-drag", "Selects the spheres that are seen in the box; with Shift they join, or if all were selected, leave."},
    {"Double-click on a sphere", "Brings it to the middle of the picture."},
    {"Click on an end of the axes", "Looks along that axis; a drag there turns the view about its pivot."},
    {"Drag of a number", "Changes it by a part of its own size; with Shift finer, with Ctrl coarser. Escape takes it back."},
    {"Click on a number", "Types it, or a calculation such as 50+3*2."},
    {"File dropped on the window", "Opens the scene in it."},
});

// Words side by side under a title; the last column gets the width that the others leave, and a little more than the others at
// least. All lines have as many words.
void draw_table(const PanelContext& context, const std::string& title, const std::vector<std::vector<std::string>>& lines) {
    draw_title(context, title);
    const auto columns = static_cast<int>(lines.front().size());
    if (!ImGui::BeginTable(title.c_str(), columns, ImGuiTableFlags_RowBg | ImGuiTableFlags_PadOuterX)) return;
    const float most = 0.9F * ImGui::GetContentRegionAvail().x / static_cast<float>(columns);
    for (std::size_t i = 0; i + 1 < lines.front().size(); ++i) {
        const float widest = widest_of(lines, [i](const auto& words) { return words[i]; });
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, std::min(widest, most));
    }
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const auto& words : lines) {
        for (const std::string& word : words) {
            ImGui::TableNextColumn();
            wrapped_text(word);
        }
    }
    ImGui::EndTable();
}

void draw_mouse(const PanelContext& context) {
    std::vector<std::vector<std::string>> lines;
    for (const auto& [mouse, help] : mouse_table) lines.push_back({mouse, help});
    draw_table(context, "Mouse", lines);
}

// A table for each menu.
void draw_commands(const PanelContext& context) {
    std::span<const CommandInfo> commands = context.commands;
    while (!commands.empty()) {
        const std::string menu(commands.front().menu);
        std::vector<std::vector<std::string>> lines;
        for (; !commands.empty() && commands.front().menu == menu; commands = commands.subspan(1)) {
            const CommandInfo& info = commands.front();
            lines.push_back({every_shortcut(info.shortcut), std::string(info.label), std::string(info.help)});
        }
        draw_table(context, menu, lines);
    }
}

// What the menu says now: undoing and redoing name the step.
std::string label_of(const PanelContext& context, const CommandInfo& info) {
    std::string label(info.label);
    if (info.id == CommandId::undo && context.document.can_undo()) label += " " + context.document.undo_name();
    if (info.id == CommandId::redo && context.document.can_redo()) label += " " + context.document.redo_name();
    return as_label(label);
}

std::string history_text(const PanelContext& context) {
    const auto megabytes = [](std::size_t bytes) { return static_cast<double>(bytes) / 1048576.0; };
    return "History: " + fixed(megabytes(context.document.history_bytes()), 1) + " of " +
           fixed(megabytes(context.document.most_history_bytes()), 0) + " MB";
}

void draw_item(const PanelContext& context, const CommandInfo& info) {
    // The label changes with the step; what follows "###" is the same widget for ImGui all the time.
    const std::string label = label_of(context, info) + "###" + std::string(info.label);
    if (ImGui::MenuItem(label.c_str(), first_shortcut(info.shortcut).c_str(), info.checked, info.enabled)) {
        context.actions.emplace_back(RunCommand{info.id});
    }
    note_widget(context, "item " + std::string(info.label));
}

// How much of what the steps to undo may take is used.
void draw_history(const PanelContext& context) {
    ImGui::MenuItem((history_text(context) + "###history").c_str(), nullptr, false, false);
    note_widget(context, "history");
    explain_item("What the steps to undo take; beyond that the oldest are forgotten.");
}

// Notes a menu's title before it is drawn: ImGui's last item is another once the menu is open.
void note_menu(const PanelContext& context, const std::string& name) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    note_rectangle(context, "menu " + name, low, {ImGui::CalcTextSize(name.c_str()).x, ImGui::GetTextLineHeight()});
}

void draw_recent(const PanelContext& context, const std::vector<std::string>& recent, MenuKeys& keys) {
    note_menu(context, "Open recent");
    if (!ImGui::BeginMenu("Open recent", !recent.empty())) return;
    keys.in_submenu = true;
    for (std::size_t i = 0; i < recent.size(); ++i) {
        const std::filesystem::path path = path_from(recent[i]);
        ImGui::PushID(static_cast<int>(i));
        const std::string label = as_label(text_from(path.filename())) + "###recent";
        const std::string folder = shown_text(text_from(path.parent_path().filename()));
        if (ImGui::MenuItem(label.c_str(), folder.c_str())) context.actions.emplace_back(OpenFile{recent[i]});
        note_widget(context, "recent " + std::to_string(i));
        explain_item(shown_text(recent[i]));
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

void draw_views(const PanelContext& context, MenuKeys& keys) {
    const std::vector<SavedView>& views = context.document.scene().views;
    note_menu(context, "Saved views");
    if (!ImGui::BeginMenu("Saved views", !views.empty())) return;
    keys.in_submenu = true;
    for (std::size_t i = 0; i < views.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string label = as_label(views[i].name) + "###view";
        if (ImGui::MenuItem(label.c_str(), nullptr, views[i].camera == context.camera)) {
            context.actions.emplace_back(ShowView{views[i].camera});
        }
        note_widget(context, "item view " + std::to_string(i));
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

void draw_submenu(const PanelContext& context, const CommandInfo& first, MenuKeys& keys) {
    const std::string name(first.submenu);
    note_menu(context, name);
    if (!ImGui::BeginMenu(name.c_str())) return;
    keys.in_submenu = true;
    for (const CommandInfo& info : context.commands) {
        if (info.menu == first.menu && info.submenu == first.submenu) draw_item(context, info);
    }
    ImGui::EndMenu();
}

void draw_menu(const PanelContext& context, const std::string& menu, const std::vector<std::string>& recent, MenuKeys& keys,
               bool opens) {
    note_menu(context, menu);
    if (opens) ImGui::OpenPopup(menu.c_str());
    if (!ImGui::BeginMenu(menu.c_str())) return;
    keys.open = menu;
    bool first = true;
    std::string_view submenu;
    for (const CommandInfo& info : context.commands) {
        if (info.menu != menu) continue;
        if (info.separator_before && !first) ImGui::Separator();
        if (info.submenu.empty()) {
            draw_item(context, info);
        } else if (info.submenu != submenu) {
            draw_submenu(context, info, keys);
        }
        submenu = info.submenu;
        if (info.id == CommandId::file_open) draw_recent(context, recent, keys);
        if (info.id == CommandId::save_view) draw_views(context, keys);
        if (info.id == CommandId::redo) draw_history(context);
        first = false;
    }
    ImGui::EndMenu();
}

}  // namespace

void draw_help(const PanelContext& context, bool& open) {
    if (!open) return;
    if (begin_text_window(context, "Keys and mouse###help", open, {860.0F, 640.0F})) {
        draw_mouse(context);
        draw_commands(context);
    }
    ImGui::End();
}

float draw_menu_bar(const PanelContext& context, const std::vector<std::string>& recent, MenuKeys& keys) {
    if (!ImGui::BeginMainMenuBar()) return 0.0F;
    std::vector<std::string> menus;
    for (const CommandInfo& info : context.commands) {
        if (menus.empty() || menus.back() != info.menu) menus.emplace_back(info.menu);
    }
    std::string opens = keys.begins ? menus.front() : "";
    const auto open = std::ranges::find(menus, keys.open);
    if (open != menus.end() && keys.step != 0 && !keys.in_submenu) {
        const std::size_t steps = keys.step > 0 ? 1 : menus.size() - 1;
        opens = menus[(static_cast<std::size_t>(open - menus.begin()) + steps) % menus.size()];
    }
    keys = {};
    for (const std::string& menu : menus) draw_menu(context, menu, recent, keys, menu == opens);
    const float height = ImGui::GetWindowSize().y;
    ImGui::EndMainMenuBar();
    return height;
}

namespace {

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) lines.push_back(shown_text(take_line(text)));
    return lines;
}

// Only the lines that are seen are drawn: ImGui cannot draw all of so long a text.
void draw_licenses(const std::vector<std::string>& lines) {
    ImGui::BeginChild("##licences", {0.0F, 0.0F}, true);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(lines.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const std::string& line = lines[static_cast<std::size_t>(i)];
            ImGui::TextUnformatted(line.data(), line.data() + line.size());
        }
    }
    ImGui::EndChild();
}

}  // namespace

void draw_about(const PanelContext& context, About& about, const std::string& name_and_version, std::string (*licenses)(),
                const std::string& renderer) {
    if (!about.shown) return;
    if (about.lines.empty() && licenses != nullptr) about.lines = lines_of(licenses());
    if (begin_text_window(context, "About sphereview###about", about.shown, {720.0F, 560.0F})) {
        draw_heading(context, name_and_version, "Ray traced spheres, exact to the pixel");
        const std::string facts = "Renderer: " + renderer + "\nDear ImGui " + ImGui::GetVersion();
        wrapped_text(facts);
        if (draw_button(context, "Copy", "about copy", "Copies the version and the renderer, for a report")) {
            ImGui::SetClipboardText((name_and_version + "\n" + facts + "\n").c_str());
        }
        ImGui::Spacing();
        dim_text("The licences of this program and of the parts of others in it:");
        draw_licenses(about.lines);
        note_window(context, "about");
    }
    ImGui::End();
}

}  // namespace sphereview
