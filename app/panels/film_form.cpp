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

// A few values by name.
template <typename Value, typename Words>
void draw_choice(const PanelContext& context, const char* name, Value& value, const std::vector<Value>& values,
                 const Words& words) {
    float widest = 0.0F;
    for (const Value& one : values) widest = std::max(widest, width_of(words(one)));
    ImGui::SetNextItemWidth(widest + 2.0F * ImGui::GetFrameHeight());
    const std::string widget = std::string("film ") + name;
    const bool open = ImGui::BeginCombo((std::string("##") + name).c_str(), std::string(words(value)).c_str());
    note_widget(context, widget);
    if (!open) return;
    for (const Value& one : values) {
        if (ImGui::Selectable(std::string(words(one)).c_str(), one == value)) value = one;
        note_widget(context, widget + " " + std::string(words(one)));
    }
    ImGui::EndCombo();
}

void draw_frames(const PanelContext& context, FilmForm& form) {
    ImGui::Checkbox("Frames", &form.chosen.takes_frames);
    note_widget(context, "film takes frames");
    explain_item("The frames of the scene's file, one after the other");
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
        ImGui::Checkbox("Turntable", &form.chosen.turns);
        note_widget(context, "film turns");
        explain_item("The view goes round, also while frames run");
        ImGui::SameLine(left_of_film_fields());
    } else {
        label("Turntable");
    }
    ImGui::BeginDisabled(!form.turns());
    draw_whole(context, "turntable", form.chosen.turntable, 72.0F);
    ImGui::SameLine();
    ImGui::TextUnformatted("pictures around");
    ImGui::SameLine();
    const std::vector<TurnAxis> axes = {TurnAxis::up, TurnAxis::x, TurnAxis::y, TurnAxis::z};
    draw_choice(context, "axis", form.chosen.axis, axes,
                [](TurnAxis axis) { return turn_axis_names.at(static_cast<std::size_t>(axis)); });
    explain_item("The axis: up is the view's own upward direction, x, y and z are the scene's");
    ImGui::EndDisabled();
}

void draw_quality(const PanelContext& context, FilmForm& form) {
    label("Samples");
    draw_choice(context, "samples", form.chosen.samples, std::vector<int>(sample_choices.begin(), sample_choices.end()),
                [](int samples) { return std::to_string(samples); });
    explain_item("Points of each pixel");
    if (form.judged.is_film) {
        ImGui::SameLine(0.0F, 2.0F * ImGui::GetFontSize());
        draw_text_field(context, "rate", form.chosen.rate, 88.0F);
        explain_item("A whole number, or a fraction such as 30000/1001");
        ImGui::SameLine();
        ImGui::TextUnformatted("pictures a second");
    }
    if (form.judged.has_quality) {
        ImGui::SameLine(0.0F, 2.0F * ImGui::GetFontSize());
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
    if (ImGui::Checkbox("Transparent background", &transparent)) form.chosen.transparent = transparent;
    note_widget(context, "film transparent");
    explain_item(form.judged.has_alpha ? "Where no sphere is, nothing is"
                                       : "Animated PNG, Matroska and pictures can be transparent");
    ImGui::EndDisabled();
    if (form.marks.empty()) return;
    ImGui::SameLine(0.0F, 2.0F * ImGui::GetFontSize());
    ImGui::Checkbox(("With " + form.marks).c_str(), &form.chosen.marks);
    note_widget(context, "film marks");
    explain_item("What the window shows over its picture");
}

// What the pictures show, in a line.
const std::string& applies(const FilmForm& form) { return form.takes_frames() ? form.from_file : form.from_window; }

float wrapped_height(const std::string& text, float width) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size(), false, width).y;
}

}  // namespace

float left_of_film_fields() {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float box = ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + width_of("Turntable");
    return style.WindowPadding.x + std::max(width_of("Size in pixels"), box) + style.ItemSpacing.x;
}

float height_of_film_form(const FilmForm& form, float width) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float lines = form.frames > 1 ? 4.0F : 3.0F;
    const std::string& longer =
        wrapped_height(form.from_file, width) > wrapped_height(form.from_window, width) ? form.from_file : form.from_window;
    return lines * ImGui::GetFrameHeightWithSpacing() + wrapped_height(longer, width) + style.ItemSpacing.y +
           ImGui::GetTextLineHeightWithSpacing();
}

void judge(FilmForm& form, const std::string& path) {
    const bool frames_found = form.refresh(form);
    if (!frames_found && form.judged_choices == form.chosen && form.judged_path == path) return;
    form.judged_choices = form.chosen;
    form.judged_path = path;
    form.judged = form.judge(form, path);
}

void draw_film_form(const PanelContext& context, FilmForm& form) {
    const float top = ImGui::GetCursorPosY();
    const float height = height_of_film_form(form, ImGui::GetContentRegionAvail().x);
    if (form.frames > 1) draw_frames(context, form);
    draw_turntable(context, form);
    draw_quality(context, form);
    draw_background(context, form);
    dim_text(applies(form));
    // One of the two lines may be the longer: nothing below jumps.
    ImGui::SetCursorPosY(top + height - ImGui::GetTextLineHeightWithSpacing());
    ImGui::TextUnformatted(form.judged.summary.c_str());
    note_widget(context, "film summary");
}

}  // namespace sphereview
