// The field for a number in panels, to be dragged or typed into, and the calculations that a person types for a number: "50+3*2".
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

#include "panels/panel_context.hpp"

namespace sphereview {

// The range of a number, and how far a drag changes it.
struct NumberRule {
    // Drags end at these; a typed number beyond is refused.
    double low = std::numeric_limits<double>::lowest();
    double high = std::numeric_limits<double>::max();
    // Only numbers above 0; a drag changes the number by equal factors.
    bool above_zero = false;
    bool whole = false;  // only whole numbers
    // A drag of some 100 pixels changes a number by about its own size, or, if it is smaller than this, by about this much.
    double usual_size = 1.0;
    const char* help = "";    // a sentence for the tooltip
    const char* prefix = "";  // before the number, where there is room
    const char* unit = "";    // behind it, likewise
};

inline constexpr const char* degree_sign = "\u00B0";

// The rule of a scene's coordinate: near 0 a drag changes it by a part of the scene's extent.
inline NumberRule coordinate_rule(const SceneBounds& bounds) {
    NumberRule rule;
    rule.usual_size = std::max(0.25 * bounds.extent(), 1e-290);
    return rule;
}

// The state of a panel's number fields.
struct NumberFields {
    // The field that is being typed into. Tab ends one number and begins the next field: ImGui's own Tab would skip the fields,
    // which are text boxes only while they are typed into.
    std::string typed;  // its name; "" for none
    std::string text;
    std::string opened_with;
    bool focus = false;        // the box gets the keyboard
    bool opens = false;        // the box gets the number as its text
    bool passes_on = false;    // the next item gets the keyboard
    std::string last_drawn;    // the field that Shift+Tab goes back to
    std::string just_typed;    // the field that shows no tooltip until the pointer has left it
    bool left_by_key = false;  // Enter or Tab ended the last box; else something else did

    // The latest drag: the number is `from` plus a step for each pixel. Errors do not add up, so the way back is exact.
    struct Drag {
        double from = 0.0;
        double step = 1.0;    // of a pixel, at the drag's beginning
        double steps = 0.0;   // up to `anchor`; beyond, at the pace of the keys held now
        double anchor = 0.0;  // in pixels from the press
        double pace = 1.0;
        double finest = 1.0;     // the finest pace so far, which the number is rounded by
        bool moved = false;      // else it is a click
        bool cancelled = false;  // by Escape
    };
    Drag drag;

    // The field whose last number was refused, and why.
    std::string refused;
    std::string fault;
};

// Whether Tab passed the keyboard on to the next item; true once.
bool takes_keyboard(NumberFields& fields);

enum class NumberChange { none, dragged, typed };

// Draws the field, as wide as the next item's width. A drag begins a gesture of its own and gives `value` short numbers: finer with
// Shift, coarser with Ctrl; Escape takes the drag back. A click, or Tab from another field, types a number or a calculation. A
// wrong or forbidden one is refused: the old number stays, and the box remains open until Escape or a click elsewhere. Noted as
// "slider NAME". `name` is unique among the panel's fields. `several`: shown instead of `value` where it stands for different
// values; else "".
NumberChange draw_number(const PanelContext& context, NumberFields& fields, const std::string& name, const NumberRule& rule,
                         double& value, const std::string& several = "");

// The same on a line of its own, behind its name, with the reason of a refusal below.
NumberChange draw_number_line(const PanelContext& context, NumberFields& fields, const char* name, const NumberRule& rule,
                              double& value);

// Refuses a field's number for a reason that the rule does not know, shown until another number is typed or dragged. After Enter or
// Tab the box opens again with the typed text, so that keys do not go to the window.
void refuse_number(NumberFields& fields, const std::string& name, const std::string& fault);

// Draws, on lines of its own, why the field's number was refused, if it was.
void draw_refusal(const PanelContext& context, const NumberFields& fields, const std::string& name);

// The shortest text that reads back as the same number. If that is wider than `width` pixels: as many digits as fit, or the
// narrowest text.
std::string fitting_text(double value, float width);

// "1.5 to 20".
std::string range_text(double low, double high);

// A finite number, or a fault.
struct ExpressionValue {
    double value = 0.0;
    std::string fault{};  // without full stop: "a number is missing at the end"; "" with a value
};

// Evaluates numbers, + - * / ^ (power, from the right), signs and parentheses. Numbers have a point, whatever the locale, and may
// have a power of ten: 2.5e-7. A number alone gives the nearest double. White space is ignored.
ExpressionValue evaluate(std::string_view text);

// Whether `text` is more than a single number, so that its result is worth showing.
bool is_calculation(std::string_view text);

}  // namespace sphereview
