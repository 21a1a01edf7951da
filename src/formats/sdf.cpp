// SDF and MOL: molecules of three lines of title, a line of counts, and atoms `x y z SYMBOL ...` (V2000) or
// `M  V30 INDEX SYMBOL x y z ...` (V3000). In an SDF each ends with `$$$$` and is a frame.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
#include "formats/elements.hpp"

namespace sphereview {

namespace {

constexpr std::string_view record_end = "$$$$";
constexpr std::size_t count_columns = 3;  // of each number in the line of counts

struct MolFrame {
    AtomLines atoms{};
    bool is_v3000 = false;
    std::size_t behind_atoms = 0;  // where the next line begins
};

// Whether a line of V3000 goes on in the next one.
bool ends_in_hyphen(std::string_view line, std::string_view) { return trimmed(line, white_space).ends_with('-'); }

constexpr std::size_t words_of_atom = 4;  // of V2000: x y z SYMBOL

// The text of an atom of V3000 that goes on in further lines, as one: a line may end within a number. `line`: the first.
std::string joined_lines(const TextSource& source, char line_end, std::string_view line) {
    constexpr std::string_view head = "M  V30 ";
    std::string joined;
    bool goes_on = true;
    for (LineWalker walker(source.text, line_end, source.offset_of(line)); goes_on && !walker.at_end();) {
        line = walker.step();
        goes_on = ends_in_hyphen(line, {});
        std::string_view words = goes_on ? line.substr(0, line.rfind('-')) : line;
        if (!joined.empty() && words.starts_with(head)) words.remove_prefix(head.size());
        joined += words;
    }
    return joined;
}

// Whether a line of V2000 has three numbers and more in an atom's columns: then it is no bond, whose columns are narrower.
bool is_in_columns_of_atom(std::string_view line) {
    return is_number(in_columns(line, 0, 10)) && is_number(in_columns(line, 10, 20)) && is_number(in_columns(line, 20, 30)) &&
           !in_columns(line, 31, 34).empty();
}

class MoleculeFinder : public FrameFinder {
public:
    using Frame = MolFrame;
    using FrameFinder::FrameFinder;

    bool next(MolFrame& frame, std::int64_t number, bool wanted) {
        if (nothing_follows()) return false;
        begin_frame(number);
        for (int title = 0; title < 3; ++title) step("the line of counts");
        const std::string_view counts = step("the line of counts");
        frame.is_v3000 = counts.find("V3000") != std::string_view::npos;
        const std::size_t count = frame.is_v3000 ? v3000_count() : v2000_count(counts);
        frame.atoms = step_over(count, wanted, frame.is_v3000 ? ends_in_hyphen : nullptr);
        frame.behind_atoms = offset();
        if (!frame.is_v3000) refuse_more_atoms(count);
        while (!at_end() && !walker_.step().starts_with(record_end)) {
        }
        return true;
    }

private:
    // The line of counts may say fewer atoms of V2000 than there are.
    void refuse_more_atoms(std::size_t count) {
        if (at_end()) return;
        const std::string_view line = LineWalker(walker_).step();
        std::vector<std::string_view> words;
        split_line(line, words_of_atom, words);
        const bool has_symbol =
            words.size() == words_of_atom && std::all_of(words.begin(), words.end() - 1, is_number) && !is_number(words.back());
        if (!has_symbol && !is_in_columns_of_atom(line)) return;
        source_.fail_at(line, "found a line of an atom behind " + std::to_string(count) + " of " + std::to_string(count) +
                                  ", expected a bond or M  END" + of_frame());
    }

    // In columns, because 100100 is two numbers.
    std::size_t v2000_count(std::string_view line) const {
        std::size_t count = 0;
        if (parse_whole(trimmed(line.substr(0, count_columns), " "), count)) return count;
        const auto words = words_of(line.substr(0, longest_line));
        if (!words.empty() && words[0].size() < count_columns && parse_whole(words[0], count)) return count;
        source_.fail(line.substr(0, count_columns), "the number of atoms" + of_frame() + " in columns 1 to 3");
    }

