// What a person types where a number is expected: "50+3*2".
#pragma once

#include <string>
#include <string_view>

namespace sphereview {

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
