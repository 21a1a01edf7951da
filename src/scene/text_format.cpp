#include "scene/text_format.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>

#include "base/error.hpp"
#include "scene/number.hpp"

namespace sphereview {

namespace {

constexpr std::size_t shortest_sphere = 14;  // seven digits, each with a separator

constexpr bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// Walks through the numbers of a text; knows how to say where it stands.
class TokenReader {
public:
    explicit TokenReader(const TextSource& source) : source_(source), text_(without_byte_order_mark(source.text)), rest_(text_) {
        skip_space();
    }

    bool at_end() const { return rest_.empty(); }
    std::size_t bytes_left() const { return rest_.size(); }

    // An integer from `low` to `high`; `expected` describes it in a message.
    template <typename Expected>
    std::int64_t integer(std::int64_t low, std::int64_t high, const Expected& expected) {
        const std::string_view token = next(expected);
        const char* first = token.data();
        const char* last = first + token.size();
        if (token.size() > 1 && token[0] == '+' && token[1] != '-') ++first;
        std::int64_t value = 0;
        const auto result = std::from_chars(first, last, value);
        if (result.ptr != last) fail(token, expected() + ", a whole number");
        if (result.ec != std::errc{} || value < low || value > high) {
            fail(token, expected() + " from " + std::to_string(low) + " to " + std::to_string(high));
        }
        return value;
    }

    template <typename Expected>
    double number(const Expected& expected) {
        const std::string_view token = next(expected);
        double value = 0.0;
        switch (parse_double(token, value)) {
            case NumberFault::none: break;
            case NumberFault::not_a_number: fail(token, expected() + ", a number");
            case NumberFault::not_finite: fail(token, expected() + ", a finite number");
            case NumberFault::too_large: fail(token, expected() + ", a number that a double can hold (at most 1.8e308)");
        }
        return value;
    }

    template <typename Expected>
    double positive_number(const Expected& expected) {
        const std::string_view before = rest_;
        const double value = number(expected);
        if (!(value > 0.0)) {
            const auto end = std::find_if(before.begin(), before.end(), is_space);
            fail(before.substr(0, static_cast<std::size_t>(end - before.begin())), expected() + " above 0");
        }
        return value;
    }

    // The next token, without stepping over it.
    std::string_view peek() const {
        const auto end = std::find_if(rest_.begin(), rest_.end(), is_space);
        return rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    }

    // Between two spheres: lets go of what was read, if there is enough of it.
    void let_go() {
        constexpr std::size_t enough = std::size_t{1} << 22;
        const std::size_t offset = text_.size() - rest_.size();
        if (!source_.consumed || offset - kept_from_ < enough) return;
        kept_place_ = position_at(text_.substr(kept_from_), offset - kept_from_, kept_place_);
        kept_from_ = offset;
        source_.consumed(source_.text.size() - rest_.size());
    }

    [[noreturn]] void fail(std::string_view token, const std::string& expected) const {
        const auto offset = static_cast<std::size_t>(token.data() - text_.data());
        throw InputError(place(offset) + "found " + in_quotes(token) + ", expected " + expected);
    }

    [[noreturn]] void fail_at_end(const std::string& found, const std::string& expected) const {
        throw InputError(place(text_.size()) + found + ", expected " + expected);
    }

private:
    std::string place(std::size_t offset) const {
        const TextPosition position = position_at(text_.substr(kept_from_), offset - kept_from_, kept_place_);
        return source_.name + ":" + std::to_string(position.line) + ":" + std::to_string(position.column) + ": ";
    }

    void skip_space() {
        const auto begin = std::find_if_not(rest_.begin(), rest_.end(), is_space);
        rest_.remove_prefix(static_cast<std::size_t>(begin - rest_.begin()));
    }

    template <typename Expected>
    std::string_view next(const Expected& expected) {
        if (at_end()) fail_at_end("the text ends", expected());
        const std::string_view token = peek();
        rest_.remove_prefix(token.size());
        skip_space();
        return token;
    }

    const TextSource& source_;
    std::string_view text_;
    std::string_view rest_;
    std::size_t kept_from_ = 0;  // what lies before was let go
    TextPosition kept_place_ = source_.origin;
};

}  // namespace

std::vector<Sphere> parse_text_spheres(const TextSource& source) {
    TokenReader reader(source);
    const auto count_expected = [] { return std::string("the number of spheres"); };
    if (reader.at_end()) reader.fail_at_end("the text is empty", count_expected());
    const std::int64_t count = reader.integer(0, most_spheres, count_expected);

    std::vector<Sphere> spheres;
    spheres.reserve(std::min(static_cast<std::size_t>(count), reader.bytes_left() / shortest_sphere + 1));
    for (std::int64_t i = 0; i < count; ++i) {
        const auto of_sphere = [&](const char* what) {
            return [what, i, count] {
                return std::string(what) + " of sphere " + std::to_string(i + 1) + " of " + std::to_string(count);
            };
        };
        Sphere sphere;
        sphere.color.r = static_cast<std::uint8_t>(reader.integer(0, color_max, of_sphere("the red")));
        sphere.color.g = static_cast<std::uint8_t>(reader.integer(0, color_max, of_sphere("the green")));
        sphere.color.b = static_cast<std::uint8_t>(reader.integer(0, color_max, of_sphere("the blue")));
        sphere.center.x = reader.number(of_sphere("the centre's x"));
        sphere.center.y = reader.number(of_sphere("the centre's y"));
        sphere.center.z = reader.number(of_sphere("the centre's z"));
        sphere.radius = reader.positive_number(of_sphere("the radius"));
        spheres.push_back(sphere);
        reader.let_go();
    }
    if (!reader.at_end()) {
        reader.fail(reader.peek(), "the end of the text after " + std::to_string(count) + (count == 1 ? " sphere" : " spheres"));
    }
    return spheres;
}

std::string write_text_spheres(const std::vector<Sphere>& spheres) {
    const auto drawn = std::count_if(spheres.begin(), spheres.end(), [](const Sphere& s) { return !s.hidden; });
    std::string text = std::to_string(drawn) + "\n";
    for (const Sphere& sphere : spheres) {
        if (sphere.hidden) continue;
        text += std::to_string(sphere.color.r) + ' ' + std::to_string(sphere.color.g) + ' ' + std::to_string(sphere.color.b) + '\n';
        text += shortest(sphere.center.x);
        text += ' ';
        text += shortest(sphere.center.y);
        text += ' ';
        text += shortest(sphere.center.z);
        text += '\n';
        text += shortest(sphere.radius);
        text += '\n';
    }
    return text;
}

}  // namespace sphereview