    std::size_t v3000_count() {
        std::size_t count = 0;
        bool has_count = false;
        while (true) {
            const std::string_view line = step("M  V30 BEGIN ATOM");
            if (line.starts_with("M  END") || line.starts_with(record_end)) source_.fail(line, "M  V30 BEGIN ATOM" + of_frame());
            const auto words = words_of(line.substr(0, longest_line));
            if (words.size() > 3 && words[2] == "COUNTS") {
                if (!parse_whole(words[3], count) || count > most_spheres)
                    source_.fail(words[3], "the number of atoms" + of_frame());
                has_count = true;
            }
            // A molecule without atoms may leave their block out.
            if (has_count && count == 0) return 0;
            if (words.size() > 3 && words[2] == "BEGIN" && words[3] == "ATOM") {
                if (!has_count) source_.fail(line, "M  V30 COUNTS" + of_frame() + " above it");
                return count;
            }
        }
    }

    static constexpr std::size_t longest_line = 256;
};

// Whether the places of V2000 seem to touch: they may fill their ten columns.
bool touch(const std::vector<std::string_view>& words) {
    constexpr std::size_t width = 10;
    return std::ranges::any_of(words, [](std::string_view word) { return word.size() > width && !is_number(word); });
}

// Reads the lines of one piece.
class MolAtomReader {
public:
    MolAtomReader(const TextSource& source, const MolFrame& frame, const DataOptions& options)
        : source_(source), frame_(frame), options_(options) {}

    LineAtom read(std::string_view line, std::size_t index) {
        if (frame_.is_v3000) return ends_in_hyphen(line, {}) ? read_joined(line, index) : read_v3000(source_, line, index);
        const OfAtom the{index, frame_.atoms.count};
        LineAtom atom;
        refuse_bond(line, index);
        if (touch(words_) && is_in_columns_of_atom(line)) {
            for (int axis = 0; axis < 3; ++axis) {
                const auto begin = static_cast<std::size_t>(10 * axis);
                parse_any_double(in_columns(line, begin, begin + 10), atom.sphere.center[axis]);
            }
            atom.label = in_columns(line, 31, 34);
        } else {
            TokenReader reader(source_, line, parse_any_double);
            atom.sphere.center = read_place(reader, the);
            atom.label = reader.word(the("symbol"));
        }
        show_as(atom, element_of_species(atom.label), options_);
        return atom;
    }

private:
    LineAtom read_v3000(const TextSource& source, std::string_view line, std::size_t index) const {
        const OfAtom the{index, frame_.atoms.count};
        TokenReader reader(source, line, parse_any_double);
        LineAtom atom;
        reader.skip_tokens(3);  // M V30 and the index
        atom.label = reader.word(the("symbol"));
        atom.sphere.center = read_place(reader, the);
        show_as(atom, element_of_species(atom.label), options_);
        return atom;
    }

    LineAtom read_joined(std::string_view line, std::size_t index) const {
        const std::string joined = joined_lines(source_, frame_.atoms.line_end, line);
        const TextSource lines{source_.name, joined, position_at(source_.text, source_.offset_of(line), source_.origin)};
        LineAtom atom = read_v3000(lines, lines.text, index);
        // A label stays longer than the joined text.
        const auto words = words_of(line);
        const bool is_in_first = words.size() > 3 && words[3] == atom.label;
        atom.label = is_in_first ? words[3] : element_of_species(atom.label).symbol;
        return atom;
    }

    // The line of counts may say more atoms than there are.
    void refuse_bond(std::string_view line, std::size_t index) {
        words_.clear();
        split_line(line, words_of_atom, words_);
        const bool is_bond = words_.size() == words_of_atom && std::ranges::all_of(words_, is_digits);
        if (!is_bond || is_in_columns_of_atom(line)) return;
        source_.fail_at(line, "found a line of a bond, expected" + of_atom(index, frame_.atoms.count).substr(3));
    }

