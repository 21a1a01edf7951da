// The field of a number: what drags and what is typed make of it.
#include "panels/number_field.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "panels/widgets.hpp"
#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

struct NumberState {
    NumberFields fields;
    double value = 0.0;
    NumberRule rule;
    std::vector<NumberChange> changes;
};

// One field alone.
struct OneNumber : private NumberState, public PanelHarness {
    explicit OneNumber(double begin, const NumberRule& number_rule = {})
        : NumberState{{}, begin, number_rule, {}},
          PanelHarness(in_window(
              [this](const PanelContext& context) {
                  ImGui::SetNextItemWidth(120.0F);
                  const NumberChange change = draw_number(context, fields, "n", rule, value);
                  draw_refusal(context, fields, "n");
                  if (change != NumberChange::none) changes.push_back(change);
              },
              200.0F, 200.0F)) {}

    double number() const { return value; }
    std::size_t count(NumberChange kind) const { return static_cast<std::size_t>(std::ranges::count(changes, kind)); }
    const NumberFields& state() const { return fields; }
    // Without a tooltip, which would end it.
    std::string text_beside() {
        move({190.0F, 190.0F});
        return text();
    }

    void drag_by(float pixels) {
        const ImVec2 from = place("slider n");
        drag(from, {from.x + pixels, from.y});
    }
    void enter(const std::string& text, ImGuiKey key = ImGuiKey_Enter) {
        click("slider n");
        redraws(3);
        type(text);
        tap(key);
    }
};

double after_drag(double begin, float pixels, const NumberRule& rule = {}) {
    OneNumber field(begin, rule);
    field.drag_by(pixels);
    return field.number();
}

}  // namespace

TEST(Expression, IsWorkedOut) {
    const std::vector<std::pair<std::string, double>> cases = {{"50+3*2", 56.0},
                                                               {" ( 50 + 3 ) * 2 ", 106.0},
                                                               {"-3", -3.0},
                                                               {"2 - -3", 5.0},
                                                               {"10/4/5", 0.5},
                                                               {"7-2-1", 4.0},
                                                               {"2^3^2", 512.0},
                                                               {"-2^2", -4.0},
                                                               {"2^-1", 0.5},
                                                               {"(1+2)*(3+4)", 21.0},
                                                               {"2.5e-7", 2.5e-7},
                                                               {"1E+3", 1000.0},
                                                               {"2*10^3", 2000.0},
                                                               {".5", 0.5},
                                                               {"5.", 5.0},
                                                               {"\u22123\u00D72", -6.0},
                                                               {"-123456.7890123456", -123456.7890123456},
                                                               {"1e-999", 0.0},
                                                               {"1.7976931348623157e308", std::numeric_limits<double>::max()}};
    for (const auto& [text, expected] : cases) {
        const ExpressionValue result = evaluate(text);
        EXPECT_EQ(result.fault, "") << text;
        EXPECT_EQ(result.value, expected) << text;
    }
}

TEST(Expression, SaysWhatIsWrong) {
    const std::vector<std::pair<std::string, std::string>> cases = {{"", "a number is missing at the end"},
                                                                    {"50+", "a number is missing at the end"},
                                                                    {"(50+3", "a ')' is missing"},
                                                                    {"50+3)", "a ')' is missing its '('"},
                                                                    {"2,5", "a point is expected instead of the comma"},
                                                                    {"(2,5)", "a point is expected instead of the comma"},
                                                                    {"1 2", "an operator is missing before '2'"},
                                                                    {"2(3)", "an operator is missing before '('"},
                                                                    {"5*/2", "a number is missing before '/'"},
                                                                    {"abc+1", "'abc' is not a number"},
                                                                    {"nan", "'nan' is not a number"},
                                                                    {"inf", "'inf' is not a number"},
                                                                    {"5m", "'m' is not a number"},
                                                                    {"1e", "'1e' is not a number"},
                                                                    {"1e999", "'1e999' is too large"},
                                                                    {"1e300*1e300", "the result is too large"},
                                                                    {"1/0", "nothing can be divided by 0"},
                                                                    {"(-8)^0.5", "this power is no number"}};
    for (const auto& [text, fault] : cases) EXPECT_EQ(evaluate(text).fault, fault) << text;
    EXPECT_EQ(evaluate(std::string(100000, '(') + "1").fault, "it is nested too deep");
    EXPECT_EQ(evaluate(std::string(100000, '-') + "1").fault, "it is nested too deep");
    EXPECT_EQ(evaluate(std::string(20000, '2') + "^2").fault.substr(0, 4), "'222");
}

TEST(Expression, ANumberAloneIsNone) {
    for (const char* text : {"1", " -2.5e3 ", "1e999"}) EXPECT_FALSE(is_calculation(text)) << text;
    for (const char* text : {"1+1", "(2)", "2^2"}) EXPECT_TRUE(is_calculation(text)) << text;
}

