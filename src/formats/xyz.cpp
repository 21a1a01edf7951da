#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/elements.hpp"
#include "formats/lines.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

namespace {

enum class XyzField { species, position, radius, real_color, byte_color };

// How many columns each takes.
constexpr std::size_t columns_of(XyzField field) { return field == XyzField::species || field == XyzField::radius ? 1 : 3; }

struct XyzColumn {
    XyzField field;
    std::size_t first;  // of its columns, from 0
};

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
            const bool is_type = type == "r" || type == "i" || type == "s" || type == "l";
            if (name.empty() || !is_type || !parse_whole(digits, count) || count == 0) {
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
        throw InputError(source_.place(value_) + "found properties without a position, expected pos:R:3 among them");
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

// The columns that are drawn, from left to right; a position is always among them. `source` ends with the frame's comment, which
// begins at `begin`: `Properties=species:S:1:pos:R:3:...` names them; without it they are a species and a position. Other
// properties are passed over. Throws InputError where Properties are wrong.
std::vector<XyzColumn> xyz_layout(const TextSource& source, std::size_t begin) {
    const auto properties = find_properties(source.text.substr(begin));
    if (!properties) return {{XyzField::species, 0}, {XyzField::position, 1}};
    return Properties(source, *properties).layout();
}

constexpr std::size_t lines_a_piece = 1024;  // that one core reads at a time
constexpr const char* line_ends = "the line ends";

// Where a frame lies in the text.
struct Frame {
    std::int64_t number = 0;  // from 0
    std::size_t comment = 0;  // where its line begins
    std::size_t comment_end = 0;
    std::size_t atoms = 0;
    std::vector<std::size_t> pieces{};  // where the first line of each lines_a_piece begins
};

// Finds the frames of a text without looking at their atoms.
class FrameFinder {
public:
    explicit FrameFinder(const TextSource& source)
        : source_(source), line_end_(line_end_of(source.text)), walker_(source.text, line_end_) {}

    char line_end() const { return line_end_; }

    // Steps over the next frame; false when there is none. The pieces of the wanted one are noted.
    bool next(Frame& frame, bool wanted) {
        TextSource line = source_;
        std::size_t begin = 0;
        do {  // blank lines may stand between frames
            if (walker_.at_end()) return false;
            begin = walker_.offset();
            line.text = source_.text.substr(0, walker_.step());
        } while (TokenReader(line, begin).at_end());
        TokenReader reader(line, begin, line_ends);
        const std::string of_frame = " of frame " + std::to_string(frame.number);
        const auto expected = [&] { return "the number of atoms" + of_frame; };
        frame.atoms = static_cast<std::size_t>(reader.integer(0, most_spheres, expected));
        if (!reader.at_end()) reader.fail("the end of the line after " + expected());

        if (walker_.at_end()) fail_at_end("the comment" + of_frame);
        frame.comment = walker_.offset();
        frame.comment_end = walker_.step();
        for (std::size_t i = 0; i < frame.atoms; ++i) {
            if (walker_.at_end()) {
                fail_at_end("atom " + std::to_string(i + 1) + " of " + std::to_string(frame.atoms) + of_frame);
            }
            if (wanted && i % lines_a_piece == 0) frame.pieces.push_back(walker_.offset());
            walker_.step();
        }
        return true;
    }

private:
    [[noreturn]] void fail_at_end(const std::string& expected) const {
        TokenReader(source_, source_.text.size()).fail_at_end("the text ends", expected);
    }

    const TextSource& source_;
    char line_end_;
    LineWalker walker_;
};

// What a line says beside the sphere itself.
struct Atom {
    Sphere sphere{};
    std::string_view species{};
};

// Reads the lines of one piece.
class AtomReader {
public:
    AtomReader(const TextSource& source, const std::vector<XyzColumn>& layout, const Frame& frame, const DataOptions& options)
        : text_(source.text), line_{source.name, {}, source.origin}, layout_(layout), frame_(frame), options_(options) {}

    // Atom `index` of the frame, which stands at [begin, end).
    Atom read(std::size_t begin, std::size_t end, std::size_t index) {
        line_.text = text_.substr(0, end);
        TokenReader reader(line_, begin, line_ends);
        const auto the = [&](const char* what) {
            return [this, what, index] {
                return std::string(what) + " of atom " + std::to_string(index + 1) + " of " + std::to_string(frame_.atoms);
            };
        };
        Atom atom;
        const Element* element = &unknown_element();
        bool has_radius = false;
        bool has_color = false;
        std::size_t column = 0;
        for (const XyzColumn& next : layout_) {
            reader.skip_tokens(next.first - column);
            column = next.first + columns_of(next.field);
            Sphere& sphere = atom.sphere;
            switch (next.field) {
                case XyzField::species:
                    if (reader.at_end()) reader.fail_at_end(line_ends, the("the element")());
                    atom.species = reader.token();
                    element = &element_of_species(atom.species);
                    reader.skip_tokens(1);
                    break;
                case XyzField::position:
                    sphere.center.x = reader.number(the("the x"));
                    sphere.center.y = reader.number(the("the y"));
                    sphere.center.z = reader.number(the("the z"));
                    break;
                case XyzField::radius:
                    sphere.radius = reader.positive_number(the("the radius"));
                    has_radius = true;
                    break;
                case XyzField::real_color:
                    sphere.color.r = channel(reader, the("the red"));
                    sphere.color.g = channel(reader, the("the green"));
                    sphere.color.b = channel(reader, the("the blue"));
                    has_color = true;
                    break;
                case XyzField::byte_color:
                    sphere.color.r = static_cast<std::uint8_t>(reader.integer(0, color_max, the("the red")));
                    sphere.color.g = static_cast<std::uint8_t>(reader.integer(0, color_max, the("the green")));
                    sphere.color.b = static_cast<std::uint8_t>(reader.integer(0, color_max, the("the blue")));
                    has_color = true;
                    break;
            }
        }
        if (!has_radius) atom.sphere.radius = options_.radius.value_or(element->radius);
        if (!has_color) atom.sphere.color = element->color;
        return atom;
    }

private:
    // A part of 1.
    template <typename Expected>
    static std::uint8_t channel(TokenReader& reader, const Expected& expected) {
        const auto is_good = [](double value) { return value >= 0.0 && value <= 1.0; };
        return static_cast<std::uint8_t>(std::lround(color_max * reader.number(expected, is_good, " from 0 to 1")));
    }

    std::string_view text_;
    TextSource line_;  // the text up to the line's end
    const std::vector<XyzColumn>& layout_;
    const Frame& frame_;
    const DataOptions& options_;
};

// What an atom is called: its species, or the symbol of its number.
std::string name_of(std::string_view species) {
    const bool number = !species.empty() && species[0] >= '0' && species[0] <= '9';
    const std::string_view symbol = number ? element_of_species(species).symbol : species;
    return as_utf8(symbol.empty() ? species : symbol);
}

Scene read_frame(const TextSource& source, const Frame& frame, char line_end, const DataOptions& options) {
    require_memory(frame.atoms * sizeof(Sphere), source.name + ": " + in_groups(frame.atoms) + " spheres need");
    const auto layout = xyz_layout({source.name, source.text.substr(0, frame.comment_end), source.origin}, frame.comment);
    Scene scene;
    scene.spheres.resize(frame.atoms);
    std::vector<std::string_view> species(frame.atoms <= most_named_atoms ? frame.atoms : 0);
    parallel_in_order(frame.pieces.size(), [&](std::size_t piece) {
        AtomReader reader(source, layout, frame, options);
        LineWalker walker(source.text, line_end, frame.pieces[piece]);
        const std::size_t first = piece * lines_a_piece;
        const std::size_t last = std::min(frame.atoms, first + lines_a_piece);
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t begin = walker.offset();
            const Atom atom = reader.read(begin, walker.step(), i);
            scene.spheres[i] = atom.sphere;
            if (!species.empty()) species[i] = atom.species;
        }
    });
    for (std::size_t i = 0; i < species.size(); ++i) {
        if (!species[i].empty()) scene.names.emplace_hint(scene.names.end(), static_cast<std::uint32_t>(i), name_of(species[i]));
    }
    return scene;
}

}  // namespace