    const TextSource& source_;
    const MolFrame& frame_;
    const DataOptions& options_;
    std::vector<std::string_view> words_{};
};

// The charges that lines `M  CHG` behind the bonds of V2000 say, by the atom's index. They stand for all of the molecule: others
// that stand beside atoms count no longer.
std::map<std::size_t, std::string_view> listed_charges(const TextSource& source, const MolFrame& frame) {
    constexpr std::size_t most_words = 32;
    std::map<std::size_t, std::string_view> charges;
    for (LineWalker walker(source.text, frame.atoms.line_end, frame.behind_atoms); !walker.at_end();) {
        const std::string_view line = walker.step();
        if (line.starts_with("M  END") || line.starts_with(record_end)) break;
        if (!line.starts_with("M  CHG")) continue;
        std::vector<std::string_view> words;
        split_line(line, most_words, words);
        // M CHG COUNT, and then an atom's number and its charge, and so on.
        for (std::size_t i = 3; i + 1 < words.size(); i += 2) {
            std::size_t number = 0;
            if (parse_whole(words[i], number) && number > 0) charges[number - 1] = words[i + 1];
        }
    }
    return charges;
}

// What a number beside an atom of V2000 means: 4 is a radical.
std::string_view charge_of_code(std::string_view code) {
    static constexpr std::array<std::string_view, 8> charges = {"0", "3", "2", "1", "0", "-1", "-2", "-3"};
    std::size_t number = 0;
    return parse_whole(code, number) && number < charges.size() ? charges.at(number) : charges[0];
}

// CHG=-1 among the words of an atom of V3000, which may go on in further lines. `line`: the first.
std::string_view named_charge(const TextSource& source, char line_end, std::string_view line) {
    constexpr std::size_t most_words = 64;
    constexpr std::string_view key = "CHG=";
    bool goes_on = true;
    for (LineWalker walker(source.text, line_end, source.offset_of(line)); goes_on && !walker.at_end();) {
        line = walker.step();
        std::vector<std::string_view> words;
        split_line(line, most_words, words);
        for (const std::string_view word : words) {
            if (word.starts_with(key)) return word.substr(key.size());
        }
        goes_on = ends_in_hyphen(line, {});
    }
    return "0";
}

FileProperties read_mol_properties(const TextSource& source, const MolFrame& frame, const DataOptions& options) {
    constexpr std::size_t symbol_place = 3;  // of both versions
    constexpr std::size_t code_place = 5;
    const std::vector<PropertyColumn> columns = {{"element", PropertyKind::element, 0}, {"charge", PropertyKind::whole, 1}};
    const bool may_be_listed = !frame.is_v3000 && is_wanted(options, "charge", frame.atoms.count);
    const auto listed = may_be_listed ? listed_charges(source, frame) : std::map<std::size_t, std::string_view>();
    std::vector<std::string_view> words;
    const auto fields = [&](std::string_view line, std::size_t index, std::size_t most, std::vector<std::string_view>& out) {
        const auto word = [&](std::size_t place) { return place < words.size() ? words[place] : std::string_view(); };
        words.clear();
        split_line(line, code_place + 1, words);
        const bool columns_count = !frame.is_v3000 && touch(words) && is_in_columns_of_atom(line);
        out.push_back(columns_count ? in_columns(line, 31, 34) : word(symbol_place));
        if (most < 2) return;
        const auto found = listed.find(index);
        if (frame.is_v3000) {
            out.push_back(named_charge(source, frame.atoms.line_end, line));
        } else if (listed.empty()) {
            out.push_back(charge_of_code(columns_count ? in_columns(line, 36, 39) : word(code_place)));
        } else {
            out.push_back(found == listed.end() ? "0" : found->second);
        }
    };
    return read_line_properties(source, frame.atoms, columns, options, fields);
}

SphereData read_mol_frame(const TextSource& source, const MolFrame& frame, const DataOptions& options) {
    const auto reader = [&](std::size_t) { return MolAtomReader(source, frame, options); };
    Atoms atoms = read_atom_lines(source, frame.atoms, reader);
    atoms.properties = read_mol_properties(source, frame, options);
    return data_of(std::move(atoms), source.name, options, name_of_species);
}

}  // namespace

bool shows_sdf(std::string_view head) {
    for (int title = 0; title < 3; ++title) take_line(head);
    const std::string_view counts = trimmed(take_line(head));
    return counts.ends_with("V2000") || counts.ends_with("V3000");
}

SphereData read_sdf(std::string_view content, const std::string& name, const DataOptions& options) {
    return read_frame_of<MoleculeFinder>(content, name, options, "three lines of title", read_mol_frame);
}

std::optional<std::size_t> step_over_sdf(std::string_view text, bool ended, const std::string& name, PartOfFile& part) {
    return step_over_frame<MoleculeFinder>(text, ended, name, part, read_mol_frame);
}

}  // namespace sphereview
