// PQR: PDB's records of atoms with blanks between what they say, and at the end the atom's charge and radius.
#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_names.hpp"
#include "formats/lines.hpp"
#include "formats/macromolecule.hpp"
#include "formats/pdb_records.hpp"

namespace sphereview {

namespace {

constexpr auto last_fields = std::to_array<const char*>({"x", "y", "z", "charge", "radius"});

constexpr std::size_t behind_places = 54;  // in PDB's columns

bool holds_digit(std::string_view word) { return word.find_first_of("0123456789") != std::string_view::npos; }

// Whether all stands in the columns of PDB, as PDB2PQR writes it.
bool is_in_columns(std::string_view line) {
    if (line.size() <= behind_places || line[10] == ' ' || line[11] != ' ' || !in_columns(line, 27, 30).empty()) return false;
    if (in_columns(line, 12, 16).empty() || !holds_digit(in_columns(line, 22, 27))) return false;
    return line[34] == '.' && line[42] == '.' && line[50] == '.' && is_number(in_columns(line, 30, 38)) &&
           is_number(in_columns(line, 38, 46)) && is_number(in_columns(line, 46, behind_places));
}

// Whether a line of an atom is PQR's; nothing where it may be PDB's as well, whose occupancies are not below 0 and have two
// decimals.
std::optional<bool> is_pqr_atom(std::string_view line) {
    const bool fits_pdb = is_in_columns(line);
    const auto words = words_of(fits_pdb ? line.substr(behind_places) : line);
    const std::size_t numbers = fits_pdb ? 2 : last_fields.size();
    const std::size_t names = words.size() - std::min(words.size(), numbers);
    const bool has_names = fits_pdb ? names == 0 : (names == 5 || names == 6) && holds_digit(words[names - 1]);
    if (words.size() < numbers || !has_names ||
        !std::all_of(words.end() - static_cast<std::ptrdiff_t>(numbers), words.end(), is_number))
        return false;
    const std::string_view charge = words[words.size() - 2];
    const std::size_t decimals = charge.size() - std::min(charge.find('.'), charge.size() - 1) - 1;
    double value = 0.0;
    parse_double(charge, value);
    const bool is_sure = decimals > 2 || value < 0.0 || (!fits_pdb && (decimals != 2 || value == 0.0));
    return is_sure ? std::optional(true) : std::nullopt;
}

// Reads ATOM, a number, the atom, its residue, perhaps a chain, the residue's number, and last_fields.
class PqrAtoms {
public:
    explicit PqrAtoms(const TextSource& source) : source_(source) {}

    MoleculeAtom atom(std::string_view line) {
        split(line);
        Names names;
        const bool is_whole = find_in_words(names);
        if ((!is_whole || is_glued(line)) && is_in_columns(line)) {
            find_in_columns(line, names);
            read_values(line);
        } else if (!is_whole) {
            split_at_minus();
            if (!find_in_words(names)) {
                find_in_order(names);
                read_values(line);
            }
        }
        if (values_[4] < 0.0) source_.fail(fields_[4], "the atom's radius, 0 or above");
        MoleculeAtom atom;
        atom.position = {values_[0], values_[1], values_[2]};
        atom.radius = values_[4];
        atom.atom = names.atom;
        atom.residue = names.residue;
        atom.chain = names.chain;
        atom.residue_number = std::string(names.number);
        atom.alternative = names.alternative;
        atom.element = &element_of(names.atom, names.residue);
        atom.texts.charge = fields_[3];
        atom.texts.radius = fields_[4];
        return atom;
    }

private:
    struct Names {
        std::string_view atom{};
        std::string_view residue{};
        std::string_view chain{};
        std::string_view number{};  // of the residue
        std::string_view alternative{};
    };

    static constexpr std::size_t fewest_names = 5;  // without a chain
    static constexpr std::size_t most_words = 16;   // that are looked at

    // The words of the line; the atom's number may touch the record.
    void split(std::string_view line) {
        words_.clear();
        split_line(line, most_words, words_);
        const std::size_t record = line.starts_with("HETATM") ? 6 : 4;
        if (words_[0].size() == record) return;
        words_.insert(words_.begin() + 1, words_[0].substr(record));
        words_[0] = words_[0].substr(0, record);
    }

    // Numbers that fill their columns touch the one before by their minus.
    void split_at_minus() {
        for (std::size_t i = fewest_names; i < words_.size() && words_.size() < most_words; ++i) {
            const std::string_view word = words_[i];
            const std::size_t minus = word.find('-', 1);
            if (minus == std::string_view::npos || is_number(word) || !is_number(word.substr(0, minus))) continue;
            words_[i] = word.substr(0, minus);
            words_.insert(words_.begin() + static_cast<std::ptrdiff_t>(i) + 1, word.substr(minus));
        }
    }

    // Five numbers end the line, but for words behind them. Before them stands the residue's number. False where it is not so; else
    // the values are read.
    bool find_in_words(Names& names) {
        std::size_t end = words_.size();
        while (end > 0 && !is_number(words_[end - 1])) --end;
        const std::size_t places = end - std::min(end, last_fields.size());
        if (places != fewest_names && places != fewest_names + 1) return false;
        if (!holds_digit(words_[places - 1])) return false;
        for (std::size_t i = 0; i < last_fields.size(); ++i) {
            if (parse_double(words_[places + i], values_[i]) != NumberFault::none) return false;
        }
        take_words(names, places);
        return true;
    }

