#include "panels/comparison.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "panels/math_text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

void go_to(const PanelContext& context, const Comparison& comparison, Pixel pixel) {
    context.actions.emplace_back(RunCommand{CommandId::go_home});
    context.actions.emplace_back(PinPixel{pixel, comparison.size});
}

void draw_difference(const PanelContext& context, const Comparison& comparison, ImTextureID difference) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float most = 18.0F * ImGui::GetFontSize();
    const auto sides = ImVec2(static_cast<float>(comparison.size.width), static_cast<float>(comparison.size.height));
    const float scale = std::min(width / sides.x, most / sides.y);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.5F * (width - scale * sides.x), 0.0F));
    ImGui::Image(difference, {scale * sides.x, scale * sides.y});
    note_widget(context, "difference");
    if (!ImGui::IsItemHovered()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const ImVec2 low = ImGui::GetItemRectMin();
    const Pixel pixel{std::clamp(static_cast<int>((mouse.x - low.x) / scale), 0, comparison.size.width - 1),
                      std::clamp(static_cast<int>((mouse.y - low.y) / scale), 0, comparison.size.height - 1)};
    ImGui::SetTooltip("pixel %d, %d: click to see why", pixel.x, pixel.y);
    if (ImGui::IsItemClicked()) go_to(context, comparison, pixel);
}

void draw_shares(const PanelContext& context, const Comparison& comparison) {
    if (!ImGui::BeginTable("shares", 3, ImGuiTableFlags_None)) return;
    const float side = ImGui::GetTextLineHeight();
    float widest = 0.0F;
    for (const Comparison::Share& share : comparison.shares) {
        widest = std::max(widest, width_of(in_groups(static_cast<std::uint64_t>(share.pixels))));
    }
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, side);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, widest);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const Comparison::Share& share : comparison.shares) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        draw_swatch(share.mark, ImGui::GetCursorScreenPos(), side, context.scale);
        ImGui::Dummy({side, side});
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(in_groups(static_cast<std::uint64_t>(share.pixels)).c_str());
        ImGui::TableNextColumn();
        draw_words(share.words);
    }
    ImGui::EndTable();
}

void draw_examples(const PanelContext& context, const Comparison& comparison) {
    for (std::size_t i = 0; i < comparison.examples.size(); ++i) {
        const Comparison::Example& example = comparison.examples[i];
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Button("Explain")) go_to(context, comparison, example.pixel);
        note_widget(context, "example " + std::to_string(i));
        explain_item("Pins this pixel in the inspector, seen by the scene's own camera");
        ImGui::SameLine();
        draw_words(example.words);
        ImGui::PopID();
    }
}

float least_side() { return 12.0F * ImGui::GetFontSize(); }

// Moves the current window to where it does not cover the place; where the area is too small for that, makes the window smaller.
// What is beside the picture stays free.
void keep_free(ImVec2 place, const Rectangle& area, float margin) {
    const ImVec2 low = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    const auto covers = [&](float left) { return place.x > left - margin && place.x < left + size.x + margin; };
    if (!covers(low.x) || place.y < low.y || place.y > low.y + size.y || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const float right = area.x + area.width - margin;
    const float bottom = area.y + area.height - margin;
    for (const float left : {area.x + margin, right - size.x}) {
        if (size.x > right - area.x || covers(left)) continue;
        ImGui::SetWindowPos({left, low.y});
        return;
    }
    const float before = place.x - area.x - 2.0F * margin;
    const float behind = right - place.x - margin;
    const float above = place.y - area.y - 2.0F * margin;
    const float below = bottom - place.y - margin;
    if (std::max(before, behind) >= least_side()) {
        ImGui::SetWindowSize({std::max(before, behind), size.y});
        ImGui::SetWindowPos({before > behind ? area.x + margin : place.x + margin, low.y});
    } else {
        ImGui::SetWindowSize({size.x, std::max({above, below, 1.0F})});
        ImGui::SetWindowPos({low.x, above > below ? area.y + margin : place.y + margin});
    }
}

}  // namespace

void draw_comparison(const PanelContext& context, const Comparison& comparison, const ImTextureID* difference,
                     const Rectangle& area, const std::optional<ImVec2>& free, bool& open) {
    const float margin = 12.0F * context.scale;
    // In a narrow picture it reaches over what is at the left of that, so that it can be read.
    const ImVec2 most{std::max(area.width - 2.0F * margin, least_side()), std::max(area.height - 2.0F * margin, 1.0F)};
    const ImVec2 size{std::min(440.0F * context.scale, most.x), std::min(620.0F * context.scale, most.y)};
    ImGui::SetNextWindowPos({area.x + area.width - margin, area.y + margin}, ImGuiCond_Appearing, {1.0F, 0.0F});
    ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
    const std::string title = as_label("Compared with " + comparison.picture) + "###comparison";
    if (ImGui::Begin(title.c_str(), &open, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse)) {
        note_rectangle(context, "comparison", ImGui::GetWindowPos(), ImGui::GetWindowSize());
        if (free) keep_free(*free, area, margin);
        draw_words(comparison.counts);
        for (const std::string& line : comparison.verdict) {
            if (&line == comparison.verdict.data()) {
                draw_colored_words(line, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
            } else {
                draw_dim_words(line);
            }
        }
        if (difference != nullptr) {
            ImGui::Spacing();
            draw_difference(context, comparison, *difference);
            ImGui::Spacing();
        }
        draw_shares(context, comparison);
        if (!comparison.examples.empty()) ImGui::Separator();
        draw_examples(context, comparison);
    }
    ImGui::End();
}

}  // namespace sphereview
