// Help > About.
#include "panels/menus.hpp"

#include <gtest/gtest.h>

#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

int asked = 0;

std::string many_licenses() {
    ++asked;
    std::string text = "The MIT License\n";
    for (int i = 0; i < 5000; ++i) text += "line " + std::to_string(i) + "\n";
    return text;
}

TEST(AboutPanel, TellsTheVersionTheRendererAndTheLicences) {
    About about;
    asked = 0;
    PanelHarness harness(
        [&](const PanelContext& context) { draw_about(context, about, "sphereview 1.2.3", many_licenses, "llvmpipe %s"); }, {},
        1000.0F, 900.0F);
    EXPECT_EQ(harness.vertices(), 0);
    EXPECT_EQ(asked, 0);
    about.shown = true;
    harness.redraws(4);
    const std::string text = harness.text();
    for (const char* words : {"sphereview 1.2.3", "Renderer: llvmpipe %s", "Dear ImGui"}) {
        EXPECT_NE(text.find(words), std::string::npos) << words << " is not in " << text;
    }
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(about.lines.size(), 5001U);
    EXPECT_LT(harness.vertices(), 20'000) << "what is not seen is not drawn";
    harness.click("about copy");
    EXPECT_STREQ(ImGui::GetClipboardText(),
                 ("sphereview 1.2.3\nRenderer: llvmpipe %s\nDear ImGui " + std::string(ImGui::GetVersion()) + "\n").c_str());
}

}  // namespace

}  // namespace sphereview
