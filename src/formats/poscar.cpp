// VASP's POSCAR and CONTCAR: a title, a scale, the three edges of the cell, the symbols of the elements (not in VASP 4) and how
// many atoms each has, how the places are meant, and a line for each atom. XDATCAR has `Direct configuration= N` above each frame,
// and where the cell changes all of the head again.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
#include "formats/atoms.hpp"
#include "formats/cell.hpp"
#include "formats/elements.hpp"

namespace sphereview {

namespace {

// The atoms that stand together for one element.
struct PoscarGroup {
    std::size_t end = 0;        // the number of atoms up to there
    std::string_view symbol{};  // "" where the file does not say
};

constexpr std::size_t longest_head = 1 << 16;  // what is looked at of a line that names elements
constexpr std::size_t most_groups = 10'000;

// How places are meant that are not parts of the cell's edges: times this.
using PoscarScale = std::array<double, 3>;

struct PoscarFrame {
    Cell cell{};
    PoscarScale scale{1.0, 1.0, 1.0};
    std::vector<PoscarGroup> groups{};
    bool direct = true;  // places are parts of the edges
    AtomLines atoms{};

    const PoscarGroup& group_of(std::size_t atom) const { return *std::ranges::upper_bound(groups, atom, {}, &PoscarGroup::end); }
};

bool has_word_first(std::string_view text) {
    text = trimmed(text, white_space);
    return !text.empty() && is_letter(text[0]);
}

bool are_whole(const std::vector<std::string_view>& words) {
    std::size_t ignored = 0;
    return !words.empty() && std::ranges::all_of(words, [&](std::string_view word) { return parse_whole(word, ignored); });
}

bool is_any_number(std::string_view word) {
    double ignored = 0.0;
    return parse_any_double(word, ignored) == NumberFault::none;
}

// "Direct configuration=     1"
bool is_configuration(std::string_view line) {
    const std::string words = lower_case(line);
    return words.find("configuration") != std::string::npos && has_word_first(line);
}

// Finds the frames of a text without looking at their atoms.
class PoscarFinder {
public:
    PoscarFinder(const TextSource& source, char line_end) : source_(source), walker_(source.text, line_end) {}

    // Steps over the next frame, number `number` from 0; false when there is none.
    bool next(PoscarFrame& frame, std::int64_t number, bool wanted) {
        of_frame_ = " of frame " + std::to_string(number);
        // What follows a POSCAR is velocities and more, and no frame.
        if (number > 0 && !has_frames_) return false;
        if (source_.text.find_first_not_of(white_space, walker_.offset()) == std::string_view::npos) return false;
        if (number == 0 || !is_configuration(peek())) read_head();
        frame = head_;
        std::string_view mode = step("Direct or Cartesian");
        if (begins_with(mode, "sS")) mode = step("Direct or Cartesian");  // Selective dynamics
        if (!has_word_first(mode)) source_.fail(mode, "Direct or Cartesian" + of_frame_);
        has_frames_ = has_frames_ || is_configuration(mode);
        frame.direct = !begins_with(mode, "cCkK");
        frame.atoms = step_over_atoms(source_, walker_, frame.groups.empty() ? 0 : frame.groups.back().end, wanted, of_frame_);
        return true;
    }

private:
    static bool begins_with(std::string_view line, std::string_view letters) {
        return !line.empty() && letters.find(line[0]) != std::string_view::npos;
    }

    std::string_view peek() const {
        std::string_view rest = source_.text.substr(walker_.offset());
        return take_line(rest);
    }

    // The next line, which should be `expected`.
    std::string_view step(const char* expected) {
        if (walker_.at_end()) source_.fail(source_.text.size(), std::string("the text ends, expected ") + expected + of_frame_);
        const std::size_t begin = walker_.offset();
        const std::string_view line = source_.text.substr(0, walker_.step()).substr(begin);
        const std::string_view words = trimmed(line, white_space);
        return words.empty() ? line : words;  // which a message shows
    }

