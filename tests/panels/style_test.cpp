#include "panels/style.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "panels/help.hpp"
#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

// Of a colour, as WCAG 2.1 defines it.
double luminance(const ImVec4& color) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.x) + 0.7152 * linear(color.y) + 0.0722 * linear(color.z);
}

double contrast(const ImVec4& text, const ImVec4& ground) { return (luminance(text) + 0.05) / (luminance(ground) + 0.05); }

}  // namespace

TEST(Style, CanBeScaledAgainAndAgain) {
    PanelHarness harness([](const PanelContext&) {});
    apply_style(1.0F);
    const ImGuiStyle once = ImGui::GetStyle();
    apply_style(2.0F);
    EXPECT_EQ(ImGui::GetStyle().FramePadding.x, 2.0F * once.FramePadding.x);
    EXPECT_EQ(ImGui::GetStyle().WindowBorderSize, 2.0F);
    apply_style(1.5F);
    EXPECT_EQ(ImGui::GetStyle().WindowBorderSize, 1.0F) << "half pixels blur";
    apply_style(1.0F);
    EXPECT_EQ(ImGui::GetStyle().FramePadding.x, once.FramePadding.x);
    EXPECT_EQ(ImGui::GetStyle().WindowRounding, once.WindowRounding);
    EXPECT_EQ(ImGui::GetStyle().WindowBorderSize, 1.0F);
}

TEST(Style, TextStandsOutAsWcagAsks) {
    PanelHarness harness([](const PanelContext&) {});
    apply_style(1.0F);
    const auto& colors = ImGui::GetStyle().Colors;
    for (const int ground :
         {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_MenuBarBg, ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_TitleBgActive}) {
        EXPECT_GE(contrast(colors[ImGuiCol_Text], colors[ground]), 7.0) << ImGui::GetStyleColorName(ground);
    }
    for (const int ground : {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_MenuBarBg}) {
        EXPECT_GE(contrast(colors[ImGuiCol_TextDisabled], colors[ground]), 4.5) << ImGui::GetStyleColorName(ground);
    }
}

}  // namespace sphereview
