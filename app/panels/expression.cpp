#include "panels/number_field.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "base/number.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr int most_nested = 50;  // parentheses, signs and powers: each is a call within a call

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Reads from the left, one function for each rank of operators. After a fault everything is 0 and goes on to the end.
class Evaluation {
public:
    explicit Evaluation(std::string_view text) : text_(text) {}

    ExpressionValue run() {
        const double value = sum();
        if (fault_.empty() && next() != '\0') fail(unexpected());
        if (fault_.empty() && !std::isfinite(value)) fail("the result is too large");
        return fault_.empty() ? ExpressionValue{value} : ExpressionValue{0.0, fault_};
    }

private:
    // The next character that is no white space; '\0' at the end.
    char next() {
        while (place_ < text_.size() && (text_[place_] == ' ' || text_[place_] == '\t')) ++place_;
        return place_ < text_.size() ? text_[place_] : '\0';
    }

    bool take(char c) {
        if (!fault_.empty() || next() != c || c == '\0') return false;
        ++place_;
        return true;
    }

    double fail(const std::string& fault) {
        if (fault_.empty()) fault_ = fault;
        place_ = text_.size();
        return 0.0;
    }

    std::string unexpected() {
        const char c = next();
        if (c == '\0') return "a number is missing at the end";
        if (c == ',') return "a point is expected instead of the comma";
        if (c == ')') return "a ')' is missing its '('";
        const std::string_view rest = text_.substr(place_);
        if (is_digit(c) || c == '.' || c == '(') return "an operator is missing before " + in_quotes(rest.substr(0, 1));
        if (std::string_view("*/^").find(c) != std::string_view::npos)
            return "a number is missing before " + in_quotes(rest.substr(0, 1));
        // A whole word.
        const std::size_t end = rest.find_first_of(" \t+-*/^(),.");
        return in_quotes(rest.substr(0, end)) + " is not a number";
    }

    double sum() {
        double value = product();
        while (true) {
            if (take('+')) {
                value += product();
            } else if (take('-')) {
                value -= product();
            } else {
                return value;
            }
        }
    }

    double product() {
        double value = factor();
        while (true) {
            if (take('*')) {
                value *= factor();
            } else if (take('/')) {
                const double divisor = factor();
                if (fault_.empty() && divisor == 0.0) return fail("nothing can be divided by 0");
                value /= divisor;
            } else {
                return value;
            }
        }
    }

    // -2^2 is -4.
    double factor() {
        if (++depth_ > most_nested) return fail("it is nested too deep");
        const double value = take('-') ? -factor() : take('+') ? factor() : power();
        --depth_;
        return value;
    }

    double power() {
        const double base = primary();
        if (!take('^')) return base;
        const double value = std::pow(base, factor());
        return std::isnan(value) ? fail("this power is no number") : value;
    }

    double primary() {
        if (!fault_.empty()) return 0.0;
        if (take('(')) {
            const double value = sum();
            if (fault_.empty() && next() != '\0' && next() != ')') return fail(unexpected());
            return take(')') ? value : fail("a ')' is missing");
        }
        return number();
    }

    double number() {
        const char first = next();
        const std::size_t begin = place_;
        const auto digits = [this] {
            while (place_ < text_.size() && is_digit(text_[place_])) ++place_;
        };
        if (!is_digit(first) && first != '.') return fail(unexpected());
        digits();
        if (place_ < text_.size() && text_[place_] == '.') ++place_;
        digits();
        if (place_ < text_.size() && (text_[place_] == 'e' || text_[place_] == 'E')) {
            ++place_;
            if (place_ < text_.size() && (text_[place_] == '+' || text_[place_] == '-')) ++place_;
            digits();
        }
        const std::string_view token = text_.substr(begin, place_ - begin);
        double value = 0.0;
        const NumberFault fault = parse_double(token, value);
        if (fault == NumberFault::too_large) return fail(in_quotes(token) + " is too large");
        return fault == NumberFault::none ? value : fail(in_quotes(token) + " is not a number");
    }

    std::string_view text_;
    std::size_t place_ = 0;
    int depth_ = 0;
    std::string fault_;
};

}  // namespace

ExpressionValue evaluate(std::string_view text) {
    // As typeset text has them, which is pasted here.
    std::string plain(text);
    for (const auto& [sign, typed] : {std::pair<std::string_view, char>("\u2212", '-'), {"\u00D7", '*'}, {"\u00B7", '*'}}) {
        for (std::size_t at = plain.find(sign); at != std::string::npos; at = plain.find(sign))
            plain.replace(at, sign.size(), 1, typed);
    }
    return Evaluation(plain).run();
}

bool is_calculation(std::string_view text) {
    double value = 0.0;
    return parse_double(trimmed(text), value) == NumberFault::not_a_number;
}

}  // namespace sphereview