    // `count` numbers that `line` begins with.
    template <std::size_t count>
    std::array<double, count> numbers_in(std::string_view line, const char* what) const {
        const auto begin = static_cast<std::size_t>(line.data() - source_.text.data());
        const TextSource up_to_end{source_.name, source_.text.substr(0, begin + line.size())};
        TokenReader reader(up_to_end, begin, line_ends, parse_any_double);
        std::array<double, count> numbers{};
        for (double& number : numbers) number = reader.number([&] { return what + of_frame_; });
        return numbers;
    }

    void read_head() {
        head_ = {};
        const std::string_view title = step("a title");
        const std::string_view scale_line = step("the scale");
        const auto scale_words = words_of(scale_line);
        const bool has_three = scale_words.size() >= 3 && std::all_of(scale_words.begin(), scale_words.begin() + 3, is_any_number);
        if (has_three) {
            head_.scale = numbers_in<3>(scale_line, "the scale");
        } else {
            head_.scale.fill(numbers_in<1>(scale_line, "the scale")[0]);
        }
        for (glm::dvec3* edge : {&head_.cell.a, &head_.cell.b, &head_.cell.c}) {
            const auto numbers = numbers_in<3>(step("an edge of the cell"), "an edge of the cell");
            *edge = {numbers[0], numbers[1], numbers[2]};
        }
        scale_cell(scale_line, has_three);

        std::string_view line = step("the symbols or numbers of atoms");
        std::vector<std::string_view> symbols;
        if (has_word_first(line)) {
            symbols = words_of(line.substr(0, longest_head));
            line = step("the numbers of atoms");
        }
        read_groups(line);
        // In VASP 4 the title often names the elements.
        if (symbols.empty()) {
            symbols = words_of(title.substr(0, longest_head));
            const auto is_element = [](std::string_view word) { return find_element(word) != nullptr; };
            if (symbols.size() != head_.groups.size() || !std::ranges::all_of(symbols, is_element)) symbols.clear();
        }
        for (std::size_t i = 0; i < std::min(symbols.size(), head_.groups.size()); ++i) head_.groups[i].symbol = symbols[i];
    }

    // A scale below 0 is the volume that the cell shall have.
    void scale_cell(std::string_view line, bool has_three) {
        const auto is_bad = [&](double scale) { return has_three ? !(scale > 0.0) : scale == 0.0; };
        if (std::ranges::any_of(head_.scale, is_bad)) {
            source_.fail(line, (has_three ? "three scales above 0" : "a scale above 0, or a volume below 0") + of_frame_);
        }
        if (head_.scale[0] < 0.0) {
            const double part = -head_.scale[0] / std::abs(head_.cell.volume());
            if (!std::isfinite(part) || !(part > 0.0))
                source_.fail(line, "a scale above 0: the edges" + of_frame_ + " span no volume");
            head_.scale.fill(cube_root(part));
        }
        for (glm::dvec3* edge : {&head_.cell.a, &head_.cell.b, &head_.cell.c}) {
            *edge = {head_.scale[0] * edge->x, head_.scale[1] * edge->y, head_.scale[2] * edge->z};
        }
    }

    void read_groups(std::string_view line) {
        const auto begin = static_cast<std::size_t>(line.data() - source_.text.data());
        const TextSource up_to_end{source_.name, source_.text.substr(0, begin + line.size())};
        const auto expected = [&] { return "the numbers of atoms" + of_frame_; };
        TokenReader reader(up_to_end, begin, line_ends);
        std::size_t end = 0;
        do {
            if (end > 0 && begins_with(reader.token(), "!#")) break;
            end += static_cast<std::size_t>(reader.integer(0, static_cast<std::int64_t>(most_spheres - end), expected));
            if (head_.groups.size() == most_groups) reader.fail("at most " + std::to_string(most_groups) + " numbers of atoms");
            head_.groups.push_back({end});
        } while (!reader.at_end());
    }

