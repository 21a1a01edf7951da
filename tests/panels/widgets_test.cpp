#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "panels/menus.hpp"
#include "panels/ray_drawings.hpp"
#include "panels/widgets.hpp"
#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

// Of a colour, as WCAG 2.1 defines it.
double luminance(const ImVec4& color) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.x) + 0.7152 * linear(color.y) + 0.0722 * linear(color.z);
}

double contrast(const ImVec4& text, const ImVec4& ground) {
    const double lighter = std::max(luminance(text), luminance(ground));
    return (lighter + 0.05) / (std::min(luminance(text), luminance(ground)) + 0.05);
}

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

// A swatch, and the button of a colour's numbers, are seen on a panel of nearly their own colour.
TEST(Style, SwatchesStandOutFromThePanel) {
    float most = 0.0F;
    Color color{};
    bool is_field = false;
    PanelHarness harness(PanelHarness::in_window(
        [&](const PanelContext& context) {
            ImDrawList& list = *ImGui::GetWindowDrawList();
            const int before = list.VtxBuffer.Size;
            if (is_field) {
                draw_color_edit(context, "##color", color);
            } else {
                draw_swatch(color, {20.0F, 20.0F}, 15.0F, 1.0F);
            }
            const ImVec4 ground = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
            most = 0.0F;
            for (int i = before; i < list.VtxBuffer.Size; ++i) {
                const ImVec4 drawn = ImGui::ColorConvertU32ToFloat4(list.VtxBuffer[i].col);
                const auto seen = [&](float over, float below) { return drawn.w * over + (1.0F - drawn.w) * below; };
                const ImVec4 shown{seen(drawn.x, ground.x), seen(drawn.y, ground.y), seen(drawn.z, ground.z), 1.0F};
                most = std::max(most, static_cast<float>(contrast(shown, ground)));
            }
        },
        200.0F, 200.0F));
    for (const Theme theme : {Theme::dark, Theme::light}) {
        apply_style(1.0F, theme);
        color = theme == Theme::light ? Color{255, 255, 255} : Color{30, 30, 30};
        for (const bool field : {false, true}) {
            is_field = field;
            harness.redraws(2);
            EXPECT_GE(most, 3.0F) << "as WCAG asks of what is no text";
        }
    }
}

TEST(Style, TextStandsOutAsWcagAsks) {
    PanelHarness harness([](const PanelContext&) {});
    for (const Theme theme : {Theme::dark, Theme::light}) {
        apply_style(1.0F, theme);
        const auto& colors = ImGui::GetStyle().Colors;
        EXPECT_EQ(luminance(colors[ImGuiCol_WindowBg]) > 0.5, theme == Theme::light);
        for (const int ground :
             {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_MenuBarBg, ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_TitleBgActive}) {
            EXPECT_GE(contrast(colors[ImGuiCol_Text], colors[ground]), 7.0) << ImGui::GetStyleColorName(ground);
        }
        for (const int ground : {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_MenuBarBg}) {
            EXPECT_GE(contrast(colors[ImGuiCol_TextDisabled], colors[ground]), 4.5) << ImGui::GetStyleColorName(ground);
        }
        // The inspector's green, amber and red, and titles.
        for (const ImVec4& signal : {on_panel({0.40F, 0.85F, 0.45F, 1.0F}), on_panel({1.00F, 0.75F, 0.25F, 1.0F}),
                                     on_panel({1.00F, 0.42F, 0.40F, 1.0F}), colors[ImGuiCol_CheckMark]}) {
            EXPECT_GE(contrast(signal, colors[ImGuiCol_WindowBg]), 4.5);
        }
    }
}

TEST(Style, WhatIsDrawnOfASphereIsSeenInBothThemes) {
    PanelHarness harness([](const PanelContext&) {});
    Scene scene;
    for (const Color& color : {Color{255, 255, 255}, Color{255, 255, 0}, Color{200, 220, 255}, Color{0, 0, 0}, Color{0, 0, 90}}) {
        scene.spheres.push_back({{}, 1.0, color});
    }
    for (std::int32_t i = 0; i < 5; ++i) {
        apply_style(1.0F, Theme::light);
        EXPECT_GE(contrast(line_color(scene, i), {1.0F, 1.0F, 1.0F, 1.0F}), 3.0) << i;
        apply_style(1.0F, Theme::dark);
        EXPECT_GE(contrast(line_color(scene, i), {0.1F, 0.1F, 0.1F, 1.0F}), 2.0) << i;
    }
}

TEST(Fields, NoLabelIsCutOffInANarrowPanel) {
    for (const float width : {600.0F, 300.0F, 160.0F, 60.0F}) {
        SCOPED_TRACE(width);
        const std::vector<CommandButton> buttons = {{CommandId::add_sphere, "Add a sphere", "first"},
                                                    {CommandId::duplicate, "Duplicate", "second"},
                                                    {CommandId::remove, "Delete", "third"}};
        std::string text;
        PanelHarness harness(PanelHarness::in_window(
            [&](const PanelContext& context) {
                draw_command_buttons(context, buttons);
                begin_field(context, "a field");
                ImGui::InputText("##field", text.data(), 1, ImGuiInputTextFlags_ReadOnly);
                note_widget(context, "field");
            },
            width, 300.0F));
        for (const CommandButton& button : buttons) {
            const WidgetRectangle& place = harness.rectangles.at(button.widget);
            EXPECT_GE(place.right - place.left, ImGui::CalcTextSize(button.label).x) << button.label;
            EXPECT_TRUE(width < 160.0F || place.right <= width) << button.label;
        }
        const WidgetRectangle& field = harness.rectangles.at("field");
        EXPECT_EQ(field.left < ImGui::CalcTextSize("a field").x, width < 300.0F) << "below its label";
    }
}

TEST(NumberText, RoundsInDecimal) {
    EXPECT_EQ(rounded_to(12.3456, -2), 12.35);
    EXPECT_EQ(rounded_to(-0.30000000000000004, -1), -0.3);
    EXPECT_EQ(rounded_to(12345.0, 2), 12300.0);
    EXPECT_EQ(rounded_to(51.0, 2), 100.0);
    EXPECT_EQ(rounded_to(49.0, 2), 0.0);
    EXPECT_EQ(rounded_to(-700.0, 3), -1000.0);
    EXPECT_EQ(rounded_to(7.0, 3), 0.0);
    EXPECT_EQ(rounded_to(9.99, 0), 10.0);
    EXPECT_EQ(rounded_to(1e300 / 3.0, 298), 33e298);
    EXPECT_EQ(rounded_to(1.0 / 3.0, -40), 1.0 / 3.0) << "no double has more digits";
    EXPECT_EQ(rounded_to(0.0, -2), 0.0);
    EXPECT_EQ(rounded_to(1.7976931348623157e308, 307), 1.7976931348623157e308) << "not to infinity";
}

TEST(NumberText, SaysHowManyDigitsAreMeant) {
    EXPECT_EQ(last_digit(400.0, 4), -1);
    EXPECT_EQ(last_digit(0.05, 2), -3);
    EXPECT_EQ(last_digit(0.0, 4), -3);
}

TEST(NumberText, IsShort) {
    EXPECT_EQ(short_text(1.0 / 3.0), "0.3333");
    EXPECT_EQ(short_text(-0.0), "0");
    EXPECT_EQ(short_text(1e20), "1e+20");
}

}  // namespace

}  // namespace sphereview
