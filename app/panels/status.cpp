#include "panels/status.hpp"

#include <imgui.h>

#include <algorithm>
#include <initializer_list>

#include "base/text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

void draw_announcement(const PanelContext& context, const std::string& text, const Rectangle& area, const CornerMarks& marks) {
    const float margin = 16.0F * context.scale;
    const float padding = ImGui::GetStyle().WindowPadding.x;
    const float most = std::max(area.width - 2.0F * (margin + padding), 4.0F * ImGui::GetFontSize());
    const std::string safe = shown_lines(text);
    const float width = ImGui::CalcTextSize(safe.data(), safe.data() + safe.size(), false, most).x + 2.0F * padding;
    const float beside = 0.5F * (area.width - width);
    const float below =
        std::max({margin, beside < marks.left.x ? marks.left.y : 0.0F, beside < marks.right.x ? marks.right.y : 0.0F});
    ImGui::SetNextWindowPos({area.x + 0.5F * area.width, area.y + area.height - below}, ImGuiCond_Always, {0.5F, 1.0F});
    ImGui::SetNextWindowBgAlpha(0.9F);
    // NoInputs: clicks go through the announcement to the picture.
    if (ImGui::Begin("###announcement", nullptr,
                     quiet_window | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoInputs)) {
        wrapped_text(text, padding + most);
        note_window(context, "message announcement");
    }
    ImGui::End();
}

// At the picture's top, out of the way of what is looked at. Returns whether Cancel was pressed. `top`: where the box before ends;
// gets where this one does.
bool draw_work(const PanelContext& context, const char* name, const WorkShown& work, const Rectangle& area, float& top) {
    const float margin = 16.0F * context.scale;
    const float width = std::max(std::min(420.0F * context.scale, area.width - 2.0F * margin), 8.0F * ImGui::GetFontSize());
    ImGui::SetNextWindowPos({area.x + 0.5F * area.width, top + 12.0F * context.scale}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, std::max(area.height, 1.0F)});
    ImGui::SetNextWindowBgAlpha(0.9F);
    bool cancelled = false;
    if (ImGui::Begin((std::string("###") + name).c_str(), nullptr,
                     quiet_window | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoScrollbar)) {
        wrapped_text(work.text, width - ImGui::GetStyle().WindowPadding.x);
        const std::string percent = work.fraction ? std::to_string(static_cast<int>(100.0 * *work.fraction)) + " %" : "";
        ImGui::ProgressBar(static_cast<float>(work.fraction.value_or(0.0)), {-1.0F, 0.0F}, percent.c_str());
        cancelled = work.can_cancel && draw_button(context, "Cancel", std::string("cancel ") + name);
        note_window(context, std::string("message ") + name);
        top = ImGui::GetWindowPos().y + ImGui::GetWindowSize().y;
    }
    ImGui::End();
    return cancelled;
}

struct Trouble {
    const char* name;  // "scene error"
    std::string heading;
    std::string& text;
    bool log = false;
};

// Draws the heading and the button that closes. Returns whether the button was pressed.
bool draw_heading(const PanelContext& context, const Trouble& trouble) {
    const float button = button_width("Close");
    const float left = ImGui::GetCursorPosX();
    const float width = ImGui::GetContentRegionAvail().x;
    wrapped_text(trouble.heading, left + std::max(width - button - ImGui::GetStyle().ItemSpacing.x, button));
    ImGui::SameLine(left + std::max(width - button, 0.0F));
    const bool closed = ImGui::SmallButton("Close");
    note_widget(context, std::string("close ") + trouble.name);
    return closed;
}

// Draws a box with a red edge, unless there is no text. `top`: where the box before ends; gets where this one does.
void draw_trouble(const PanelContext& context, const Trouble& trouble, const Rectangle& area, float& top) {
    if (trouble.text.empty()) return;
    const float margin = 12.0F * context.scale;
    const float width = std::max(area.width - 2.0F * margin, 8.0F * ImGui::GetFontSize());
    ImGui::SetNextWindowPos({area.x + margin, top + margin});
    // The window is as high as the text, up to a part of the picture; the rest is scrolled.
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, std::max(0.45F * area.height, 6.0F * ImGui::GetFontSize())});
    ImGui::PushStyleColor(ImGuiCol_Border, ImVec4(0.88F, 0.27F, 0.25F, 1.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2.0F * context.scale);
    if (ImGui::Begin((std::string("###") + trouble.name).c_str(), nullptr, quiet_window | ImGuiWindowFlags_AlwaysAutoResize)) {
        const bool closed = draw_heading(context, trouble);
        const auto& fonts = ImGui::GetIO().Fonts->Fonts;
        const bool monospaced = trouble.log && fonts.Size > 1;
#if IMGUI_VERSION_NUM >= 19200
        if (monospaced) ImGui::PushFont(fonts[1], 0.0F);  // in the size of the other
#else
        if (monospaced) ImGui::PushFont(fonts[1]);
#endif
        // Text always leaves room for the scroll bar, or the bar would come and go.
        wrapped_text(trouble.text, width - ImGui::GetStyle().WindowPadding.x - ImGui::GetStyle().ScrollbarSize);
        if (monospaced) ImGui::PopFont();
        note_window(context, std::string("message ") + trouble.name);
        top = ImGui::GetWindowPos().y + ImGui::GetWindowSize().y;
        if (closed) trouble.text.clear();
    }
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

// As much of the text as is no wider than that, with dots where something is missing.
std::string shortened(const std::string& text, float width) {
    if (width_of(text) <= width) return text;
    constexpr const char* dots = "...";
    const float room = width - width_of(dots);
    if (room <= 0.0F) return "";
    const char* end = text.data();
    ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), room, 0.0F, text.data(), text.data() + text.size(), &end);
    return std::string(text.data(), end) + dots;
}

