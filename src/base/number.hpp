// Decimal text to double, bit for bit, whatever the locale. Back: shortest() in base/text.hpp.
#pragma once

#include <string_view>

namespace sphereview {

enum class NumberFault { none, not_a_number, not_finite, too_large };

// Reads the whole of `token` as the nearest double; what is too small for a double gives the nearest one, 0 included.
// A leading '+' is allowed. On a fault `value` is left alone; too_large means beyond the largest double.
NumberFault parse_double(std::string_view token, double& value);

}  // namespace sphereview
