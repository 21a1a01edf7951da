// SDF and MOL: molecules of three lines of title, a line of counts, and atoms `x y z SYMBOL ...` (V2000) or
// `M  V30 INDEX SYMBOL x y z ...` (V3000). In an SDF each ends with `$$$$` and is a frame.
#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <vector>

#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
#include "formats/atoms.hpp"
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

// Such a line of V3000 goes on in the next one.
bool ends_in_hyphen(std::string_view line, std::string_view) { return trimmed(line, white_space).ends_with('-'); }

bool is_double(std::string_view word) {
    double ignored = 0.0;
    return parse_any_double(word, ignored) == NumberFault::none;
}

bool is_whole_number(std::string_view word) { return word.find_first_not_of("0123456789") == std::string_view::npos; }

constexpr std::size_t words_of_atom = 4;  // of V2000: x y z SYMBOL

bool is_bond(std::span<const std::string_view> words) {
    return words.size() == words_of_atom && std::ranges::all_of(words, is_whole_number);
}

// Finds the molecules of a text without looking at their atoms.
class MoleculeFinder {
public:
    MoleculeFinder(const TextSource& source, char line_end) : source_(source), walker_(source.text, line_end) {}

    bool at_end() const { return walker_.at_end(); }
    // Where the next line begins.
    std::size_t offset() const { return walker_.offset(); }

    // Steps over the next molecule, number `number` from 0; false when there is none.
    bool next(MolFrame& frame, std::int64_t number, bool wanted) {
        if (source_.text.find_first_not_of(white_space, walker_.offset()) == std::string_view::npos) return false;
        of_frame_ = " of frame " + std::to_string(number);
        for (int title = 0; title < 3; ++title) step("the line of counts");
        const std::string_view counts = step("the line of counts");
        frame.is_v3000 = counts.find("V3000") != std::string_view::npos;
        const std::size_t count = frame.is_v3000 ? v3000_count() : v2000_count(counts);
        frame.atoms = step_over_atoms(source_, walker_, count, wanted, of_frame_, frame.is_v3000 ? ends_in_hyphen : nullptr);
        frame.behind_atoms = walker_.offset();
        if (!frame.is_v3000) refuse_more_atoms(count);
        while (!walker_.at_end() && !step(record_end).starts_with(record_end)) {
        }
        return true;
    }

private:
    // The next line, in the way to `expected`.
    std::string_view step(std::string_view expected) {
        if (walker_.at_end()) {
            source_.fail_at_end(std::string(expected) + of_frame_);
        }
        const std::size_t begin = walker_.offset();
        return source_.text.substr(0, walker_.step()).substr(begin);
    }

    // The line of counts may say fewer atoms of V2000 than there are.
    void refuse_more_atoms(std::size_t count) {
        LineWalker behind = walker_;
        if (behind.at_end()) return;
        const std::size_t begin = behind.offset();
        std::vector<std::string_view> words;
        split_line(source_.text.substr(0, behind.step()).substr(begin), words_of_atom, words);
        const bool is_atom =
            words.size() == words_of_atom && std::all_of(words.begin(), words.end() - 1, is_double) && !is_double(words.back());
        if (!is_atom) return;
        source_.fail(begin, "found a line of an atom behind " + std::to_string(count) + " of " + std::to_string(count) +
                                ", expected a bond or M  END" + of_frame_);
    }

    // In columns, because 100100 is two numbers.
    std::size_t v2000_count(std::string_view line) const {
        std::size_t count = 0;
        if (parse_whole(trimmed(line.substr(0, count_columns), " "), count)) return count;
        const auto words = words_of(line.substr(0, longest_line));
        if (!words.empty() && words[0].size() < count_columns && parse_whole(words[0], count)) return count;
        source_.fail(line.substr(0, count_columns), "the number of atoms" + of_frame_ + " in columns 1 to 3");
    }

    std::size_t v3000_count() {
        std::size_t count = 0;
        bool has_count = false;
        while (true) {
            const std::string_view line = step("M  V30 BEGIN ATOM");
            if (line.starts_with("M  END") || line.starts_with(record_end)) source_.fail(line, "M  V30 BEGIN ATOM" + of_frame_);
            const auto words = words_of(line.substr(0, longest_line));
            if (words.size() > 3 && words[2] == "COUNTS") {
                if (!parse_whole(words[3], count) || count > most_spheres)
                    source_.fail(words[3], "the number of atoms" + of_frame_);
                has_count = true;
            }
            // A molecule without atoms may leave their block out.
            if (has_count && count == 0) return 0;
            if (words.size() > 3 && words[2] == "BEGIN" && words[3] == "ATOM") {
                if (!has_count) source_.fail(line, "M  V30 COUNTS" + of_frame_ + " above it");
                return count;
            }
        }
    }

    static constexpr std::size_t longest_line = 256;

    const TextSource& source_;
    LineWalker walker_;
    std::string of_frame_{};
};

// Reads the lines of one piece.
class MolAtomReader {
public:
    MolAtomReader(const TextSource& source, const MolFrame& frame, const DataOptions& options)
        : text_(source.text), line_{source.name, {}, source.origin}, frame_(frame), options_(options) {}

