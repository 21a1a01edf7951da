// Decimal text to double and back, bit for bit, in any locale. No other code calls std::from_chars and std::to_chars for floating
// point, which some C++ libraries lack.
#pragma once

#include <charconv>
#include <string>
#include <string_view>

namespace sphereview {

enum class NumberFault { none, not_a_number, not_finite, too_large };

// Reads the number at the beginning of [begin, end), as std::from_chars. Inline for speed.
inline std::from_chars_result read_double(const char* begin, const char* end, double& value) {
    return std::from_chars(begin, end, value);
}

// Reads the whole `token` as the nearest double, which may be 0 for tiny numbers. A leading '+' is allowed. Leaves `value` alone on
// a fault; too_large means beyond the largest double.
NumberFault parse_double(std::string_view token, double& value);

// The same, also with other programs' exponents: 1.0D+00 and 1.0d0 (Fortran), 1.0*^-6 (Mathematica), 1.0+01 and 0.25-102 (Fortran
// without the letter).
NumberFault parse_any_double(std::string_view token, double& value);

// Reads the whole `token` as a whole number, without a mark of its base. False, with `value` undefined, if that fails or does not
// fit.
template <typename Whole>
bool parse_whole(std::string_view token, Whole& value, int base = 10) {
    const auto read = std::from_chars(token.data(), token.data() + token.size(), value, base);
    return read.ec == std::errc{} && read.ptr == token.data() + token.size();
}

// The expected number for a message: "a finite number".
const char* expected_instead_of(NumberFault fault);

// The shortest decimal text that reads back as the same number; "inf" and "nan" where there is none.
std::string shortest(double value);
std::string shortest(float value);

// `value` with that many digits, as printf writes it in the "C" locale. digits: 0..50.
std::string decimal(double value, std::chars_format format, int digits);

// The decimal exponent of `value`, rounded to that many digits behind the point. `value`: finite. digits: 0..50.
int decimal_exponent(double value, int digits = 17);

// The greatest number of at most `most` that is 1, 2 or 5 times a power of ten, as the nearest double; 0 if `most` is not above 0,
// or not finite.
double round_number_below(double most);

// `value` with decimal places. places: 0..9.
std::string fixed(double value, int places);

}  // namespace sphereview