// Columns from left to right, each as wide as its widest text can be.
class Columns {
public:
    explicit Columns(float scale) : origin_(ImGui::GetCursorScreenPos()), gap_(24.0F * scale) {
        right_ = origin_.x + ImGui::GetContentRegionAvail().x;
    }

    // Text that is wider than its column ends in dots. `right`: numbers, whose last digits stay in place.
    void put(const std::string& text, float width, bool right = false) {
        const std::string shown = shortened(text, std::min(width, rest()));
        ImGui::SetCursorScreenPos({origin_.x + left_ + (right ? std::max(0.0F, width - width_of(shown)) : 0.0F), origin_.y});
        ImGui::TextUnformatted(shown.c_str());
        left_ += width + gap_;
    }
    // What a column of that width takes with the gap behind it.
    float with_gap(float width) const { return width + gap_; }

    float rest() const { return std::max(0.0F, right_ - origin_.x - left_); }

private:
    ImVec2 origin_;
    float gap_;
    float left_ = 0.0F;
    float right_ = 0.0F;
};

std::string spheres_text(std::size_t spheres, std::size_t hidden, std::size_t selected) {
    std::string text = counted(spheres, "sphere");
    if (hidden > 0) text += ", " + in_groups(hidden) + " hidden";
    if (selected > 0) text += ", " + in_groups(selected) + " selected";
    return text;
}

std::string pixel_text(int x, int y) { return std::to_string(x) + ", " + std::to_string(y); }

// Seconds can be anything a driver says, also before the first redraw.
std::string time_text(double seconds) { return fixed(std::clamp(seconds * 1000.0, 0.0, 99'999.9), 1) + " ms"; }

// ", charge 0.25, chain A"
std::string values_of_sphere(const Scene& scene, std::uint32_t sphere, const std::vector<std::string>& names) {
    std::string text;
    for (const Property& property : scene.properties) {
        const auto is_it = [&](const std::string& name) { return lower_case(name) == lower_case(property.name); };
        if (std::ranges::none_of(names, is_it)) continue;
        const std::string value = text_at(property, sphere);
        text += ", " + shown_text(property.name) + " " + (value.empty() ? "none" : shown_text(value));
    }
    return text;
}

std::string under_pointer(const PanelContext& context, const Status& status) {
    if (!status.pixel) return "";
    const Scene& scene = context.document.scene();
    if (!status.sphere || !has_sphere(scene, *status.sphere)) return "background";
    return title_of(scene, *status.sphere) + values_of_sphere(scene, *status.sphere, status.properties);
}

}  // namespace

CancelledWork draw_messages(const PanelContext& context, Messages& messages, const Rectangle& area, const CornerMarks& marks) {
    float below = area.y;
    for (const Trouble& trouble :
         {Trouble{"scene error", "The scene file cannot be read; the last good scene is shown.", messages.scene_error},
          {"scene gone", "The scene's file is gone: the scene is in this window alone. Saving writes the file again.",
           messages.scene_gone},
          {"shader error", "A shader does not compile; the last good one is running.", messages.shader_error, true}}) {
        draw_trouble(context, trouble, area, below);
    }
    CancelledWork cancelled;
    if (messages.work) cancelled.work = draw_work(context, "work", *messages.work, area, below);
    if (messages.film) cancelled.film = draw_work(context, "film", *messages.film, area, below);
    const std::string& told = messages.announcement.empty() ? messages.hint : messages.announcement;
    if (!told.empty()) draw_announcement(context, told, area, marks);
    return cancelled;
}

void draw_status_bar(const PanelContext& context, const Status& status) {
    const std::size_t spheres = context.document.scene().spheres.size();
    Columns columns(context.scale);
    const float renderer = std::min(width_of(status.renderer), 0.3F * columns.rest());
    const std::string counts_now = spheres_text(spheres, context.bounds.hidden, context.selection.size());
    float counts = width_of(spheres_text(spheres, std::max<std::size_t>(spheres, 1), std::max<std::size_t>(spheres, 1)));
    const float time = width_of("9,999.9 ms");
    const float step = width_of("1/16");
    const float pixel = width_of(pixel_text(99'999, 99'999));
    // Where the line is too short for all of them, what is under the pointer stays: what renders goes, then how long that took.
    const auto fit = [&](std::initializer_list<float> widths) {
        float needed = width_of("sphere 999,999");
        for (const float width : widths) needed += columns.with_gap(width);
        return needed <= columns.rest();
    };
    if (!fit({counts, pixel})) counts = width_of(counts_now);
    const bool shows_time = fit({counts, time, step, pixel});
    if (fit({renderer, counts, time, step, pixel})) columns.put(status.renderer, renderer);
    columns.put(counts_now, counts);
    if (shows_time) {
        columns.put(time_text(status.trace_seconds), time, true);
        columns.put(status.step > 1 ? "1/" + std::to_string(status.step) : "", step);
    }
    columns.put(status.pixel ? pixel_text(status.pixel->x, status.pixel->y) : "", pixel, true);
    columns.put(under_pointer(context, status), columns.rest());
}

}  // namespace sphereview
