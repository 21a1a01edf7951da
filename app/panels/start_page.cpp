#include "panels/start_page.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "base/path.hpp"
#include "base/user_folders.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

namespace fs = std::filesystem;

constexpr ImGuiWindowFlags start_window = quiet_window | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_AlwaysAutoResize;

constexpr std::size_t most_recent_shown = 6;

constexpr float margin_of_page = 16.0F;  // times the scale

struct Example {
    const char* file;
    const char* title;
};
constexpr auto known_examples = std::to_array<Example>({
    {"planets.toml", "Planets and their sun"},
    {"crystal.extxyz", "A crystal, atom by atom"},
    {"helix.xyz", "A peptide that folds"},
    {"packing.csv", "A packing of spheres"},
    {"input4.txt", "Spheres in the text format"},
});

// The three things to try, each a command.
struct Trial {
    CommandId command;
    const char* words;
};
constexpr auto trials = std::to_array<Trial>({
    {CommandId::add_sphere, "Add a sphere, drag it, change its numbers"},
    {CommandId::toggle_inspector, "Point at a pixel: why has it this colour?"},
    {CommandId::help, "See what the mouse and the keys do"},
});

// A lit ball, as circles from its edge to its highlight.
void draw_ball(ImVec2 middle, float radius, const ImVec4& color) {
    constexpr int circles = 28;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    for (int i = 0; i < circles; ++i) {
        const float part = static_cast<float>(i) / static_cast<float>(circles - 1);
        const float light = 0.28F + 0.92F * part;
        const float white = 0.55F * part * part * part * part;
        const auto channel = [&](float own) { return std::min(own * light + white, 1.0F); };
        const ImVec4 ring(channel(color.x), channel(color.y), channel(color.z), 1.0F);
        const float away = 0.42F * radius * part;
        draw->AddCircleFilled(ImVec2(middle.x - 0.7F * away, middle.y - away), radius * (1.0F - 0.94F * part),
                              ImGui::GetColorU32(ring), 48);
    }
}

// Three balls, the program's name and what it does.
void draw_name(const PanelContext& context) {
    const float height = 3.4F * ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const auto ball = [&](float across, float down, float radius, const ImVec4& color) {
        draw_ball({low.x + across * height, low.y + down * height}, radius * height, color);
    };
    // Where there is no room for both, the name alone stays.
    const bool balls = ImGui::GetContentRegionAvail().x >= 1.5F * height + name_size * width_of("sphereview");
    if (balls) {
        ball(0.95F, 0.36F, 0.26F, {0.95F, 0.62F, 0.22F, 1.0F});
        ball(0.50F, 0.50F, 0.42F, {0.26F, 0.52F, 0.90F, 1.0F});
        ball(1.02F, 0.74F, 0.18F, {0.86F, 0.30F, 0.30F, 1.0F});
    }
    const float left = ImGui::GetCursorPosX() + (balls ? 1.5F * height : 0.0F);
    const float top = ImGui::GetCursorPosY();
    ImGui::SetCursorPos({left, top + (balls ? 0.1F * height : 0.0F)});
    draw_heading(context, "sphereview", "Ray traced spheres, exact to the pixel");
    if (balls) ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), top + height + 4.0F * context.scale));
}

// The rows of the page, from top to bottom: the pointer and the arrow keys choose among the same ones.
class Rows {
public:
    Rows(const PanelContext& context, StartPage& page, bool has_keys) : context_(context), page_(page), has_keys_(has_keys) {}

    // Draws words at the left and dimmed ones at the right end. Returns whether the row was clicked or taken with Enter.
    bool add(const std::string& words, const std::string& more, const std::string& widget) {
        const bool chosen = page_.chosen == count_;
        ImGui::PushID(count_);
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        const float inset = 6.0F * context_.scale;
        // Where there is no room for both, the words alone stay, on as many lines as they need.
        const bool fits = !more.empty() && width_of(words) + width_of(more) + 3.0F * inset <= width;
        const float right = fits ? width_of(more) : 0.0F;
        const float room = std::max(width - right - 3.0F * inset, 1.0F);
        const float lines = ImGui::CalcTextSize(words.c_str(), nullptr, false, room).y - ImGui::GetTextLineHeight();
        const float height = row_height() + std::max(lines, 0.0F);
        // As in the list of spheres, one right below the other.
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.0F});
        const bool clicked = ImGui::Selectable("##row", chosen, 0, {width, height});
        ImGui::PopStyleVar();
        note_widget(context_, widget);
        ImGui::PopID();
        put({low.x + inset, low.y}, room, words, ImGuiCol_Text);
        if (fits) put({low.x + width - right - inset, low.y}, right, more, ImGuiCol_TextDisabled);
        ++count_;
        return clicked || (chosen && has_keys_ && key_pressed(ImGuiKey_Enter));
    }

    // Moves the choice for the next redraw.
    void move() {
        if (!has_keys_) return;
        if (key_pressed(ImGuiKey_DownArrow)) page_.chosen = std::min(page_.chosen + 1, count_ - 1);
        if (key_pressed(ImGuiKey_UpArrow)) page_.chosen = std::max(page_.chosen - 1, 0);
    }

