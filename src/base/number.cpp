#include "base/number.hpp"

#include <array>
#include <cmath>
#include <locale>
#include <sstream>
#include <system_error>

namespace sphereview {

NumberFault parse_double(std::string_view token, double& value) {
    const char* first = token.data();
    const char* last = first + token.size();
    // read_double() takes no '+'.
    if (first != last && *first == '+' && (first + 1 == last || first[1] != '-')) ++first;
    double read = 0.0;
    const auto result = read_double(first, last, read);
    if (result.ptr != last || first == last) return NumberFault::not_a_number;
    if (result.ec == std::errc::result_out_of_range) {
        // read_double() does not say whether it met the top or the bottom of the range, and strtod heeds the locale.
        std::istringstream text(std::string(first, last));
        text.imbue(std::locale::classic());
        text >> read;
        if (std::fabs(read) > 1.0) return NumberFault::too_large;
    } else if (result.ec != std::errc{}) {
        return NumberFault::not_a_number;
    } else if (!std::isfinite(read)) {
        // The words inf and nan; digits never get here.
        return NumberFault::not_finite;
    }
    value = read;
    return NumberFault::none;
}

NumberFault parse_any_double(std::string_view token, double& value) {
    const NumberFault fault = parse_double(token, value);
    if (fault != NumberFault::not_a_number) return fault;
    const std::size_t mantissa = token.find_first_not_of("0123456789.", token.find_first_of("0123456789."));
    if (mantissa == std::string_view::npos) return fault;
    std::string_view exponent = token.substr(mantissa);
    const bool is_signed = exponent[0] == '+' || exponent[0] == '-';
    if (exponent.starts_with("*^")) {
        exponent.remove_prefix(2);
    } else if (exponent[0] == 'D' || exponent[0] == 'd') {
        exponent.remove_prefix(1);
    } else if (!is_signed || exponent.size() < 3 || exponent.size() > 4 || token.find('.') == std::string_view::npos) {
        return fault;
    }
    return parse_double(std::string(token.substr(0, mantissa)).append("e").append(exponent), value);
}

const char* expected_instead_of(NumberFault fault) {
    if (fault == NumberFault::not_a_number) return "a number";
    return fault == NumberFault::not_finite ? "a finite number" : "a number that a double can hold (at most 1.8e308)";
}

namespace {

template <typename Number>
std::string shortest_text(Number value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

}  // namespace

std::string shortest(double value) { return shortest_text(value); }

std::string shortest(float value) { return shortest_text(value); }

std::string decimal(double value, std::chars_format format, int digits) {
    std::array<char, 400> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, digits);
    return {buffer.data(), end.ptr};
}

int decimal_exponent(double value, int digits) {
    const std::string text = decimal(value, std::chars_format::scientific, digits);
    const std::size_t begin = text.find('e') + (text[text.find('e') + 1] == '+' ? 2 : 1);
    int exponent = 0;
    parse_whole(std::string_view(text).substr(begin), exponent);
    return exponent;
}

double round_number_below(double most) {
    if (!(most > 0.0) || !std::isfinite(most)) return 0.0;
    // Through text: no power of ten is inexact there.
    const int exponent = decimal_exponent(most, 0);
    // Rounding to one digit may have led to the next power.
    for (const int power : {exponent, exponent - 1}) {
        for (const char* digit : {"5", "2", "1"}) {
            double number = 0.0;
            const bool is_number = parse_double(digit + ("e" + std::to_string(power)), number) == NumberFault::none;
            if (is_number && number > 0.0 && number <= most) return number;
        }
    }
    return 0.0;
}

std::string fixed(double value, int places) { return decimal(value, std::chars_format::fixed, places); }

}  // namespace sphereview
