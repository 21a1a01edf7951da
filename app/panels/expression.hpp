// Calculations that a person types for a number: "50+3*2".
#pragma once

#include <string>
#include <string_view>

namespace sphereview {

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