// A number, a comment, and an element before a position. A text scene has its colours and centres there.
bool shows_xyz(std::string_view head) {
    const auto is_whole = [](std::string_view word) { return word.find_first_not_of("0123456789") == std::string_view::npos; };
    const auto is_number = [](std::string_view word) {
        double ignored = 0.0;
        return parse_double(word, ignored) == NumberFault::none;
    };
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    head = trimmed(head, white_space);
    const auto count = words_of(take_line(head));
    const std::string_view comment_line = take_line(head);
    const auto comment = words_of(comment_line);
    const auto atom = words_of(take_line(head));
    if (count.size() != 1 || !is_whole(count[0]) || atom.empty()) return false;
    if (comment.size() == 3 && std::all_of(comment.begin(), comment.end(), is_whole)) return false;
    if (lower_case(comment_line).find("properties=") != std::string::npos || is_letter(atom[0][0])) return true;
    return atom.size() > 3 && is_whole(atom[0]) && !comment.empty() && !is_number(comment[0]);
}

SphereData read_xyz(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content)};
    FrameFinder finder(source);
    Frame wanted;
    std::int64_t frames = 0;
    while (true) {
        Frame frame;
        frame.number = frames;
        if (!finder.next(frame, frames == options.frame)) break;
        if (frames == options.frame) wanted = std::move(frame);
        ++frames;
    }
    if (frames == 0) TokenReader(source, 0).fail_at_end("the text is empty", "the number of atoms of frame 0");
    require_frame(name, options.frame, frames);
    return {read_frame(source, wanted, finder.line_end(), options), frames};
}

}  // namespace sphereview
