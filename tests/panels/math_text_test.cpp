#include "panels/math_text.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "panels/widgets.hpp"
#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

TEST(MathText, WritesNumbersWithTheDigitsThatMatter) {
    EXPECT_EQ(number_text(0.0), "0");
    EXPECT_EQ(number_text(-0.0), "0");
    EXPECT_EQ(number_text(-63670.21276595745), "\u221263670.2");
    EXPECT_EQ(number_text(10679.968665119964), "10680");
    EXPECT_EQ(number_text(33955788.11113626), "33955788");
    EXPECT_EQ(number_text(2.5), "2.5");
    EXPECT_EQ(number_text(0.00123456789), "0.00123457");
    EXPECT_EQ(number_text(1.25e-7), "1.25 \u00D7 10\u207B\u2077");
    EXPECT_EQ(number_text(-1e12), "\u22121 \u00D7 10\u00B9\u00B2");
    EXPECT_EQ(number_text(1e300, 3), "1 \u00D7 10\u00B3\u2070\u2070");
    EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "(too large for a double)");
    EXPECT_EQ(vector_text({1.0, -2.0, 1.0 / 3.0}, 3), "(1, \u22122, 0.333)");
    EXPECT_EQ(digits_to_tell(1.5, 2.5), digits_that_matter);
    EXPECT_EQ(digits_to_tell(1.0000000001, 1.0000000002), 11);
    EXPECT_EQ(digits_to_tell(3.0, 3.0), digits_that_matter);
}

TEST(MathText, TypesetsWhatIsPrintedInAscii) {
    EXPECT_EQ(typeset("(m.L)^2 - L.L (m.m - r^2), t1 < 0 < t2, so-so"),
              "(m\u00B7L)\u00B2 \u2212 L\u00B7L (m\u00B7m \u2212 r\u00B2), t\u2081 < 0 < t\u2082, so-so");
}

TEST(MathText, UsesTheSignsThatTheFontHas) {
    const PanelHarness panel([](const PanelContext&) {});
    EXPECT_EQ(in_glyphs("\u221A(b\u00B2 \u2212 4ac)"), "sqrt(b\u00B2 - 4ac)");
    EXPECT_EQ(in_glyphs("t\u2081 \u2265 0, D\u00B7D, \u2016P\u2016"), "t1 >= 0, D\u00B7D, ||P||");
    EXPECT_EQ(in_glyphs("10\u207B\u2077, 10\u00B2\u00B3, 10\u00B9\u2077"), "10^-7, 10\u00B2\u00B3, 10^17");
    EXPECT_EQ(in_glyphs("K\u00FCgel \xFF"), "K\u00FCgel \xFF");
}

TEST(MathText, EndsLinesAtSpacesAlone) {
    PanelHarness panel(PanelHarness::in_window(
        [](const PanelContext&) { draw_words("point = (54.556440487172765, 44.8335104993598, 270.80160558649453)"); }, 190.0F,
        200.0F));
    const std::string text = panel.text();
    for (const char* number : {"(54.556440487172765,", "44.8335104993598,", "270.80160558649453)"}) {
        EXPECT_NE(text.find(number), std::string::npos) << text;
    }
    EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 1) << text;
}

TEST(MathText, KeepsWhatIsComparedTogether) {
    std::string words = "the discriminant is b < 0, so";
    float width = 0.0F;
    PanelHarness panel(PanelHarness::in_window(
        [&](const PanelContext&) {
            width = width_of("the discriminant is b <");
            ImGui::BeginChild("narrow", {width, 0.0F});
            draw_words(words);
            ImGui::EndChild();
        },
        400.0F, 200.0F));
    EXPECT_NE(panel.text().find("b < 0"), std::string::npos) << panel.text();
    words = "r = 195225000000000000000000000000000000000000000000";  // there is no other place
    EXPECT_NE(panel.text().find("r =\n"), std::string::npos) << panel.text();
}

}  // namespace

}  // namespace sphereview
