#include "panels/rays_panel.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

#include "base/text.hpp"
#include "panels/math_text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

std::string ordinal(int number) {
    const int last = number % 10;
    const bool teen = number % 100 / 10 == 1;
    return std::to_string(number) + (teen || last > 3 || last == 0 ? "th" : last == 1 ? "st" : last == 2 ? "nd" : "rd");
}

// The picture that the eye sees, as wide as the window.
RaysAnswer draw_picture(const PanelContext& context, const RaysFacts& facts, const RayChoice& choice, float most_height) {
    const float width = static_cast<float>(facts.size.width);
    const float height = static_cast<float>(facts.size.height);
    const float unit = std::min(ImGui::GetContentRegionAvail().x / width, most_height / height);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.5F * (ImGui::GetContentRegionAvail().x - unit * width), 0.0F));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + unit * width, low.y + unit * height};
    RaysAnswer answer;
    answer.clicked = ImGui::InvisibleButton("##picture", {unit * width, unit * height});
    answer.beside = ImGui::GetIO().KeyShift;
    note_widget(context, "rays picture");
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("What the eye sees");
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        answer.pointed = Pixel{std::clamp(static_cast<int>((mouse.x - low.x) / unit), 0, facts.size.width - 1),
                               std::clamp(static_cast<int>((mouse.y - low.y) / unit), 0, facts.size.height - 1)};
    }
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, high, IM_COL32(0, 0, 0, 110));
    if (facts.picture) draw.AddImage(*facts.picture, low, high);
    draw.PushClipRect(low, high, true);
    if (!facts.picture) {
        constexpr const char* words = "is being traced...";
        const ImVec2 room = ImGui::CalcTextSize(words);
        draw.AddText({0.5F * (low.x + high.x - room.x), 0.5F * (low.y + high.y - room.y)}, IM_COL32(255, 255, 255, 200), words);
    }
    if (facts.place) {
        const ImVec2 at{low.x + unit * static_cast<float>(facts.place->x), low.y + unit * static_cast<float>(facts.place->y)};
        if (choice.shown == RaysShown::row) draw.AddLine({low.x, at.y}, {high.x, at.y}, IM_COL32(255, 220, 90, 130), context.scale);
        draw_pin(draw, at, 10.0F, context.scale);
    }
    draw.PopClipRect();
    draw.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border));
    return answer;
}

void draw_choice(const PanelContext& context, const RaysFacts& facts, RayChoice& choice) {
    constexpr std::array<std::tuple<const char*, const char*, const char*>, 3> kinds = {{
        {"One ray", "rays one", "The pinned pixel's ray, or that of the pixel under the pointer"},
        {"Its row", "rays row", "Rays of the whole row of that pixel"},
        {"All", "rays all", "Rays of the whole picture"},
    }};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const auto& [label, widget, help] = kinds[i];
        if (i > 0) same_line_within(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + width_of(label));
        const auto shown = static_cast<RaysShown>(i);
        if (ImGui::RadioButton(label, choice.shown == shown)) choice.shown = shown;
        note_widget(context, widget);
        explain_item(help);
    }
    if (choice.shown == RaysShown::one) return;
    const auto step = [&](const char* name, const char* widget, ImGuiDir direction, bool enabled, int every, const char* help) {
        ImGui::BeginDisabled(!enabled);
        if (ImGui::ArrowButton(name, direction)) (choice.shown == RaysShown::row ? choice.in_row : choice.in_picture) = every;
        ImGui::EndDisabled();
        note_widget(context, widget);
        explain_item(help);
    };
    step("##finer", "rays finer", ImGuiDir_Left, choice.every() > facts.least_every, choice.every() / 2, "Twice as many in a row");
    ImGui::SameLine(0.0F, ImGui::GetStyle().ItemInnerSpacing.x);
    step("##coarser", "rays coarser", ImGuiDir_Right, choice.every() < facts.most_every, choice.every() * 2,
         "Half as many in a row");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(choice.every() == 1 ? "every ray" : ("every " + ordinal(choice.every()) + " ray").c_str());
    dim_text(in_groups(facts.rays) + (facts.rays == 1 ? " ray, " : " rays, ") + in_groups(facts.hits) + " of them hit");
}

}  // namespace

RaysAnswer draw_rays_panel(const PanelContext& context, const RaysFacts& facts, RayChoice& choice, const Rectangle& area) {
    const float margin = 12.0F * context.scale;
    const float width = std::min(std::max(std::min(270.0F * context.scale, 0.45F * area.width), 11.0F * ImGui::GetFontSize()),
                                 std::max(area.width - 2.0F * margin, 1.0F));
    ImGui::SetNextWindowPos({area.x + margin, area.y + margin}, ImGuiCond_Always);
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, std::max(area.height - 2.0F * margin, 1.0F)});
    ImGui::SetNextWindowBgAlpha(0.92F);
    RaysAnswer answer;
    if (ImGui::Begin("###rays", nullptr, quiet_window | ImGuiWindowFlags_AlwaysAutoResize)) {
        const float side = ImGui::GetFrameHeight();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted("Rays");
        ImGui::SameLine(ImGui::GetContentRegionAvail().x - side + ImGui::GetCursorPosX());
        if (draw_button(context, "x##rays", "rays end", "Back to the eye (Escape)", true, {side, side}))
            context.actions.emplace_back(RunCommand{CommandId::toggle_rays});
        // In a low window the picture leaves room for what is chosen, and for some words. Not for all of them: they change with the
        // pointer, and the picture below the pointer must not.
        float& choice_height = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("choice height"), 0.0F);
        const float taken = ImGui::GetCursorPosY() + choice_height + 3.0F * ImGui::GetTextLineHeightWithSpacing() + margin;
        const float most_height =
            std::clamp(area.height - 2.0F * margin - taken, 3.0F * side, std::max(0.3F * area.height, 3.0F * side));
        answer = draw_picture(context, facts, choice, most_height);
        const float before_choice = ImGui::GetCursorPosY();
        draw_choice(context, facts, choice);
        choice_height = ImGui::GetCursorPosY() - before_choice;
        draw_words(facts.meets);
        if (!facts.light.empty()) draw_dim_words(facts.light);
        draw_dim_words(facts.pinned ? "Pinned: Escape lets it go." : "A click pins the pixel.");
        answer.size = {ImGui::GetWindowSize().x + margin, ImGui::GetWindowSize().y + margin};
        note_window(context, "rays");
    }
    ImGui::End();
    return answer;
}

}  // namespace sphereview
