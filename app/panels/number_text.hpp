// Numbers that a slider gives and that a panel shows: short, where the scene's own have up to 17 digits.
#pragma once

#include <string>

namespace sphereview {

// The nearest multiple of 10^exponent, as the nearest double; 0 where that is nearest.
double rounded_to(double value, int exponent);

// The exponent of the last of so many significant digits; of 0 that of 1.
int last_digit(double value, int digits);

// With decimal places down to 10^exponent, "12.50" for -2; as short as it can be where that would be long.
std::string rounded_text(double value, int exponent);

// With so many significant digits at most: "0.3333", "1e+20".
std::string short_text(double value, int digits = 4);

}  // namespace sphereview