    LineAtom read(std::size_t begin, std::size_t end, std::size_t index) {
        line_.text = text_.substr(0, end);
        if (!frame_.is_v3000) refuse_bond(begin, index);
        const std::size_t count = frame_.atoms.count;
        TokenReader reader(line_, begin, line_ends, parse_any_double);
        const auto the = [index, count](const char* what) { return [index, count, what] { return what + of_atom(index, count); }; };
        LineAtom atom;
        if (frame_.is_v3000) {
            reader.skip_tokens(3);  // M V30 and the index
            atom.label = reader.word(the("the symbol"));
        }
        atom.sphere.center.x = reader.number(the("the x"));
        atom.sphere.center.y = reader.number(the("the y"));
        atom.sphere.center.z = reader.number(the("the z"));
        if (!frame_.is_v3000) atom.label = reader.word(the("the symbol"));
        show_as(atom, element_of_species(atom.label), options_);
        return atom;
    }

private:
    // The line of counts may say more atoms than there are.
    void refuse_bond(std::size_t begin, std::size_t index) {
        words_.clear();
        split_line(line_.text.substr(begin), words_of_atom, words_);
        if (!is_bond(words_)) return;
        line_.fail(begin, "found a line of a bond, expected" + of_atom(index, frame_.atoms.count).substr(3));
    }

    std::string_view text_;
    std::vector<std::string_view> words_{};
    TextSource line_;  // the text up to the line's end
    const MolFrame& frame_;
    const DataOptions& options_;
};

// The charges that lines `M  CHG` behind the bonds of V2000 say, by the atom's index. They stand for all of the molecule: others
// that stand beside atoms count no longer.
std::map<std::size_t, std::string_view> listed_charges(const TextSource& source, std::size_t behind_atoms, char line_end) {
    constexpr std::size_t most_words = 32;
    std::map<std::size_t, std::string_view> charges;
    LineWalker walker(source.text, line_end, behind_atoms);
    while (!walker.at_end()) {
        const std::size_t begin = walker.offset();
        const std::string_view line = source.text.substr(0, walker.step()).substr(begin);
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

// CHG=-1 among the words of an atom of V3000, which may go on in further lines.
std::string_view named_charge(const TextSource& source, std::size_t begin, char line_end) {
    constexpr std::size_t most_words = 64;
    constexpr std::string_view key = "CHG=";
    LineWalker walker(source.text, line_end, begin);
    while (!walker.at_end()) {
        const std::size_t start = walker.offset();
        const std::string_view line = source.text.substr(0, walker.step()).substr(start);
        std::vector<std::string_view> words;
        split_line(line, most_words, words);
        for (const std::string_view word : words) {
            if (word.starts_with(key)) return word.substr(key.size());
        }
        if (!ends_in_hyphen(line, {})) break;
    }
    return "0";
}

FileProperties read_mol_properties(const TextSource& source, const MolFrame& frame, char line_end, const DataOptions& options) {
    constexpr std::size_t symbol_place = 3;  // of both versions
    constexpr std::size_t code_place = 5;
    const std::vector<PropertyColumn> columns = {{"element", PropertyKind::element, 0}, {"charge", PropertyKind::whole, 1}};
    const bool are_wanted = !frame.is_v3000 && is_wanted(options, "charge", frame.atoms.count);
    const auto listed =
        are_wanted ? listed_charges(source, frame.behind_atoms, line_end) : std::map<std::size_t, std::string_view>();
    std::vector<std::string_view> words;
    const auto fields = [&](std::size_t begin, std::size_t end, std::size_t index, std::size_t most,
                            std::vector<std::string_view>& out) {
        const auto word = [&](std::size_t place) { return place < words.size() ? words[place] : std::string_view(); };
        words.clear();
        split_line(source.text.substr(begin, end - begin), code_place + 1, words);
        out.push_back(word(symbol_place));
        if (most < 2) return;
        const auto found = listed.find(index);
        if (frame.is_v3000) {
            out.push_back(named_charge(source, begin, line_end));
        } else if (listed.empty()) {
            out.push_back(charge_of_code(word(code_place)));
        } else {
            out.push_back(found == listed.end() ? "0" : found->second);
        }
    };
    return read_line_properties(source, frame.atoms, line_end, columns, options, fields);
}

}  // namespace

bool shows_sdf(std::string_view head) {
    for (int title = 0; title < 3; ++title) take_line(head);
    const std::string_view counts = trimmed(take_line(head));
    return counts.ends_with("V2000") || counts.ends_with("V3000");
}

SphereData read_sdf(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content), options.part.origin};
    const char line_end = line_end_of(source.text);
    MoleculeFinder finder(source, line_end);
    const auto next = [&](MolFrame& frame, std::int64_t number, bool wanted) { return finder.next(frame, number, wanted); };
    const FoundFrame<MolFrame> found = find_frame<MolFrame>(name, options, next);
    if (found.frames == 0) source.fail(source.text.size(), "the text is empty, expected three lines of title of frame 0");
    const AtomLines& lines = found.frame.atoms;
    require_memory(lines.count * sizeof(Sphere), name + ": " + in_groups(lines.count) + " spheres need");
    const auto reader = [&](std::size_t) { return MolAtomReader(source, found.frame, options); };
    Atoms atoms = read_atom_lines(source, lines, line_end, reader);
    atoms.properties = read_mol_properties(source, found.frame, line_end, options);
    SphereData data = data_of(std::move(atoms), name, options, name_of_species);
    note_frames(data, found);
    return data;
}

std::optional<std::size_t> step_over_sdf(std::string_view text, bool ended, const std::string& name, PartOfFile& part) {
    const TextSource source{name, whole_lines(text, ended), part.origin};
    MoleculeFinder finder(source, line_end_of(source.text));
    return step_over_frame<MolFrame>(finder, ended, part.frames);
}

}  // namespace sphereview