// A drag of 100 pixels, after the 3 that belong to a click, changes a number by about its own size, whatever that is.
TEST(NumberField, ADragIsRelativeToTheNumbersOwnSize) {
    for (const double size : {1e-12, 1e-3, 1.0, 7.0, 12.5, 320.0, 1e9, 1e200}) {
        const double changed = after_drag(size, 103.0F, {.usual_size = 1e-13}) - size;
        EXPECT_GE(changed, 0.4 * size) << size;
        EXPECT_LE(changed, 1.05 * size) << size;
        EXPECT_NEAR(after_drag(-size, 103.0F, {.usual_size = 1e-13}) + size, changed, 0.02 * size) << "to the right is more";
    }
    EXPECT_EQ(after_drag(0.0, 53.0F, {.usual_size = 200.0}), 100.0) << "nothing has no size of its own";
    EXPECT_EQ(after_drag(0.0, -53.0F, {.usual_size = 200.0}), -100.0);
    EXPECT_EQ(after_drag(1.0 / 3.0, 13.0F, {.usual_size = 0.1}), 0.353) << "short numbers";
    EXPECT_NEAR(after_drag(2.0, 103.0F, {.above_zero = true}), 2.0 * std::exp(1.0), 1e-3);
    EXPECT_NEAR(after_drag(2.0, -103.0F, {.above_zero = true}), 2.0 / std::exp(1.0), 1e-3);
}

TEST(NumberField, ShiftIsFinerAndControlCoarserAlsoOnTheWay) {
    OneNumber field(100.0, {.usual_size = 1.0});
    field.modifiers(false, true);
    field.drag_by(53.0F);
    EXPECT_EQ(field.number(), 105.0);
    field.modifiers(true, false);
    field.drag_by(53.0F);
    EXPECT_EQ(field.number(), 605.0);
    field.modifiers(false);
    // With Shift from the middle of a drag on: no jump, and fine digits from there.
    const ImVec2 from = field.place("slider n");
    field.move(from);
    field.press();
    field.move({from.x + 23.0F, from.y});
    EXPECT_EQ(field.number(), 705.0);
    field.modifiers(false, true);
    EXPECT_EQ(field.number(), 705.0);
    field.move({from.x + 24.0F, from.y});
    EXPECT_EQ(field.number(), 705.5);
    field.modifiers(false);
    field.move({from.x + 25.0F, from.y});
    EXPECT_EQ(field.number(), 710.5);
    field.release();
}

TEST(NumberField, ThereAndBackIsNothing) {
    const double begin = 1.0 / 3.0;
    for (const bool above_zero : {false, true}) {
        OneNumber field(begin, {.above_zero = above_zero});
        const ImVec2 from = field.place("slider n");
        field.move(from);
        field.press();
        const auto gesture = field.gesture;
        field.move({from.x + 77.0F, from.y});
        EXPECT_NE(field.number(), begin);
        field.move({from.x - 41.0F, from.y + 200.0F});
        field.move({from.x, from.y});
        EXPECT_EQ(std::bit_cast<std::uint64_t>(field.number()), std::bit_cast<std::uint64_t>(begin));
        field.move({from.x + 50.0F, from.y});
        field.tap(ImGuiKey_Escape);
        EXPECT_EQ(field.number(), begin) << "Escape takes it back";
        field.move({from.x + 90.0F, from.y});
        EXPECT_EQ(field.number(), begin);
        field.release();
        field.redraws(2);
        EXPECT_EQ(field.number(), begin);
        EXPECT_EQ(field.gesture, gesture);
        EXPECT_EQ(field.state().typed, "") << "a drag is no click";
        field.drag_by(20.0F);
        EXPECT_EQ(field.gesture, gesture + 1);
    }
}

TEST(NumberField, DragsEndAtTheEnds) {
    const NumberRule rule{.low = -1.5, .high = 2.0};
    EXPECT_EQ(after_drag(1.0, 700.0F, rule), 2.0);
    EXPECT_EQ(after_drag(1.0, -700.0F, rule), -1.5);
    EXPECT_EQ(after_drag(1.7e308, 700.0F), std::numeric_limits<double>::max());
    const double smallest = after_drag(1e-307, -2000.0F, {.above_zero = true});
    EXPECT_TRUE(smallest > 0.0) << smallest;
    EXPECT_TRUE(std::isfinite(after_drag(1e307, 2000.0F, {.above_zero = true})));
}

TEST(NumberField, AClickTypesACalculation) {
    OneNumber field(4.0);
    field.enter("50+3*2");
    EXPECT_EQ(field.number(), 56.0);
    EXPECT_EQ(field.count(NumberChange::typed), 1U);
    field.enter("(1+2)/4", ImGuiKey_Tab);
    EXPECT_EQ(field.number(), 0.75);
    field.click(ImVec2(190.0F, 190.0F));
    field.enter("9", ImGuiKey_Escape);
    EXPECT_EQ(field.number(), 0.75);
    field.enter("");
    EXPECT_EQ(field.count(NumberChange::typed), 2U);
    EXPECT_EQ(field.count(NumberChange::dragged), 0U);
}

