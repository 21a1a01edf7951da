// What the formats share in which each atom has a line: frames are found without a look at their atoms, and the lines of the wanted
// one are read on all cores.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "formats/elements.hpp"
#include "formats/lines.hpp"
#include "formats/property_columns.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

// Whether the line that `rest` begins with belongs to the atom of `line`, which stands before it.
using GoesOn = bool (*)(std::string_view line, std::string_view rest);

// Where the lines of one frame's atoms stand.
struct AtomLines {
    std::size_t count = 0;
    GoesOn goes_on = nullptr;           // null: each atom has one line
    std::vector<std::size_t> pieces{};  // where the first line of each atom_lines_a_piece begins; of the wanted frame alone
};

inline constexpr std::size_t atom_lines_a_piece = 1024;  // that one core reads at a time

// Steps over the lines of `count` atoms, or of `what` else has a line each. of_frame: " of frame 3". Throws InputError where the
// text ends before.
AtomLines step_over_atoms(const TextSource& source, LineWalker& walker, std::size_t count, bool wanted, const std::string& of_frame,
                          GoesOn goes_on = nullptr, const char* what = "atom");

// Steps over what goes on behind the line [begin, end).
inline void step_over_rest(const TextSource& source, LineWalker& walker, GoesOn goes_on, std::size_t begin, std::size_t end) {
    while (!walker.at_end() && goes_on(source.text.substr(begin, end - begin), source.text.substr(walker.offset()))) {
        begin = walker.offset();
        end = walker.step();
    }
}

// The wanted frame, and how many the file has.
template <typename Frame>
struct FoundFrame {
    Frame frame{};
    std::int64_t frames = 0;
    std::string fault{};  // behind the wanted frame, where the file is read no further; "" where nothing is wrong
};

// Calls next(frame, number, is_wanted) until it returns false, for there is no more frame; of the wanted one it notes where the
// atoms are. A fault behind the wanted frame is only kept. Throws what `next` throws, and InputError where there is no such frame.
template <typename Frame, typename Next>
FoundFrame<Frame> find_frame(const std::string& name, const DataOptions& options, const Next& next) {
    const std::int64_t wanted = options.frame;
    FoundFrame<Frame> found;
    found.frames = options.part.frames;
    while (true) {
        Frame frame;
        try {
            if (!next(frame, found.frames, found.frames == wanted)) break;
        } catch (const InputError& error) {
            if (found.frames <= wanted) throw;
            found.fault = error.what();
            break;
        }
        if (found.frames == wanted) found.frame = std::move(frame);
        ++found.frames;
    }
    if (found.frames > 0) require_frame(name, wanted, found.frames);
    return found;
}

// Notes the number of frames, and warns of the fault behind the wanted one.
template <typename Frame>
void note_frames(SphereData& data, const FoundFrame<Frame>& found) {
    data.frames = found.frames;
    if (found.fault.empty()) return;
    data.warnings.push_back(found.fault + "; what follows frame " + std::to_string(found.frames - 1) + " is passed over");
}

// What SceneFormat::step_over gives, by a finder of frames that stands at the first one of `text`.
template <typename Frame, typename Finder>
std::optional<std::size_t> step_over_frame(Finder& finder, bool ended, std::int64_t number) {
    try {
        Frame frame;
        const bool found = finder.next(frame, number, false);
        if (finder.at_end() && !ended) return std::nullopt;  // a line that belongs to the frame may follow
        return found ? finder.offset() : 0;
    } catch (const TextEnds&) {
        if (ended) throw;
        return std::nullopt;
    }
}

// Of a text that may be cut off anywhere unless it has `ended`: its lines that are whole.
inline std::string_view whole_lines(std::string_view text, bool ended) {
    return ended ? text : text.substr(0, text.rfind(line_end_of(text)) + 1);
}

// " of atom 3 of 5", of that index from 0.
std::string of_atom(std::size_t index, std::size_t count, const char* what = "atom");

// Throws InputError where a computed place, of the line that begins at `begin`, is beyond a double.
void require_finite(const TextSource& source, std::size_t begin, const glm::dvec3& center, std::size_t index, std::size_t count);

// What a line says.
struct LineAtom {
    Sphere sphere{};
    std::string_view label{};  // what the atom's name is made of
    bool is_virtual = false;   // no atom (elements.hpp)
};

