// VASP's POSCAR and CONTCAR: a title, a scale, the three edges of the cell, the symbols of the elements (not in VASP 4) and how
// many atoms each has, how the places are meant, and a line for each atom. XDATCAR has `Direct configuration= N` above each frame,
// and where the cell changes all of the head again.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
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

// "Direct configuration=     1"
bool is_configuration(std::string_view line) {
    const std::string words = lower_case(line);
    return words.find("configuration") != std::string::npos && has_word_first(line);
}

class PoscarFinder : public FrameFinder {
public:
    using Frame = PoscarFrame;

    PoscarFinder(const TextSource& source, const PartOfFile& part) : FrameFinder(source, part) {
        if (part.head.empty()) return;
        const TextSource before{source.name, part.head};
        PoscarFinder other(before, {});
        other.read_head();
        head_ = other.head_;
    }

    bool next(PoscarFrame& frame, std::int64_t number, bool wanted) {
        begin_frame(number);
        // What follows a POSCAR is velocities and more, and no frame.
        const bool is_xdatcar = of_first_ > 0;
        if (number > 0 && !is_xdatcar) return false;
        if (nothing_follows()) return false;
        std::size_t head_frame = of_first_;
        if (number == 0 || !is_configuration(LineWalker(walker_).step())) {
            read_head();
            head_frame = static_cast<std::size_t>(number) + 1;
        }
        frame = head_;
        std::string_view mode = words("Direct or Cartesian");
        if (begins_with(mode, "sS")) mode = words("Direct or Cartesian");  // Selective dynamics
        if (!has_word_first(mode)) source_.fail(mode, "Direct or Cartesian" + of_frame());
        if (is_xdatcar || is_configuration(mode)) of_first_ = head_frame;
        frame.direct = !begins_with(mode, "cCkK");
        frame.atoms = step_over(frame.groups.empty() ? 0 : frame.groups.back().end, wanted);
        return true;
    }

private:
    static bool begins_with(std::string_view line, std::string_view letters) {
        return !line.empty() && letters.find(line[0]) != std::string_view::npos;
    }

    // What the next line holds, which should be `expected`.
    std::string_view words(const char* expected) {
        const std::string_view line = step(expected);
        const std::string_view inside = trimmed(line, white_space);
        return inside.empty() ? line : inside;  // which a message shows
    }

    // `count` numbers that `line` begins with.
    template <std::size_t count>
    std::array<double, count> numbers_in(std::string_view line, const char* what) const {
        TokenReader reader(source_, line, parse_any_double);
        std::array<double, count> numbers{};
        for (double& number : numbers) number = reader.number([&] { return what + of_frame(); });
        return numbers;
    }

    void read_head() {
        head_ = {};
        const std::string_view title = words("a title");
        const std::string_view scale_line = words("the scale");
        const auto scale_words = words_of(scale_line);
        const bool has_three = scale_words.size() >= 3 && std::all_of(scale_words.begin(), scale_words.begin() + 3, is_number);
        if (has_three) {
            head_.scale = numbers_in<3>(scale_line, "the scale");
        } else {
            head_.scale.fill(numbers_in<1>(scale_line, "the scale")[0]);
        }
        for (glm::dvec3* edge : {&head_.cell.a, &head_.cell.b, &head_.cell.c}) {
            const auto numbers = numbers_in<3>(words("an edge of the cell"), "an edge of the cell");
            *edge = {numbers[0], numbers[1], numbers[2]};
        }
        scale_cell(scale_line, has_three);

        std::string_view line = words("the symbols or numbers of atoms");
        std::vector<std::string_view> symbols;
        if (has_word_first(line)) {
            symbols = words_of(line.substr(0, longest_head));
            line = words("the numbers of atoms");
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
            source_.fail(line, (has_three ? "three scales above 0" : "a scale above 0, or a volume below 0") + of_frame());
        }
        if (head_.scale[0] < 0.0) {
            const double part = -head_.scale[0] / std::abs(head_.cell.volume());
            if (!std::isfinite(part) || !(part > 0.0))
                source_.fail(line, "a scale above 0: the edges" + of_frame() + " span no volume");
            head_.scale.fill(cube_root(part));
        }
        for (glm::dvec3* edge : {&head_.cell.a, &head_.cell.b, &head_.cell.c}) {
            *edge = {head_.scale[0] * edge->x, head_.scale[1] * edge->y, head_.scale[2] * edge->z};
        }
    }