    // Where something is wrong: whatever stands there, for the message.
    void find_in_order(Names& names) {
        take_words(names, fewest_names + (words_.size() > fewest_names && !holds_digit(words_[fewest_names - 1]) ? 1 : 0));
    }

    void take_words(Names& names, std::size_t places) {
        const auto word = [&](std::size_t place) { return place < words_.size() ? words_[place] : std::string_view(); };
        names = {word(2), word(3), places > fewest_names ? word(4) : std::string_view(), word(places - 1), {}};
        // A number of four digits touches its chain.
        const bool is_touched = places == fewest_names && !names.number.empty() && is_letter(names.number[0]);
        if (is_touched) {
            names.chain = names.number.substr(0, 1);
            names.number.remove_prefix(1);
        }
        for (std::size_t i = 0; i < last_fields.size(); ++i) fields_[i] = word(places + i);
    }

    // Whether the atom's name seems to touch its residue, or the residue its chain.
    bool is_glued(std::string_view line) const {
        constexpr std::size_t longest_name = 4;
        constexpr std::size_t chain_column = 21;
        return words_[2].size() > longest_name || words_[3].size() > longest_name ||
               static_cast<std::size_t>(words_[3].data() - line.data()) >= chain_column;
    }

    void find_in_columns(std::string_view line, Names& names) {
        // A residue of four letters begins in column 17 or 18. But 17 may be an alternative's.
        names = {in_columns(line, 12, 16), in_columns(line, 16, 21), in_columns(line, 21, 22), in_columns(line, 22, 27), {}};
        const std::string_view three = in_columns(line, 17, 20);
        if (line[16] != ' ' && is_polymer(three) && !is_polymer(names.residue)) {
            names.alternative = in_columns(line, 16, 17);
            names.residue = three;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) fields_[axis] = in_columns(line, 30 + 8 * axis, 38 + 8 * axis);
        words_.clear();
        split_line(line.substr(behind_places), 2, words_);
        const bool touch = words_.size() < 2 || !is_number(words_[0]);
        fields_[3] = touch ? in_columns(line, 54, 62) : words_[0];
        fields_[4] = touch ? in_columns(line, 62, 70) : words_[1];
    }

    void read_values(std::string_view line) {
        for (std::size_t i = 0; i < last_fields.size(); ++i) {
            const std::string expected = std::string("the atom's ") + last_fields[i];
            if (fields_[i].empty()) source_.fail_behind(line, expected);
            const NumberFault fault = parse_double(fields_[i], values_[i]);
            if (fault != NumberFault::none) source_.fail(fields_[i], expected + ", " + expected_instead_of(fault));
        }
    }

    // Few names of many atoms are new.
    const Element& element_of(std::string_view atom, std::string_view residue) {
        constexpr std::size_t most_kept = 4096;
        if (elements_.size() > most_kept) elements_.clear();
        key_.assign(residue).append(1, ' ').append(atom);
        const auto [known, is_new] = elements_.try_emplace(key_, nullptr);
        if (is_new) known->second = &element_of_name(atom, residue, NameColumns::unknown);
        return *known->second;
    }

    const TextSource& source_;
    std::vector<std::string_view> words_{};  // of the line
    std::array<std::string_view, last_fields.size()> fields_{};
    std::array<double, last_fields.size()> values_{};  // of these
    std::string key_{};
    std::unordered_map<std::string, const Element*> elements_{};
};

// Whether the last line has no end, and fewer columns than the one above: half a number is a number, too.
bool ends_short(std::string_view text) {
    const std::string_view last = last_line(text);
    if (!is_pdb_atom(last) || !is_in_columns(last)) return false;
    const std::string_view above = last_line(trimmed(text.substr(0, text.size() - last.size()), white_space));
    return is_pdb_atom(above) && is_in_columns(above) && trimmed(last, white_space).size() < above.size();
}

}  // namespace

bool may_be_pqr_atom(std::string_view line) { return is_pqr_atom(line) != false; }

bool shows_pqr(std::string_view head) {
    while (!head.empty()) {
        const std::string_view line = take_line(head);
        const bool is_other_record = line.empty() || is_letter(line[0]) || line[0] == '#';
        const std::optional<bool> is_pqr = is_pdb_atom(line) ? is_pqr_atom(line)
                                           : is_other_record ? std::nullopt
                                                             : std::optional(false);
        if (is_pqr) return *is_pqr;
    }
    return false;
}

SphereData read_pqr(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, text_of_file(content)};
    PqrAtoms atoms(source);
    SphereData data = read_pdb_frame(source, options, true, [&](std::string_view line, bool) { return atoms.atom(line); });
    if (options.frame + 1 == data.frames && data.fault.empty() && ends_short(source.text)) {
        data.warnings.push_back(source.place(source.text.size()) +
                                "the line ends before that of the atom above it, expected the whole of the atom's radius");
    }
    return data;
}

}  // namespace sphereview
