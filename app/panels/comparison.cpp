#include "panels/comparison.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "panels/math_text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

void go_to(const PanelContext& context, const ComparisonWords& comparison, Pixel pixel) {
    context.actions.emplace_back(RunCommand{CommandId::go_home});
    context.actions.emplace_back(PinPixel{pixel, comparison.size});
}

void draw_difference(const PanelContext& context, const ComparisonWords& comparison, ImTextureID difference) {
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

void draw_shares(const PanelContext& context, const ComparisonWords& comparison) {
    if (!ImGui::BeginTable("shares", 3, ImGuiTableFlags_None)) return;
    float widest = 0.0F;
    for (const ComparisonWords::Share& share : comparison.shares) {
        widest = std::max(widest, width_of(in_groups(static_cast<std::uint64_t>(share.pixels))));
    }
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ImGui::GetTextLineHeight());
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, widest);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const ComparisonWords::Share& share : comparison.shares) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        draw_swatch(context, share.mark);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(in_groups(static_cast<std::uint64_t>(share.pixels)).c_str());
        ImGui::TableNextColumn();
        draw_words(share.words);
    }
    ImGui::EndTable();
}

void draw_examples(const PanelContext& context, const ComparisonWords& comparison) {
    for (std::size_t i = 0; i < comparison.examples.size(); ++i) {
        const ComparisonWords::Example& example = comparison.examples[i];
        ImGui::PushID(static_cast<int>(i));
        const std::string help = "Pins this pixel in the inspector, seen by the scene's own camera";
        if (draw_button(context, "Explain", "example " + std::to_string(i), help)) go_to(context, comparison, example.pixel);
        ImGui::SameLine();
        draw_words(example.words);
        ImGui::PopID();
    }
}

}  // namespace

void draw_comparison(const PanelContext& context, const ComparisonWords& comparison, const ImTextureID* difference,
                     const Rectangle& area, bool& open) {
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    const std::string title = as_label("Compared with " + comparison.picture) + "###comparison";
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);  // nothing is behind its corners
    const bool drawn = ImGui::Begin(title.c_str(), &open, flags);
    ImGui::PopStyleVar();
    if (drawn) {
        note_window(context, "comparison");
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
