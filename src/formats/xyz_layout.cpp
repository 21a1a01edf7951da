#include "formats/xyz_layout.hpp"

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <optional>

#include "base/error.hpp"
#include "formats/token_reader.hpp"

namespace sphereview {

namespace {

constexpr std::size_t most_columns = 1'000'000;
constexpr const char* example = "NAME:TYPE:COLUMNS for each property, as in species:S:1:pos:R:3";

void skip_blanks(std::string_view& text) { text.remove_prefix(std::min(text.find_first_not_of(white_space), text.size())); }

std::string_view take(std::string_view& text, std::size_t count) {
    const std::string_view taken = text.substr(0, count);
    text.remove_prefix(std::min(taken.size(), text.size()));
    return taken;
}

// The value that begins `text`: in quotes or braces, or one word.
std::string_view take_value(std::string_view& text) {
    if (text.empty()) return text;
    const char close = text[0] == '{' ? '}' : text[0];
    if (close != '"' && close != '\'' && close != '}') return take(text, text.find_first_of(white_space));
    text.remove_prefix(1);
    std::size_t end = text.find(close);
    while (end != std::string_view::npos && end > 0 && text[end - 1] == '\\') end = text.find(close, end + 1);
    const std::string_view value = take(text, end);
    text.remove_prefix(std::min<std::size_t>(1, text.size()));
    return value;
}

// The value of Properties among the `key=value` of a comment.
std::optional<std::string_view> find_properties(std::string_view comment) {
    while (true) {
        skip_blanks(comment);
        if (comment.empty()) return std::nullopt;
        const std::string_view key = take(comment, std::max<std::size_t>(1, comment.find_first_of(" \t\r\v\f=")));
        skip_blanks(comment);
        if (!comment.starts_with('=')) continue;
        comment.remove_prefix(1);
        skip_blanks(comment);
        const std::string_view value = take_value(comment);
        if (lower_case(key) == "properties") return value;
    }
}

// Walks through NAME:TYPE:COLUMNS:NAME:...
class Properties {
public:
    Properties(const TextSource& source, std::string_view value) : source_(source), value_(value), rest_(value) {}

    std::vector<XyzColumn> layout() {
        std::vector<XyzColumn> columns;
        std::size_t first = 0;
        do {
            entry_ = rest_;
            const std::string name = lower_case(part());
            const std::string type = lower_case(part());
            const std::string_view digits = part();
            std::size_t count = 0;
            const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), count);
            const bool is_type = type == "r" || type == "i" || type == "s" || type == "l";
            if (name.empty() || !is_type || read.ec != std::errc{} || read.ptr != digits.data() + digits.size() || count == 0) {
                fail(example);
            }
            if (const auto field = field_named(name, type)) {
                if (count != columns_of(*field)) fail(name + " of " + std::to_string(columns_of(*field)) + " columns");
                if (!has(columns, *field)) columns.push_back({*field, first});
            }
            if (count > most_columns - first) fail("at most " + std::to_string(most_columns) + " columns");
            first += count;
        } while (!ended_);
        if (has(columns, XyzField::position)) return columns;
        throw InputError(place_of(value_) + "found properties without a position, expected pos:R:3 among them");
    }

private:
    // A radius or colour of another kind is no reason to refuse the atoms.
    static std::optional<XyzField> field_named(const std::string& name, const std::string& type) {
        const auto is = [&](std::initializer_list<const char*> names, const char* types) {
            return std::ranges::find(names, name) != names.end() && std::string_view(types).find(type) != std::string_view::npos;
        };
        if (is({"species", "element", "symbol", "z", "numbers"}, "si")) return XyzField::species;
        if (is({"pos", "position", "positions"}, "ri")) return XyzField::position;
        if (is({"radius", "radii"}, "ri")) return XyzField::radius;
        if (is({"color", "colour", "colors"}, "r")) return XyzField::real_color;
        if (is({"color", "colour", "colors"}, "i")) return XyzField::byte_color;
        return std::nullopt;
    }

    static bool has(const std::vector<XyzColumn>& columns, XyzField field) {
        return std::ranges::find(columns, field, &XyzColumn::field) != columns.end();
    }

    std::string_view part() {
        const std::size_t end = rest_.find(':');
        const std::string_view found = take(rest_, end);
        ended_ = end == std::string_view::npos;
        if (!ended_) rest_.remove_prefix(1);
        return found;
    }

    std::string place_of(std::string_view piece) const {
        const auto offset = static_cast<std::size_t>(piece.data() - source_.text.data());
        return place_in(source_.name, position_at(source_.text, offset, source_.origin));
    }

    [[noreturn]] void fail(const std::string& expected) const {
        const auto length = static_cast<std::size_t>(rest_.data() - entry_.data()) - (ended_ ? 0 : 1);
        throw InputError(place_of(entry_) + found_expected(entry_.substr(0, length), expected));
    }

    const TextSource& source_;
    std::string_view value_;
    std::string_view rest_;     // of the value
    std::string_view entry_{};  // of one property: from there
    bool ended_ = false;
};

}  // namespace

std::vector<XyzColumn> xyz_layout(const TextSource& source, std::size_t begin) {
    const auto properties = find_properties(source.text.substr(begin));
    if (!properties) return {{XyzField::species, 0}, {XyzField::position, 1}};
    return Properties(source, *properties).layout();
}

}  // namespace sphereview