TEST(NumberField, WhatIsRefusedIsSaidAndTheNumberStays) {
    OneNumber field(4.0, {.low = 0.0, .high = 10.0});
    field.enter("2,5");
    EXPECT_EQ(field.number(), 4.0);
    EXPECT_NE(field.text_beside().find("'2,5': a point is expected instead of the comma."), std::string::npos)
        << field.text_beside();
    EXPECT_GE(field.place("refusal n", 0.0F, 0.0F).y, field.place("slider n", 0.0F, 1.0F).y) << "below the field";
    field.click(ImVec2(190.0F, 190.0F));
    EXPECT_TRUE(field.has("refusal n"));
    field.drag_by(30.0F);
    EXPECT_FALSE(field.has("refusal n"));
    field.enter("11");
    EXPECT_NE(field.text_beside().find("'11': a number from 0 to 10 is expected."), std::string::npos) << field.text_beside();
    field.click(ImVec2(190.0F, 190.0F));
    field.enter("2.5");
    EXPECT_FALSE(field.has("refusal n"));
    EXPECT_EQ(field.number(), 2.5);
}

// Keys that follow are meant for it: they are no shortcuts of the window.
TEST(NumberField, ABoxWhoseNumberIsRefusedStaysOpenWithTheKeyboard) {
    for (const ImGuiKey key : {ImGuiKey_Enter, ImGuiKey_Tab}) {
        OneNumber field(4.0);
        field.enter("1/0", key);
        field.redraws(3);
        EXPECT_TRUE(field.has("typed n") && field.has("refusal n"));
        EXPECT_TRUE(ImGui::GetIO().WantTextInput);
        EXPECT_EQ(field.state().text, "1/0");
        field.tap(ImGuiKey_End);
        field.tap(ImGuiKey_Backspace);
        EXPECT_EQ(field.state().text, "1/");
        EXPECT_FALSE(field.has("refusal n")) << "another text is not yet refused";
        field.type("8");
        field.tap(ImGuiKey_Enter);
        EXPECT_EQ(field.number(), 0.125);
        field.redraws(2);
        EXPECT_FALSE(ImGui::GetIO().WantTextInput);
    }
}

TEST(NumberField, EscapeOrAClickElsewhereLeavesARefusedNumber) {
    OneNumber field(4.0);
    field.enter("1/0");
    field.redraws(3);
    field.tap(ImGuiKey_Escape);
    field.redraws(2);
    EXPECT_FALSE(field.has("typed n") || field.has("refusal n"));
    field.enter("1/0");
    field.redraws(3);
    field.click(ImVec2(190.0F, 190.0F));
    field.redraws(2);
    EXPECT_FALSE(field.has("typed n"));
    EXPECT_TRUE(field.has("refusal n"));
    EXPECT_EQ(field.number(), 4.0);
}

TEST(NumberField, ShowsAUnitWhereThereIsRoom) {
    const auto shown = [](double value) {
        OneNumber field(value, {.unit = degree_sign});
        return field.text_beside();
    };
    EXPECT_NE(shown(12.5).find(std::string("12.5") + degree_sign), std::string::npos) << shown(12.5);
    EXPECT_EQ(shown(1.0 / 3.0).find(degree_sign), std::string::npos) << shown(1.0 / 3.0);
}

TEST(NumberField, WhatIsToBeAboveZeroIs) {
    OneNumber radius(4.0, {.above_zero = true});
    radius.enter("3-3");
    EXPECT_NE(radius.text_beside().find("'3-3': a number above 0 is expected."), std::string::npos) << radius.text_beside();
}

// What is wrong, or what a calculation gives, is said below the box while it is typed, and covers none of it.
TEST(NumberField, SaysWhatItGivesWhileItIsTyped) {
    OneNumber field(4.0);
    field.click("slider n");
    field.redraws(3);
    const int plain = field.vertices();
    field.type("50+3");
    EXPECT_GT(field.vertices(), plain);
    EXPECT_EQ(field.number(), 4.0);
    EXPECT_EQ(field.count(NumberChange::typed), 0U);
}

TEST(NumberField, ShowsAsManyDigitsAsFit) {
    OneNumber field(1.0 / 3.0);
    const float all = width_of(shortest(1.0 / 3.0));
    EXPECT_EQ(fitting_text(1.0 / 3.0, all), shortest(1.0 / 3.0));
    const std::string less = fitting_text(1.0 / 3.0, 0.6F * all);
    EXPECT_LE(width_of(less), 0.6F * all);
    EXPECT_EQ(less.substr(0, 6), "0.3333");
    EXPECT_EQ(fitting_text(144.0, 0.0F), "144") << "nothing takes less room";
    EXPECT_EQ(fitting_text(1234567.0, 0.0F), "1e+06");
}

}  // namespace sphereview
