// Decimal text to double and back, bit for bit, whatever the locale.
#pragma once

#include <string>
#include <string_view>

namespace sphereview {

enum class NumberFault { none, not_a_number, not_finite, too_large };

// Reads the whole of `token` as the nearest double; what is too small for a double gives the nearest one, 0 included.
// A leading '+' is allowed. On a fault `value` is left alone; too_large means beyond the largest double.
NumberFault parse_double(std::string_view token, double& value);

// Appends the shortest text that parse_double reads back as the same double (finite values only).
void append_double(std::string& text, double value);

}  // namespace sphereview
