#include "formats/xyz_columns.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>

#include "base/number.hpp"
#include "base/text.hpp"
#include "scene/sphere.hpp"

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

// Walks through NAME:TYPE:COLUMNS:NAME:...
class Properties {
public:
    Properties(const TextSource& source, std::string_view value) : source_(source), value_(value), rest_(value) {}

    XyzLayout layout() {
        XyzLayout layout;
        std::vector<XyzColumn>& columns = layout.columns;
        std::size_t first = 0;
        do {
            entry_ = rest_;
            const std::string_view written = name_part();
            const std::string name = lower_case(written);
            const std::string type = lower_case(part());
            const std::string_view digits = part();
            std::size_t count = 0;
            const bool is_type = type == "r" || type == "i" || type == "s" || type == "l";
            if (name.empty() || !is_type || !parse_whole(digits, count) || count == 0) {
                fail(example);
            }
            auto field = field_named(name, type, count);
            if (count > most_columns - first) fail("at most " + std::to_string(most_columns) + " columns");
            // Of a symbol and an atomic number the first is the element.
            if (field == XyzField::species && layout.has(XyzField::species)) field.reset();
            if (field != XyzField::position) add_properties(layout.properties, written, type[0], count, first, field);
            if (field) {
                if (*field == XyzField::position && count == 2) field = XyzField::flat_position;
                if (*field != XyzField::color && count != columns_of(*field))
                    fail(name + " of " + columns_in_words(*field) + " columns");
                if (!layout.has(*field)) columns.push_back({*field, first});
                if (*field == XyzField::color && type == "i") layout.full_color = color_max;
            }
            first += count;
        } while (!ended_);
        layout.width = first;
        if (layout.has(XyzField::position) || layout.has(XyzField::flat_position)) return layout;
        source_.fail_at(value_, "found properties without a position, expected pos:R:3 among them");
    }

private:
    // A radius or colour of another kind is no reason to refuse the atoms. What stands behind the three columns of a colour is
    // opacity.
    static std::optional<XyzField> field_named(const std::string& name, const std::string& type, std::size_t count) {
        const auto is = [&](std::initializer_list<const char*> names, const char* types) {
            return std::ranges::find(names, name) != names.end() && std::string_view(types).find(type) != std::string_view::npos;
        };
        if (is({"species", "element", "symbol", "z", "numbers"}, "si")) return XyzField::species;
        if (is({"pos", "position", "positions"}, "ri")) return XyzField::position;
        if (count == 1 && is({"radius", "radii"}, "ri")) return XyzField::radius;
        if (count >= 3 && is({"color", "colour", "colors"}, "ri")) return XyzField::color;
        return std::nullopt;
    }

    // A vector has a property for each of its columns, and its length.
    static void add_properties(std::vector<PropertyColumn>& properties, std::string_view name, char type, std::size_t count,
                               std::size_t first, std::optional<XyzField> field) {
        constexpr std::size_t most_parts = 64;
        const PropertyKind kind = type == 'r' ? PropertyKind::real : type == 'i' ? PropertyKind::whole : PropertyKind::words;
        if (field == XyzField::species) {
            add_column(properties, "element", PropertyKind::element, first);
        } else if (count == 1) {
            add_column(properties, name, kind, first);
        } else if (count <= most_parts) {
            const bool is_vector = count == 3 && (type == 'r' || type == 'i');
            for (std::size_t i = 0; i < count; ++i) {
                const std::string part = is_vector ? std::string(1, "xyz"[i]) : std::to_string(i + 1);
                add_column(properties, std::string(name) + "." + part, kind, first + i);
            }
            if (is_vector && field != XyzField::color) add_column(properties, name, PropertyKind::magnitude, first);
        }
    }

    static std::string columns_in_words(XyzField field) {
        return field == XyzField::position ? "2 or 3" : std::to_string(columns_of(field));
    }

    // A name may hold "::", as in mtt::aux.
    std::string_view name_part() {
        std::size_t end = rest_.find(':');
        while (end != std::string_view::npos && end > 0 && rest_.substr(end + 1).starts_with(':')) end = rest_.find(':', end + 2);
        return part(end);
    }

    std::string_view part() { return part(rest_.find(':')); }

