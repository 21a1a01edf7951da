#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atoms.hpp"
#include "formats/elements.hpp"
#include "formats/lines.hpp"
#include "formats/point_radius.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

namespace {

enum class XyzField { species, position, flat_position, radius, color };

// How many columns each takes.
constexpr std::size_t columns_of(XyzField field) {
    if (field == XyzField::species || field == XyzField::radius) return 1;
    return field == XyzField::flat_position ? 2 : 3;
}

struct XyzColumn {
    XyzField field;
    std::size_t first;  // of its columns, from 0
};

// The columns that are drawn, from left to right; a position is always among them.
struct XyzLayout {
    std::vector<XyzColumn> columns;
    double full_color = 1.0;  // what stands for 255
};

constexpr std::size_t most_columns = 1'000'000;
constexpr const char* example = "NAME:TYPE:COLUMNS for each property, as in species:S:1:pos:R:3";

bool is_comment(std::string_view line) { return line.starts_with('#') || line.starts_with("//"); }

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

    XyzLayout layout() {
        XyzLayout layout;
        std::vector<XyzColumn>& columns = layout.columns;
        std::size_t first = 0;
        do {
            entry_ = rest_;
            const std::string name = lower_case(name_part());
            const std::string type = lower_case(part());
            const std::string_view digits = part();
            std::size_t count = 0;
            const bool is_type = type == "r" || type == "i" || type == "s" || type == "l";
            if (name.empty() || !is_type || !parse_whole(digits, count) || count == 0) {
                fail(example);
            }
            if (auto field = field_named(name, type, count)) {
                if (*field == XyzField::position && count == 2) field = XyzField::flat_position;
                if (*field != XyzField::color && count != columns_of(*field))
                    fail(name + " of " + columns_in_words(*field) + " columns");
                if (!has(columns, *field)) columns.push_back({*field, first});
                if (*field == XyzField::color && type == "i") layout.full_color = color_max;
            }
            if (count > most_columns - first) fail("at most " + std::to_string(most_columns) + " columns");
            first += count;
        } while (!ended_);
        if (has(columns, XyzField::position) || has(columns, XyzField::flat_position)) return layout;
        throw InputError(source_.place(value_) + "found properties without a position, expected pos:R:3 among them");
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

    static bool has(const std::vector<XyzColumn>& columns, XyzField field) {
        return std::ranges::find(columns, field, &XyzColumn::field) != columns.end();
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

// `source` ends with the frame's comment, which begins at `begin`: `Properties=species:S:1:pos:R:3:...` names the columns; without
// it they are a species and a position. Other properties are passed over. Throws InputError where Properties are wrong.
XyzLayout xyz_layout(const TextSource& source, std::size_t begin) {
    const auto properties = find_properties(source.text.substr(begin));
    if (!properties) return {.columns = {{XyzField::species, 0}, {XyzField::position, 1}}};
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
        do {
            if (walker_.at_end()) return false;
            begin = walker_.offset();
            line.text = source_.text.substr(0, walker_.step());
        } while (is_between_frames(line, begin));
        TokenReader reader(line, begin, line_ends);
        const std::string of_frame = " of frame " + std::to_string(frame.number);
        const auto expected = [&] { return "the number of atoms" + of_frame; };
        frame.atoms = static_cast<std::size_t>(reader.integer(0, most_spheres, expected));
        check_behind_count(line, reader, frame, expected);

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

    // The first line of lattice vectors behind the atoms, for a warning; "" where there is none.
    const std::string& vectors() const { return vectors_; }

private:
    // Blank lines, the `>` of ORCA, and the lattice as VEC1, VEC2 and VEC3.
    bool is_between_frames(const TextSource& line, std::size_t begin) {
        const TokenReader reader(line, begin);
        if (reader.at_end() || reader.token() == ">") return true;
        const std::string_view word = reader.token();
        const bool is_vector = word == "VEC1" || word == "VEC2" || word == "VEC3";
        if (is_vector && vectors_.empty()) vectors_ = source_.place(word) + "found " + in_quotes(word);
        return is_vector;
    }

    // Many programs write more behind the number: words, an energy, the lengths of a box. But where it is as much as an atom has
    // whose element is a number, and the first frame had less, one more atom stands there than was said.
    template <typename Expected>
    void check_behind_count(const TextSource& line, TokenReader& reader, const Frame& frame, const Expected& expected) {
        const std::string_view rest = line.text.substr(reader.offset());
        std::size_t numbers = 0;
        double ignored = 0.0;
        for (const std::string_view word : words_of(rest)) {
            if (numbers == atom_numbers || parse_any_double(word, ignored) != NumberFault::none) break;
            ++numbers;
        }
        if (frame.number == 0) numbers_behind_first_ = numbers;
        if (numbers == atom_numbers && numbers_behind_first_ < numbers) {
            reader.fail("the end of the line after " + expected());
        }
    }

    [[noreturn]] void fail_at_end(const std::string& expected) const {
        TokenReader(source_, source_.text.size()).fail_at_end("the text ends", expected);
    }

    static constexpr std::size_t atom_numbers = 3;

    const TextSource& source_;
    char line_end_;
    LineWalker walker_;
    std::size_t numbers_behind_first_ = 0;  // behind the number of atoms of the first frame
    std::string vectors_{};
};

// What a line says beside the sphere itself.
struct Atom {
    Sphere sphere{};
    std::string_view species{};
    bool is_virtual = false;
};

// Colours that are no part of 1 by so much are of 255.
constexpr double most_of_one = 1.5;

// Reads the lines of one piece.
class AtomReader {
public:
    AtomReader(const TextSource& source, const XyzLayout& layout, const Frame& frame, const DataOptions& options)
        : text_(source.text), line_{source.name, {}, source.origin}, layout_(layout), frame_(frame), options_(options) {}

    // Atom `index` of the frame, which stands at [begin, end).
    Atom read(std::size_t begin, std::size_t end, std::size_t index) {
        line_.text = text_.substr(0, end);
        TokenReader reader(line_, begin, line_ends, parse_any_double);
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
        for (const XyzColumn& next : layout_.columns) {
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
                case XyzField::flat_position:
                    sphere.center.x = reader.number(the("the x"));
                    sphere.center.y = reader.number(the("the y"));
                    sphere.center.z = 0.0;
                    break;
                case XyzField::radius:
                    // OVITO's 0 is the usual radius.
                    sphere.radius = reader.number_or_0(the("the radius"));
                    has_radius = sphere.radius > 0.0;
                    break;
                case XyzField::color:
                    has_color = channel(reader, the("the red"), sphere.color.r);
                    has_color = channel(reader, the("the green"), sphere.color.g) && has_color;
                    has_color = channel(reader, the("the blue"), sphere.color.b) && has_color;
                    break;
            }
        }
        atom.is_virtual = is_virtual(*element);
        if (!has_radius) atom.sphere.radius = radius_of(*element, options_);
        if (!has_color) atom.sphere.color = element->color;
        return atom;
    }

    // The largest number of a colour so far.
    double largest_color() const { return largest_color_; }

private:
    // False for what is no part of layout_.full_color.
    template <typename Expected>
    bool channel(TokenReader& reader, const Expected& expected, std::uint8_t& channel) {
        const double value = reader.number_or_0(expected);
        largest_color_ = std::max(largest_color_, value);
        if (!(value >= 0.0 && value <= layout_.full_color * most_of_one)) return false;
        channel = static_cast<std::uint8_t>(std::lround(color_max * std::min(1.0, value / layout_.full_color)));
        return true;
    }

    std::string_view text_;
    TextSource line_;  // the text up to the line's end
    const XyzLayout& layout_;
    const Frame& frame_;
    const DataOptions& options_;
    double largest_color_ = 0.0;
};

// What an atom is called: its species, or the symbol of its number.
std::string name_of(std::string_view species) {
    const bool number = !species.empty() && species[0] >= '0' && species[0] <= '9';
    const std::string_view symbol = number ? element_of_species(species).symbol : species;
    return as_utf8(symbol.empty() ? species : symbol);
}

// The atoms of a frame.
struct Atoms {
    std::vector<Sphere> spheres{};
    std::vector<std::string_view> species{};   // none of more than most_named_atoms
    std::vector<std::size_t> virtual_sites{};  // their numbers, ascending
    double largest_color = 0.0;
};

Atoms read_atoms(const TextSource& source, const Frame& frame, const XyzLayout& layout, char line_end, const DataOptions& options) {
    Atoms atoms;
    atoms.spheres.resize(frame.atoms);
    atoms.species.resize(frame.atoms <= most_named_atoms ? frame.atoms : 0);
    std::vector<std::vector<std::size_t>> virtual_sites(frame.pieces.size());
    std::vector<double> largest_colors(frame.pieces.size());
    parallel_in_order(frame.pieces.size(), [&](std::size_t piece) {
        AtomReader reader(source, layout, frame, options);
        LineWalker walker(source.text, line_end, frame.pieces[piece]);
        const std::size_t first = piece * lines_a_piece;
        const std::size_t last = std::min(frame.atoms, first + lines_a_piece);
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t begin = walker.offset();
            const Atom atom = reader.read(begin, walker.step(), i);
            atoms.spheres[i] = atom.sphere;
            if (!atoms.species.empty()) atoms.species[i] = atom.species;
            if (atom.is_virtual) virtual_sites[piece].push_back(i);
        }
        largest_colors[piece] = reader.largest_color();
    });
    for (const auto& of_piece : virtual_sites) {
        atoms.virtual_sites.insert(atoms.virtual_sites.end(), of_piece.begin(), of_piece.end());
    }
    for (const double largest : largest_colors) atoms.largest_color = std::max(atoms.largest_color, largest);
    return atoms;
}

SphereData read_frame(const TextSource& source, const Frame& frame, char line_end, const DataOptions& options) {
    require_memory(frame.atoms * sizeof(Sphere), source.name + ": " + in_groups(frame.atoms) + " spheres need");
    XyzLayout layout = xyz_layout({source.name, source.text.substr(0, frame.comment_end), source.origin}, frame.comment);
    Atoms atoms = read_atoms(source, frame, layout, line_end, options);
    if (layout.full_color == 1.0 && atoms.largest_color > most_of_one) {
        layout.full_color = color_max;
        atoms = read_atoms(source, frame, layout, line_end, options);
    }
    SphereData data;
    data.scene.spheres = std::move(atoms.spheres);
    for (std::size_t i = 0; i < atoms.species.size(); ++i) {
        if (atoms.species[i].empty()) continue;
        data.scene.names.emplace_hint(data.scene.names.end(), static_cast<std::uint32_t>(i), name_of(atoms.species[i]));
    }
    warn_of_virtual_sites(data, atoms.virtual_sites.size(), source.name, options);
    if (!options.virtual_sites) remove_spheres(data.scene, atoms.virtual_sites);
    return data;
}

// Whether the text is nothing but points: its first lines have as many words each, of which the first three are numbers. A frame
// begins with a number of atoms, and the lines behind it are others.
bool is_bare(std::string_view text) {
    constexpr int lines_looked_at = 3;
    std::size_t words_a_line = 0;
    for (int line = 0; line < lines_looked_at;) {
        text = trimmed(text, white_space);
        if (text.empty()) break;
        const std::string_view next = take_line(text);
        if (is_comment(next)) continue;
        const auto words = words_of(next);
        const auto is_number = [](std::string_view word) {
            double ignored = 0.0;
            return parse_any_double(word, ignored) == NumberFault::none;
        };
        if (words.size() < 3 || !std::all_of(words.begin(), words.begin() + 3, is_number)) return false;
        if (line > 0 && words.size() != words_a_line) return false;
        words_a_line = words.size();
        ++line;
    }
    return words_a_line > 0;
}

// A line `x y z ...` for each point; what stands behind is passed over.
Scene read_points(const TextSource& source, const DataOptions& options) {
    const char line_end = line_end_of(source.text);
    const auto count = static_cast<std::size_t>(std::ranges::count(source.text, line_end)) + 1;
    require_memory(count * sizeof(Sphere), source.name + ": " + in_groups(count) + " spheres need");
    Scene scene;
    scene.spheres.reserve(count);
    TextSource line{source.name, {}, source.origin};
    for (LineWalker walker(source.text, line_end); !walker.at_end();) {
        const std::size_t begin = walker.offset();
        line.text = source.text.substr(0, walker.step());
        TokenReader reader(line, begin, line_ends, parse_any_double);
        if (reader.at_end() || is_comment(reader.token())) continue;
        const auto of_point = [&](const char* what) {
            return [&scene, what] { return what + std::to_string(scene.spheres.size()); };
        };
        Sphere sphere{.radius = options.radius.value_or(1.0), .color = {color_max, color_max, color_max}};
        sphere.center.x = reader.number(of_point("the x of point "));
        sphere.center.y = reader.number(of_point("the y of point "));
        sphere.center.z = reader.number(of_point("the z of point "));
        scene.spheres.push_back(sphere);
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
    head = trimmed(head, white_space);
    const auto count = words_of(take_line(head));
    const std::string_view comment_line = take_line(head);
    const auto comment = words_of(comment_line);
    const auto atom = words_of(take_line(head));
    if (count.empty() || !is_whole(count[0]) || atom.empty()) return false;
    if (count.size() > 1) return !is_number(count[1]) && is_letter(atom[0][0]) && atom.size() > 3;
    if (comment.size() == 3 && std::all_of(comment.begin(), comment.end(), is_whole)) return false;
    if (lower_case(comment_line).find("properties=") != std::string::npos || is_letter(atom[0][0])) return true;
    return atom.size() > 3 && is_whole(atom[0]) && !comment.empty() && !is_number(comment[0]);
}

SphereData read_xyz(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content)};
    if (is_bare(source.text)) {
        require_frame(name, options.frame, 1);
        SphereData data{read_points(source, options)};
        if (!options.radius) use_radius_of_points(data, name);
        return data;
    }
    FrameFinder finder(source);
    Frame wanted;
    std::int64_t frames = 0;
    std::string fault;
    while (true) {
        Frame frame;
        frame.number = frames;
        try {
            if (!finder.next(frame, frames == options.frame)) break;
        } catch (const InputError& error) {
            if (frames <= options.frame) throw;
            fault = error.what();
            break;
        }
        if (frames == options.frame) wanted = std::move(frame);
        ++frames;
    }
    if (frames == 0) TokenReader(source, 0).fail_at_end("the text is empty", "the number of atoms of frame 0");
    require_frame(name, options.frame, frames);
    SphereData data = read_frame(source, wanted, finder.line_end(), options);
    data.frames = frames;
    if (!finder.vectors().empty()) data.warnings.push_back(finder.vectors() + " behind the atoms; the lattice is passed over");
    if (!fault.empty()) data.warnings.push_back(fault + "; what follows frame " + std::to_string(frames - 1) + " is passed over");
    return data;
}

}  // namespace sphereview