    const TextSource& source_;
    LineWalker walker_;
    std::string of_frame_{};
    PoscarFrame head_{};
    bool has_frames_ = false;  // it is an XDATCAR
};

// Reads the lines of one piece.
class PoscarAtomReader {
public:
    PoscarAtomReader(const TextSource& source, const PoscarFrame& frame, const DataOptions& options)
        : text_(source.text), line_{source.name, {}}, frame_(frame), options_(options) {}

    LineAtom read(std::size_t begin, std::size_t end, std::size_t index) {
        line_.text = text_.substr(0, end);
        const std::size_t count = frame_.atoms.count;
        TokenReader reader(line_, begin, line_ends, parse_any_double);
        glm::dvec3 place;
        for (int axis = 0; axis < 3; ++axis) {
            place[axis] = reader.number([&] { return std::string("the ") + "xyz"[axis] + of_atom(index, count); });
        }
        LineAtom atom;
        glm::dvec3& center = atom.sphere.center;
        center = place;
        for (int axis = 0; axis < 3; ++axis) center[axis] = frame_.scale[static_cast<std::size_t>(axis)] * place[axis];
        if (frame_.direct) center = frame_.cell.place(place);
        require_finite(line_, begin, center, index, count);
        const PoscarGroup& group = frame_.group_of(index);
        const Element& element = group.symbol.empty() ? unknown_element() : element_of_species(group.symbol);
        // "Fe_pv" and "Fe/2f1c0b" are names of potentials.
        atom.label = group.symbol.substr(0, group.symbol.find_first_of("_/"));
        show_as(atom, element, options_);
        return atom;
    }

private:
    std::string_view text_;
    TextSource line_;  // the text up to the line's end
    const PoscarFrame& frame_;
    const DataOptions& options_;
};

}  // namespace

// A title, a scale, three edges, and then the symbols or numbers of the atoms, and how their places are meant.
bool shows_poscar(std::string_view head) {
    std::array<std::string_view, 8> lines{};
    for (std::string_view& line : lines) line = take_line(head);
    const auto are_numbers = [](const std::vector<std::string_view>& words, std::size_t count) {
        return words.size() == count && std::ranges::all_of(words, is_any_number);
    };
    const auto scale = words_of(lines[1]);
    if (!are_numbers(scale, 1) && !are_numbers(scale, 3)) return false;
    for (std::size_t i = 2; i < 5; ++i) {
        if (!are_numbers(words_of(lines[i]), 3)) return false;
    }
    const std::size_t counts = has_word_first(lines[5]) ? 6 : 5;
    return are_whole(words_of(lines[counts])) && has_word_first(lines[counts + 1]);
}

SphereData read_poscar(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content)};
    const char line_end = line_end_of(source.text);
    PoscarFinder finder(source, line_end);
    const auto next = [&](PoscarFrame& frame, std::int64_t number, bool wanted) { return finder.next(frame, number, wanted); };
    const FoundFrame<PoscarFrame> found = find_frame<PoscarFrame>(name, options, next);
    if (found.frames == 0) source.fail(source.text.size(), "the text is empty, expected a title of frame 0");
    const AtomLines& lines = found.frame.atoms;
    require_memory(lines.count * sizeof(Sphere), name + ": " + in_groups(lines.count) + " spheres need");
    const auto reader = [&](std::size_t) { return PoscarAtomReader(source, found.frame, options); };
    Atoms atoms = read_atom_lines(source, lines, line_end, reader);
    const auto element = [&](std::size_t, std::size_t, std::size_t index, std::size_t, std::vector<std::string_view>& fields) {
        fields.push_back(found.frame.group_of(index).symbol);
    };
    atoms.properties = read_line_properties(source, lines, line_end, {{"element", PropertyKind::element, 0}}, options, element);
    SphereData data = data_of(std::move(atoms), name, options, name_of_species);
    note_frames(data, found);
    return data;
}

}  // namespace sphereview
