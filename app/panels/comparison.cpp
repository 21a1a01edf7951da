#include "panels/comparison.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "panels/math_text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

void go_to(const PanelContext& context, const ComparisonWords& comparison, Pixel pixel) {
    context.actions.emplace_back(RunCommand{CommandId::go_home});
    context.actions.emplace_back(PinPixel{pixel, comparison.size});
}

void choose_picture(const PanelContext& context, ComparedPicture& shown) {
    struct View {
        ComparedPicture picture;
        const char* label;
        const char* widget;
    };
    constexpr std::array<View, 3> views = {{{ComparedPicture::difference, "Difference", "show difference"},
                                            {ComparedPicture::found, "Your picture", "show found"},
                                            {ComparedPicture::right, "Right picture", "show right"}}};
    for (const View& view : views) {
        if (&view != views.data()) same_line_for(view.label);
        if (ImGui::RadioButton(view.label, shown == view.picture)) shown = view.picture;
        note_widget(context, view.widget);
    }
}

// A ring around an example's pixel, and its number beside it, that are seen on any colour.
void mark_example(ImVec2 middle, std::size_t number, ImVec2 low, ImVec2 high, float scale) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float radius = 5.0F * scale;
    constexpr ImU32 dark = IM_COL32(0, 0, 0, 255);
    draw.AddCircle(middle, radius, dark, 24, 4.0F * scale);
    draw.AddCircle(middle, radius, pin_color, 24, 2.0F * scale);
    const std::string text = std::to_string(number);
    const ImVec2 size{width_of(text), ImGui::GetTextLineHeight()};
    const float gap = 3.0F * scale;
    const float margin = 2.0F * scale;
    // At the right and above, or where there is room.
    ImVec2 at{middle.x + radius + gap, middle.y - radius - size.y};
    if (at.x + size.x + margin > high.x) at.x = middle.x - radius - gap - size.x;
    if (at.y < low.y) at.y = middle.y + radius;
    draw.AddRectFilled({at.x - margin, at.y}, {at.x + size.x + margin, at.y + size.y}, dark, margin);
    draw.AddText(at, pin_color, text.c_str());
}

void draw_compared(const PanelContext& context, const ComparisonWords& comparison, ImTextureID picture,
                   std::optional<Pixel> pinned) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float most = 18.0F * ImGui::GetFontSize();
    const auto sides = ImVec2(static_cast<float>(comparison.size.width), static_cast<float>(comparison.size.height));
    const float scale = std::min(width / sides.x, most / sides.y);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.5F * (width - scale * sides.x), 0.0F));
    ImGui::Image(picture, {scale * sides.x, scale * sides.y});
    note_widget(context, "difference");
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const bool hovered = ImGui::IsItemHovered();
    const bool clicked = ImGui::IsItemClicked();
    const auto middle_of = [&](Pixel pixel) {
        return ImVec2(low.x + scale * (static_cast<float>(pixel.x) + 0.5F), low.y + scale * (static_cast<float>(pixel.y) + 0.5F));
    };
    for (std::size_t i = comparison.examples.size(); i-- > 0;) {
        mark_example(middle_of(comparison.examples[i].pixel), i + 1, low, high, context.scale);
    }
    if (pinned) draw_pin(*ImGui::GetWindowDrawList(), middle_of(*pinned), 14.0F, context.scale);
    if (!hovered) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Pixel pixel{std::clamp(static_cast<int>((mouse.x - low.x) / scale), 0, comparison.size.width - 1),
                      std::clamp(static_cast<int>((mouse.y - low.y) / scale), 0, comparison.size.height - 1)};
    ImGui::SetTooltip("%s\nClick to see why.", comparison.at(pixel).c_str());
    if (clicked) go_to(context, comparison, pixel);
}

void draw_shares(const PanelContext& context, const ComparisonWords& comparison) {
    if (!ImGui::BeginTable("shares", 3, ImGuiTableFlags_None)) return;
    const auto count_of = [](const ComparisonWords::Share& share) { return in_groups(static_cast<std::uint64_t>(share.pixels)); };
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ImGui::GetTextLineHeight());
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, widest_of(comparison.shares, count_of));
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const ComparisonWords::Share& share : comparison.shares) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        draw_swatch(context, share.mark);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(count_of(share).c_str());
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
        const std::string label = "Explain " + std::to_string(i + 1);
        if (draw_button(context, label.c_str(), "example " + std::to_string(i), help)) go_to(context, comparison, example.pixel);
        ImGui::SameLine();
        draw_words(example.words);
        ImGui::PopID();
    }
}

}  // namespace

void draw_comparison(const PanelContext& context, const ComparisonWords& comparison, const ImTextureID* picture,
                     std::optional<Pixel> pinned, const Rectangle& area, ComparisonView& view) {
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    const std::string title = as_label("Compared with " + comparison.picture) + "###comparison";
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);  // nothing is behind its corners
    const bool drawn = ImGui::Begin(title.c_str(), &view.open, flags);
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
        if (picture != nullptr) {
            ImGui::Spacing();
            choose_picture(context, view.picture);
            draw_compared(context, comparison, *picture, pinned);
            if (pinned)
                draw_colored_words("pinned: " + comparison.at(*pinned), on_panel(ImGui::ColorConvertU32ToFloat4(pin_color)));
            ImGui::Spacing();
        }
        draw_shares(context, comparison);
        if (!comparison.examples.empty()) ImGui::Separator();
        draw_examples(context, comparison);
    }
    ImGui::End();
}

}  // namespace sphereview
