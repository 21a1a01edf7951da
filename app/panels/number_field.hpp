// The field in which panels show a number, to be dragged or typed into.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

#include "panels/panel_context.hpp"

namespace sphereview {

// What a number may be, and how far a drag changes it.
struct NumberRule {
    // Drags end there; what is typed beyond is refused.
    double low = std::numeric_limits<double>::lowest();
    double high = std::numeric_limits<double>::max();
    // More than 0 alone; a drag makes it larger or smaller by equal factors.
    bool above_zero = false;
    bool whole = false;  // whole numbers alone
    // A drag of some 100 pixels changes a number by about its own size when the drag begins; one that is smaller than this, 0 too,
    // by about this much.
    double usual_size = 1.0;
    const char* help = "";    // a sentence for the tooltip
    const char* prefix = "";  // before the number, where there is room
    const char* unit = "";    // behind it, likewise
};

inline constexpr const char* degree_sign = "\u00B0";

// Of a coordinate in a scene: one near 0 moves by a part of what the scene takes up.
inline NumberRule coordinate_rule(const SceneBounds& bounds) {
    NumberRule rule;
    rule.usual_size = std::max(0.25 * bounds.extent(), 1e-290);
    return rule;
}

// What a panel's number fields remember from redraw to redraw.
struct NumberFields {
    // The field that is being typed into. Tab ends one number and begins the next that is drawn: ImGui's own Tab would pass over
    // the fields, which are no text boxes until they are typed into.
    std::string typed;  // its name; "" for none
    std::string text;
    std::string opened_with;
    bool focus = false;        // the box is to get the keyboard
    bool opens = false;        // the box is to get the number as its text
    bool passes_on = false;    // what is drawn next gets the keyboard
    std::string last_drawn;    // the field that Shift+Tab goes back to
    std::string just_typed;    // the field that says nothing of itself until the pointer has left it
    bool left_by_key = false;  // the last box, by Enter or Tab: else the person went on to something else

    // The latest drag: the number is `from` and so many steps, of a pixel each. Nothing adds up, and back is back to the bit.
    struct Drag {
        double from = 0.0;
        double step = 1.0;    // of a pixel, as it was when the drag began
        double steps = 0.0;   // until the pointer was at `anchor`; since then at the pace of the keys that are held now
        double anchor = 0.0;  // in pixels from where the button went down
        double pace = 1.0;
        double finest = 1.0;     // of the paces that there were: what the number is rounded by
        bool moved = false;      // else it is a click
        bool cancelled = false;  // by Escape
    };
    Drag drag;

    // Where and why the number that was entered last was refused.
    std::string refused;
    std::string fault;
};

// Whether Tab left the number before for what is drawn next; true once.
bool takes_keyboard(NumberFields& fields);

enum class NumberChange { none, dragged, typed };

// As wide as the next item's width. A drag gives `value` a short number and begins a gesture of its own; with Shift it is finer,
// with Ctrl coarser, and Escape takes it back. A click, or Tab from another number, types one, or a calculation; what is none, or
// not allowed, is refused: the old number stays, and the box remains open for another one until Escape or a click elsewhere. Noted
// as "slider NAME". `name` is unique among the panel's fields. `several`: where the value stands for others, too, which differ from
// it, what is shown instead; "" where they do not.
NumberChange draw_number(const PanelContext& context, NumberFields& fields, const std::string& name, const NumberRule& rule,
                         double& value, const std::string& several = "");

// The same on a line of its own, behind its name; below it, why the number was refused that was entered.
NumberChange draw_number_line(const PanelContext& context, NumberFields& fields, const char* name, const NumberRule& rule,
                              double& value);

// Notes why the field's number cannot be, for what a rule does not know. It is said until another number is typed or dragged. After
// Enter or Tab the box opens again with what was typed: keys are still meant for that number, and not for the window.
void refuse_number(NumberFields& fields, const std::string& name, const std::string& fault);

// Says, on lines of its own, why the number of that field was refused; nothing where it was not.
void draw_refusal(const PanelContext& context, const NumberFields& fields, const std::string& name);

// The shortest text of the number that reads back as the same, or, where that is wider, as many digits as fit into so many pixels;
// where none do, what takes least room.
std::string fitting_text(double value, float width);

// "1.5 to 20".
std::string range_text(double low, double high);

// A finite number, or why there is none.
struct ExpressionValue {
    double value = 0.0;
    std::string fault{};  // a sentence without its full stop, "" where there is a value: "a number is missing at the end"
};

// Works out numbers, + - * / ^ (to the power of, which binds from the right), signs and parentheses. Numbers have a point, whatever
// the locale, and may have a power of ten: 2.5e-7. A number alone is read to the nearest double. White space counts for nothing.
ExpressionValue evaluate(std::string_view text);

// Whether it is more than one number: then people want to see what it gives.
bool is_calculation(std::string_view text);

}  // namespace sphereview
