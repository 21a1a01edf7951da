// A slider for a double that no one rounds unasked.
#pragma once

#include <string>

#include "panels/panel_context.hpp"

namespace sphereview {

// The number that is being typed instead of dragged.
struct TypedNumber {
    std::string field;  // the slider's name; "" for none
    std::string text;
    bool focus = false;
};

// What a drag covers; values outside are shown as they are, and can be typed.
struct SliderRange {
    double low = 0.0;
    double high = 1.0;         // more than low
    bool logarithmic = false;  // low > 0
    bool above_zero = false;   // what may be typed
};

enum class SliderChange { none, dragged, typed };

// As wide as the next item's width. A drag gives `value` a short number of the range and begins a gesture of its own; Ctrl+click
// types any finite number in full, and what is none, or not allowed, is refused. Noted as "slider NAME". `several`: where the
// value stands for others, too, which differ from it, what is shown instead; "" where they do not.
SliderChange draw_value_slider(const PanelContext& context, TypedNumber& typed, const std::string& name, const SliderRange& range,
                               double& value, const std::string& several = "");

// "1.5 to 20", rounded as the slider rounds.
std::string range_text(const SliderRange& range, double low, double high);

}  // namespace sphereview