private:
    // Wrapped; a hair wider than it was measured, so that rounding breaks no line.
    static void put(ImVec2 low, float width, const std::string& text, ImGuiCol color) {
        const float down = 0.5F * (row_height() - ImGui::GetTextLineHeight());
        ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x, low.y + std::max(down, 0.0F)},
                                            ImGui::GetColorU32(color), text.c_str(), nullptr, width + 1.0F);
    }

    const PanelContext& context_;
    StartPage& page_;
    bool has_keys_;
    int count_ = 0;
};

void draw_recent(const PanelContext& context, Rows& rows, const std::vector<std::string>& recent) {
    draw_title(context, "Recent");
    if (recent.empty()) dim_text("What you open will stand here.");
    for (std::size_t i = 0; i < std::min(recent.size(), most_recent_shown); ++i) {
        const fs::path path = path_from(recent[i]);
        const std::string folder = shown_text(text_from(path.parent_path().filename()));
        if (rows.add(shown_text(text_from(path.filename())), folder, "start recent " + std::to_string(i)))
            context.actions.emplace_back(OpenFile{recent[i]});
    }
}

void draw_examples(const PanelContext& context, Rows& rows, const StartPage& page) {
    if (page.examples.empty()) return;
    draw_title(context, "Examples");
    for (std::size_t i = 0; i < page.examples.size(); ++i) {
        const ExampleScene& example = page.examples[i];
        const std::string file = text_from(path_from(example.path).filename());
        if (rows.add(example.title, file, "start example " + std::to_string(i)))
            context.actions.emplace_back(OpenFile{example.path});
    }
}

void draw_trials(const PanelContext& context, Rows& rows) {
    draw_title(context, "Three things to try");
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const std::string keys = first_shortcut(info_of(context.commands, trials[i].command).shortcut);
        if (rows.add(trials[i].words, keys, "start command " + std::to_string(i)))
            context.actions.emplace_back(RunCommand{trials[i].command});
    }
}

}  // namespace

std::vector<ExampleScene> example_scenes() {
    std::error_code none;
    fs::path folder = share_folder();
    if (!folder.empty()) {
        folder /= "scenes";
    } else {
        constexpr int most_above = 4;
        fs::path above = program_file().parent_path();
        for (int i = 0; i < most_above && !fs::exists(above / "scenes" / known_examples[0].file, none); ++i)
            above = above.parent_path();
        folder = above / "scenes";
    }
    std::vector<ExampleScene> found;
    for (const Example& example : known_examples) {
        const fs::path file = folder / example.file;
        if (fs::is_regular_file(file, none)) found.push_back({text_from(file), example.title});
    }
    return found;
}

float start_page_room(const PanelContext& context) {
    return std::max(440.0F * context.scale, 29.0F * ImGui::GetFontSize()) + 2.0F * margin_of_page * context.scale;
}

void draw_start_page(const PanelContext& context, StartPage& page, const std::vector<std::string>& recent, const Rectangle& area,
                     bool has_keys) {
    const float margin = margin_of_page * context.scale;
    const float width = std::min(start_page_room(context), area.width) - 2.0F * margin;
    if (width < 12.0F * ImGui::GetFontSize()) return;  // nothing could be read
    ImGui::SetNextWindowPos({std::floor(area.x + 0.5F * area.width), std::floor(area.y + 0.5F * area.height)}, ImGuiCond_Always,
                            {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, std::max(area.height - margin, 1.0F)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {20.0F * context.scale, 18.0F * context.scale});
    if (ImGui::Begin("###start page", nullptr, start_window)) {
        draw_name(context);
        Rows rows(context, page, has_keys);
        const std::string keys = first_shortcut(info_of(context.commands, CommandId::file_open).shortcut);
        if (rows.add("Drop a file here, or open one...", keys, "start open"))
            context.actions.emplace_back(RunCommand{CommandId::file_open});
        draw_recent(context, rows, recent);
        draw_examples(context, rows, page);
        draw_trials(context, rows);
        rows.move();
        note_window(context, "start page");
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace sphereview