// Gives the atom its element's size and colour.
void show_as(LineAtom& atom, const Element& element, const DataOptions& options);

// The atoms of a frame.
struct Atoms {
    std::vector<Sphere> spheres{};
    std::vector<std::string_view> labels{};    // none of more than most_named_atoms
    std::vector<std::size_t> virtual_sites{};  // their numbers, ascending
    FileProperties properties{};
};

// Reads a frame's lines. make_reader(piece) makes what reads the lines of one piece: read(begin, end, index) gives the LineAtom of
// atom `index`, whose line stands at [begin, end) of the text.
template <typename MakeReader>
Atoms read_atom_lines(const TextSource& source, const AtomLines& lines, char line_end, const MakeReader& make_reader) {
    Atoms atoms;
    atoms.spheres.resize(lines.count);
    atoms.labels.resize(lines.count <= most_named_atoms ? lines.count : 0);
    std::vector<std::vector<std::size_t>> virtual_sites(lines.pieces.size());
    parallel_in_order(lines.pieces.size(), [&](std::size_t piece) {
        auto reader = make_reader(piece);
        LineWalker walker(source.text, line_end, lines.pieces[piece]);
        const std::size_t first = piece * atom_lines_a_piece;
        const std::size_t last = std::min(lines.count, first + atom_lines_a_piece);
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t begin = walker.offset();
            const std::size_t end = walker.step();
            const LineAtom atom = reader.read(begin, end, i);
            if (lines.goes_on != nullptr) step_over_rest(source, walker, lines.goes_on, begin, end);
            atoms.spheres[i] = atom.sphere;
            if (!atoms.labels.empty()) atoms.labels[i] = atom.label;
            if (atom.is_virtual) virtual_sites[piece].push_back(i);
        }
    });
    for (const auto& of_piece : virtual_sites) {
        atoms.virtual_sites.insert(atoms.virtual_sites.end(), of_piece.begin(), of_piece.end());
    }
    return atoms;
}

// Reads the columns of a frame's lines that are asked for. words_of_row(begin, end, index, most, words) appends the first `most`
// fields of the row of atom `index`, whose line stands at [begin, end) of the text, to `words`.
template <typename WordsOfRow>
FileProperties read_line_properties(const TextSource& source, const AtomLines& lines, char line_end,
                                    const std::vector<PropertyColumn>& columns, const DataOptions& options,
                                    const WordsOfRow& words_of_row) {
    return read_properties(columns, options, lines.count, source.name, [&](PropertyTable& table) {
        std::vector<std::string_view> words;
        LineWalker walker(source.text, line_end, lines.count > 0 ? lines.pieces[0] : 0);
        for (std::size_t i = 0; i < lines.count; ++i) {
            const std::size_t begin = walker.offset();
            const std::size_t end = walker.step();
            words.clear();
            words_of_row(begin, end, i, table.places(), words);
            if (lines.goes_on != nullptr) step_over_rest(source, walker, lines.goes_on, begin, end);
            table.add([&](std::size_t place) { return place < words.size() ? words[place] : std::string_view(); });
        }
    });
}

// Appends at most `most` words of the line to `words`.
inline void split_line(std::string_view line, std::size_t most, std::vector<std::string_view>& words) {
    const char* const end = line.data() + line.size();
    for (const char* at = line.data(); words.size() < most;) {
        at = std::find_if_not(at, end, is_space);
        if (at == end) return;
        const char* const word = at;
        at = std::find_if(at, end, is_space);
        words.emplace_back(word, static_cast<std::size_t>(at - word));
    }
}

// The same where the columns are the words of each line.
inline FileProperties read_word_properties(const TextSource& source, const AtomLines& lines, char line_end,
                                           const std::vector<PropertyColumn>& columns, const DataOptions& options) {
    const auto split = [&](std::size_t begin, std::size_t end, std::size_t, std::size_t most,
                           std::vector<std::string_view>& words) {
        split_line(source.text.substr(begin, end - begin), most, words);
    };
    return read_line_properties(source, lines, line_end, columns, options, split);
}

// Makes data of atoms: name_of(label) calls each that has a label.
SphereData data_of(Atoms atoms, const std::string& name, const DataOptions& options, std::string (*name_of)(std::string_view));

// What an atom of an element is called: as the file calls it, or by the symbol of an atomic number.
std::string name_of_species(std::string_view species);

}  // namespace sphereview