    std::string_view part(std::size_t end) {
        const std::string_view found = take(rest_, end);
        ended_ = end == std::string_view::npos;
        if (!ended_) rest_.remove_prefix(1);
        return found;
    }

    [[noreturn]] void fail(const std::string& expected) const {
        const auto length = static_cast<std::size_t>(rest_.data() - entry_.data()) - (ended_ ? 0 : 1);
        source_.fail(entry_.substr(0, length), expected);
    }

    const TextSource& source_;
    std::string_view value_;
    std::string_view rest_;     // of the value
    std::string_view entry_{};  // of one property: from there
    bool ended_ = false;
};

// The optimisation flag of a coordinate.
bool is_flag_of_mopac(std::string_view word) { return word == "0" || word == "1" || word == "-1" || word == "+1"; }

// With a point: whole numbers may be anything.
bool is_coordinate_of_mopac(std::string_view word) { return word.find('.') != std::string_view::npos && is_number(word); }

// Whether the line has a species, and a flag behind each of three coordinates; or begins so, where it may be cut.
bool has_flags_of_mopac(std::string_view line, bool may_be_cut, std::vector<std::string_view>& words) {
    constexpr std::size_t of_atom = 7;
    words.clear();
    split_line(line, of_atom, words);
    if (may_be_cut && !words.empty()) words.pop_back();
    for (std::size_t i = 1; i < words.size(); ++i) {
        if (i % 2 == 1 ? !is_coordinate_of_mopac(words[i]) : !is_flag_of_mopac(words[i])) return false;
    }
    return may_be_cut || words.size() == of_atom;
}

// Whether every line has. Of a last line that has no line end, which may be cut, the others tell the rest.
bool have_flags_of_mopac(const TextSource& source, const AtomLines& atoms) {
    if (atoms.count == 0) return false;
    LineWalker walker = atoms.walker(source, 0);
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < atoms.count; ++i) {
        const std::string_view line = walker.step();
        const bool may_be_cut = i > 0 && walker.at_end() && !source.text.ends_with(atoms.line_end);
        if (!has_flags_of_mopac(line, may_be_cut, words)) return false;
    }
    return true;
}

// Whether LAMMPS's `dump xyz` wrote the atoms, and their types instead of their elements.
bool have_types_of_lammps(const TextSource& source, std::string_view comment, const AtomLines& atoms) {
    if (!trimmed(comment, white_space).starts_with("Atoms. Timestep:")) return false;
    std::vector<std::string_view> words;
    split_line(atoms.first_line(source), 1, words);
    return !words.empty() && is_digits(words[0]);
}

}  // namespace

std::optional<std::string_view> value_in_comment(std::string_view comment, std::string_view wanted) {
    while (true) {
        skip_blanks(comment);
        if (comment.empty()) return std::nullopt;
        const std::string_view key = take(comment, std::max<std::size_t>(1, comment.find_first_of(" \t\r\v\f=")));
        skip_blanks(comment);
        if (!comment.starts_with('=')) continue;
        comment.remove_prefix(1);
        skip_blanks(comment);
        const std::string_view value = take_value(comment);
        if (lower_case(key) == wanted) return value;
    }
}

XyzLayout tinker_layout() {
    return {.columns = {{XyzField::species, 1}, {XyzField::position, 2}},
            .properties = {{"atom", PropertyKind::words, 1}, {"type", PropertyKind::words, 5}},
            .has_names = true,
            .width = 6};
}

XyzLayout xyz_layout(const TextSource& source, std::string_view comment, const AtomLines& atoms) {
    if (const auto properties = value_in_comment(comment, "properties")) return Properties(source, *properties).layout();
    XyzLayout layout{.columns = {{XyzField::species, 0}, {XyzField::position, 1}},
                     .properties = {{"element", PropertyKind::element, 0}},
                     .is_plain = true};
    if (have_types_of_lammps(source, comment, atoms)) {
        layout.properties = {{"type", PropertyKind::words, 0}};
        layout.has_types = true;
    } else if (have_flags_of_mopac(source, atoms)) {
        layout.columns[1].field = XyzField::flagged_position;
        layout.width = 1 + columns_of(XyzField::flagged_position);
    }
    return layout;
}

}  // namespace sphereview