    void read_groups(std::string_view line) {
        const auto expected = [&] { return "the numbers of atoms" + of_frame(); };
        TokenReader reader(source_, line);
        std::size_t end = 0;
        do {
            if (end > 0 && begins_with(reader.token(), "!#")) break;
            end += static_cast<std::size_t>(reader.integer(0, static_cast<std::int64_t>(most_spheres - end), expected));
            if (head_.groups.size() == most_groups) reader.fail("at most " + std::to_string(most_groups) + " numbers of atoms");
            head_.groups.push_back({end});
        } while (!reader.at_end());
    }

    PoscarFrame head_{};
};

// Reads the lines of one piece.
class PoscarAtomReader {
public:
    PoscarAtomReader(const TextSource& source, const PoscarFrame& frame, const DataOptions& options)
        : source_(source), frame_(frame), options_(options) {}

    LineAtom read(std::string_view line, std::size_t index) {
        const std::size_t count = frame_.atoms.count;
        TokenReader reader(source_, line, parse_any_double);
        const glm::dvec3 place = read_place(reader, {index, count});
        LineAtom atom;
        const auto& [x, y, z] = frame_.scale;
        atom.sphere.center = frame_.direct ? frame_.cell.place(place) : glm::dvec3(x * place.x, y * place.y, z * place.z);
        require_finite(source_, line, atom.sphere.center, index, count);
        const PoscarGroup& group = frame_.group_of(index);
        const Element& element = group.symbol.empty() ? unknown_element() : element_of_species(group.symbol);
        // "Fe_pv" and "Fe/2f1c0b" are names of potentials.
        atom.label = group.symbol.substr(0, group.symbol.find_first_of("_/"));
        show_as(atom, element, options_);
        return atom;
    }

private:
    const TextSource& source_;
    const PoscarFrame& frame_;
    const DataOptions& options_;
};

SphereData read_poscar_frame(const TextSource& source, const PoscarFrame& frame, const DataOptions& options) {
    const auto reader = [&](std::size_t) { return PoscarAtomReader(source, frame, options); };
    Atoms atoms = read_atom_lines(source, frame.atoms, reader);
    const auto symbol = [&](std::string_view, std::size_t index, std::size_t, std::vector<std::string_view>& fields) {
        fields.push_back(frame.group_of(index).symbol);
    };
    atoms.properties = read_line_properties(source, frame.atoms, {{"element", PropertyKind::element, 0}}, options, symbol);
    return data_of(std::move(atoms), source.name, options, name_of_species);
}

}  // namespace

// A title, a scale, three edges, and then the symbols or numbers of the atoms, and how their places are meant.
bool shows_poscar(std::string_view head) {
    std::array<std::string_view, 8> lines{};
    for (std::string_view& line : lines) line = take_line(head);
    const auto are_numbers = [](const std::vector<std::string_view>& words, std::size_t count) {
        return words.size() == count && std::ranges::all_of(words, is_number);
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
    return read_frame_of<PoscarFinder>(content, name, options, "a title", read_poscar_frame);
}

std::optional<std::size_t> step_over_poscar(std::string_view text, bool ended, const std::string& name, PartOfFile& part) {
    // A title may be blank, so what comes tells whether a frame does.
    if (!ended && trimmed(text, white_space).empty()) return std::nullopt;
    return step_over_frame<PoscarFinder>(text, ended, name, part, read_poscar_frame);
}

}  // namespace sphereview
