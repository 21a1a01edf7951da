#include "panels/film_form.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>

#include "panels/widgets.hpp"

namespace sphereview {

namespace {

constexpr std::array<int, 3> sample_choices = {1, 4, 16};
constexpr const char* frames_help =
    "all, N, A:B or A:B:STEP, with commas between. Frames are counted from 0, -1 is the last; A:B ends before B.";

void label(const char* text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ImGui::SameLine(left_of_film_fields());
}

// In the line, or where it has no room for so much, in the next below its fields.
void go_on(float needed) {
    if (!same_line_within(needed, 2.0F * ImGui::GetFontSize())) ImGui::SetCursorPosX(left_of_film_fields());
}

void draw_whole(const PanelContext& context, const char* name, std::int64_t& number, float width) {
    ImGui::SetNextItemWidth(width * context.scale);
    ImGui::InputScalar((std::string("##") + name).c_str(), ImGuiDataType_S64, &number);
    note_widget(context, std::string("film ") + name);
}

void draw_text_field(const PanelContext& context, const char* name, std::string& text, float width) {
    ImGui::SetNextItemWidth(width * context.scale);
    ImGui::InputText((std::string("##") + name).c_str(), &text);
    note_widget(context, std::string("film ") + name);
}

// As wide as its words need.
std::optional<std::size_t> draw_words_choice(const PanelContext& context, const char* name, const std::vector<std::string>& words,
                                             std::size_t present, const char* help) {
    ImGui::SetNextItemWidth(widest_of(words) + 2.0F * ImGui::GetFrameHeight());
    return draw_choice(context, std::string("film ") + name, words, present, help);
}

void draw_frames(const PanelContext& context, FilmForm& form) {
    draw_checkbox(context, "Frames", form.chosen.takes_frames, "film takes frames",
                  "The frames of the scene's file, one after the other");
    ImGui::SameLine(left_of_film_fields());
    ImGui::BeginDisabled(!form.chosen.takes_frames);
    draw_text_field(context, "frames", form.chosen.frames, 160.0F);
    explain_item(frames_help);
    ImGui::EndDisabled();
    ImGui::SameLine();
    dim_text(form.counting ? "of 0..; the file is still looked through" : "of 0.." + std::to_string(form.frames - 1));
}

void draw_turntable(const PanelContext& context, FilmForm& form) {
    if (form.frames > 1) {
        draw_checkbox(context, "Turntable", form.chosen.turns, "film turns", "The view goes round, also while frames run");
        ImGui::SameLine(left_of_film_fields());
    } else {
        label("Turntable");
    }
    ImGui::BeginDisabled(!form.turns());
    draw_whole(context, "turntable", form.chosen.turntable, 72.0F);
    ImGui::SameLine();
    ImGui::TextUnformatted("pictures around");
    go_on(5.0F * ImGui::GetFontSize());
    const std::vector<std::string> axes(turn_axis_names.begin(), turn_axis_names.end());
    const auto axis = draw_words_choice(context, "axis", axes, static_cast<std::size_t>(form.chosen.axis),
                                        "The axis: up is the view's own upward direction, x, y and z are the scene's");
    if (axis) form.chosen.axis = static_cast<TurnAxis>(*axis);
    ImGui::EndDisabled();
}

void draw_quality(const PanelContext& context, FilmForm& form) {
    label("Samples");
    std::vector<std::string> words;
    for (const int samples : sample_choices) words.push_back(std::to_string(samples));
    const auto present = std::ranges::find(sample_choices, form.chosen.samples) - sample_choices.begin();
    const auto samples = draw_words_choice(context, "samples", words, static_cast<std::size_t>(present), "Points of each pixel");
    if (samples) form.chosen.samples = sample_choices.at(*samples);
    if (form.judged.is_film) {
        constexpr float field = 88.0F;
        constexpr const char* unit = "pictures a second";
        go_on(field * context.scale + ImGui::GetStyle().ItemSpacing.x + width_of(unit));
        draw_text_field(context, "rate", form.chosen.rate, field);
        explain_item("A whole number, or a fraction such as 30000/1001");
        ImGui::SameLine();
        ImGui::TextUnformatted(unit);
    }
    if (form.judged.has_quality) {
        go_on(width_of("Quality") + 6.0F * ImGui::GetFontSize());
        ImGui::TextUnformatted("Quality");
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-1.0F);
        ImGui::SliderInt("##quality", &form.chosen.quality, 1, 100, "%d", ImGuiSliderFlags_AlwaysClamp);  // Ctrl+click: also typed
        note_widget(context, "film quality");
        explain_item("1 to 100: the better, the larger");
    }
}

void draw_background(const PanelContext& context, FilmForm& form) {
    ImGui::BeginDisabled(!form.judged.has_alpha);
    bool transparent = form.chosen.transparent && form.judged.has_alpha;
    const char* help =
        form.judged.has_alpha ? "Where no sphere is, nothing is" : "Animated PNG, Matroska and pictures can be transparent";
    if (draw_checkbox(context, "Transparent background", transparent, "film transparent", help))
        form.chosen.transparent = transparent;
    ImGui::EndDisabled();
    if (form.marks.empty()) return;
    const std::string with = "With " + form.marks;
    same_line_within(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + width_of(with), 2.0F * ImGui::GetFontSize());
    draw_checkbox(context, with, form.chosen.marks, "film marks", "What the window shows over its picture");
}

}  // namespace

float left_of_film_fields() {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float box = ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + width_of("Turntable");
    return std::max(width_of("Size in pixels"), box) + style.ItemSpacing.x;
}

void judge(FilmForm& form, const std::string& path) {
    const bool frames_found = form.refresh(form);
    if (!frames_found && form.judged_choices == form.chosen && form.judged_path == path) return;
    form.judged_choices = form.chosen;
    form.judged_path = path;
    form.judged = form.judge(form, path);
}

void draw_film_form(const PanelContext& context, FilmForm& form) {
    if (form.frames > 1) draw_frames(context, form);
    draw_turntable(context, form);
    draw_quality(context, form);
    draw_background(context, form);
    // One of the two texts may be the longer: nothing above jumps.
    const float top = ImGui::GetCursorPosY();
    const float width = ImGui::GetContentRegionAvail().x;
    dim_text(form.takes_frames() ? form.from_file : form.from_window);
    const float height = std::max(wrapped_height(form.from_file, width), wrapped_height(form.from_window, width));
    ImGui::SetCursorPosY(top + height);
    ImGui::Dummy({0.0F, 0.0F});
}

void draw_film_summary(const PanelContext& context, const FilmForm& form) {
    ImGui::TextUnformatted(form.judged.summary.c_str());
    note_widget(context, "film summary");
}

}  // namespace sphereview
