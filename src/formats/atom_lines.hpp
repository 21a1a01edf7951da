// Shared by formats with a line for each atom: finds frames without reading their atoms, and reads the lines of the wanted frame on
// all cores.
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
#include "formats/atoms.hpp"
#include "formats/elements.hpp"
#include "formats/lines.hpp"
#include "formats/property_columns.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

// Whether the line that `rest` begins with belongs to the atom of the preceding `line`.
using GoesOn = bool (*)(std::string_view line, std::string_view rest);

// The places of the lines of a frame's atoms.
struct AtomLines {
    std::size_t count = 0;
    GoesOn goes_on = nullptr;  // null: each atom has one line
    char line_end = '\n';
    std::size_t last = 0;               // where the first line of the last atom begins
    std::vector<std::size_t> pieces{};  // where the first line of each atom_lines_a_piece begins; of the wanted frame,
                                        // and of one that the text ends with

    // A walker at a piece's first line.
    LineWalker walker(const TextSource& source, std::size_t piece) const { return {source.text, line_end, pieces[piece]}; }
    // The first atom's line; "" without atoms.
    std::string_view first_line(const TextSource& source) const { return count > 0 ? walker(source, 0).step() : ""; }

    // Steps over an atom's lines and returns the first.
    std::string_view step(const TextSource& source, LineWalker& walker) const {
        const std::string_view first = walker.step();
        if (goes_on == nullptr) return first;
        for (std::string_view line = first; !walker.at_end() && goes_on(line, source.text.substr(walker.offset()));) {
            line = walker.step();
        }
        return first;
    }
};

inline constexpr std::size_t atom_lines_a_piece = 1024;  // that one core reads at a time

// Steps over the lines of `count` atoms (or `what`). of_frame: " of frame 3". Throws TextEnds if the text ends before.
AtomLines step_over_atoms(const TextSource& source, LineWalker& walker, std::size_t count, bool wanted, const std::string& of_frame,
                          GoesOn goes_on = nullptr, const char* what = "atom");

// " of atom 3 of 5"; `index` counts from 0.
std::string of_atom(std::size_t index, std::size_t count, const char* what = "atom");

// What TokenReader expects in an atom's line: the("x")() is "the x of atom 3 of 5".
struct OfAtom {
    std::size_t index = 0;
    std::size_t count = 0;

    auto operator()(const char* what) const {
        return [atom = *this, what] { return std::string("the ") + what + of_atom(atom.index, atom.count); };
    }
};

inline glm::dvec3 read_place(TokenReader& reader, const OfAtom& the) {
    const double x = reader.number(the("x"));
    const double y = reader.number(the("y"));
    const double z = reader.number(the("z"));
    return {x, y, z};
}

// The same; false if a number is missing, such as nan.
inline bool read_place_if_any(TokenReader& reader, const OfAtom& the, glm::dvec3& place) {
    const bool x = reader.number_if_any(the("x"), place.x);
    const bool y = reader.number_if_any(the("y"), place.y);
    const bool z = reader.number_if_any(the("z"), place.z);
    return x && y && z;
}

// The base of finders of frames, which step from frame to frame without reading atoms. Each has a type Frame and next(frame,
// number, wanted), which steps over frame `number`, from 0, or returns false at the end; it notes the places of the wanted frame's
// atoms.
class FrameFinder {
public:
    FrameFinder(const TextSource& source, const PartOfFile& part)
        : source_(source), walker_(source.text, line_end_of(source.text)), of_first_(part.of_first) {}

    // PartOfFile::of_first for the next frame.
    std::size_t of_first() const { return of_first_; }
    bool at_end() const { return walker_.at_end(); }
    // Where the next line begins.
    std::size_t offset() const { return walker_.offset(); }

    // Whether the text's last line is a whole line of an atom of the frame. Finders that can tell override this.
    template <typename Frame>
    bool holds_atom(const Frame&, std::string_view) const {
        return true;
    }

protected:
    bool nothing_follows() const { return source_.text.find_first_not_of(white_space, offset()) == std::string_view::npos; }

    // Call at the beginning of each frame, for messages.
    void begin_frame(std::int64_t number) { of_frame_ = " of frame " + std::to_string(number); }
    const std::string& of_frame() const { return of_frame_; }

    // The next line, which should hold `expected`. Throws TextEnds.
    std::string_view step(std::string_view expected) {
        if (walker_.at_end()) source_.fail_at_end(std::string(expected) + of_frame_);
        return walker_.step();
    }

    // The number of atoms in the next line, which may go on behind it.
    std::size_t step_over_count() {
        const std::string_view line = step("the number of atoms");
        const auto expected = [&] { return "the number of atoms" + of_frame_; };
        return static_cast<std::size_t>(TokenReader(source_, line).integer(0, most_spheres, expected));
    }

    AtomLines step_over(std::size_t atoms, bool wanted, GoesOn goes_on = nullptr) {
        return step_over_atoms(source_, walker_, atoms, wanted, of_frame_, goes_on);
    }

    const TextSource& source_;
    LineWalker walker_;
    std::size_t of_first_;

private:
    std::string of_frame_{};
};

// The fault of the text's last frame if its last line, without a line end, is not whole; else "". A program that was ended while it
// wrote leaves half a line, which reading the frame, by read_frame(frame), shows.
template <typename Finder, typename ReadFrame>
std::string fault_of_last_line(const TextSource& source, const Finder& finder, const typename Finder::Frame& frame,
                               std::int64_t number, const ReadFrame& read_frame) {
    if (!finder.at_end()) return "";  // first: looking for the last line behind each frame would take long
    const bool ends_in_cr = source.text.ends_with('\r') && line_end_of(source.text) == '\n';
    const std::string_view line = last_line(source.text.substr(0, source.text.size() - (ends_in_cr ? 1 : 0)));
    if (line.empty()) return "";
    bool is_whole = finder.holds_atom(frame, line);
    try {
        // The atoms of a frame that goes on behind them are whole, and their lines are not noted.
        if (is_whole && !frame.atoms.pieces.empty()) read_frame(frame);
    } catch (const TextFault& fault) {
        is_whole = fault.offset < source.offset_of(line);
    }
    if (is_whole) return "";
    return source.place(source.text.size()) + "the text ends, expected the whole line of the last atom of frame " +
           std::to_string(number);
}

// Reads the wanted frame by read_frame(frame), which gives SphereData. beginning: what an empty text lacks. A fault behind the
// wanted frame becomes a warning. Throws what `finder` throws, and InputError if there is no such frame.
template <typename Finder, typename ReadFrame>
SphereData read_wanted_frame(const TextSource& source, const DataOptions& options, Finder& finder, const char* beginning,
                             const ReadFrame& read_frame) {
    using Frame = typename Finder::Frame;
    Frame wanted;
    std::int64_t frames = options.part.frames;
    std::string fault;
    while (true) {
        Frame frame;
        try {
            if (!finder.next(frame, frames, frames == options.frame)) break;
        } catch (const InputError& error) {
            if (frames <= options.frame) throw;
            fault = early_end(error.what(), frames);
            break;
        }
        // The wanted frame is read in any case.
        const auto read = [&](const Frame& last) {
            if (frames > options.frame) read_frame(last);
        };
        const std::string cut = fault_of_last_line(source, finder, frame, frames, read);
        if (frames > options.frame && !cut.empty()) {
            fault = early_end(cut, frames);
            break;
        }
        if (frames == options.frame) {
            wanted = std::move(frame);
            fault = cut;
        }
        ++frames;
    }
    if (frames == 0) source.fail(source.text.size(), std::string("the text is empty, expected ") + beginning + " of frame 0");
    require_frame(source.name, options.frame, frames);
    SphereData data = read_frame(wanted);
    data.frames = frames;
    if (!fault.empty()) data.warnings.push_back(fault);
    return data;
}

// SceneFormat::read for a format with a finder and read_frame(source, frame, options).
template <typename Finder, typename ReadFrame>
SphereData read_frame_of(std::string_view content, const std::string& name, const DataOptions& options, const char* beginning,
                         const ReadFrame& read_frame) {
    const TextSource source{name, text_of_file(content), options.part.origin};
    Finder finder(source, options.part);
    return read_wanted_frame(source, options, finder, beginning,
                             [&](const auto& frame) { return read_frame(source, frame, options); });
}

// SceneFormat::step_over for such a format.
template <typename Finder, typename ReadFrame>
std::optional<std::size_t> step_over_frame(std::string_view text, bool ended, const std::string& name, PartOfFile& part,
                                           const ReadFrame& read_frame) {
    // A text that is cut off anywhere has whole lines up to its last line end.
    const std::string_view lines = ended ? text : text.substr(0, text.rfind(line_end_of(text)) + 1);
    const TextSource source{name, lines, part.origin};
    Finder finder(source, part);
    try {
        typename Finder::Frame frame;
        const bool found = finder.next(frame, part.frames, false);
        const auto read = [&](const auto& last) { read_frame(source, last, DataOptions{}); };
        const bool may_be_cut = ended && found && part.frames > 0;
        const std::string fault = may_be_cut ? fault_of_last_line(source, finder, frame, part.frames, read) : "";
        if (!fault.empty()) throw TextEnds(fault, lines.size());
        if (finder.at_end() && !ended) return std::nullopt;  // a line that belongs to the frame may follow
        part.of_first = finder.of_first();
        return found ? finder.offset() : 0;
    } catch (const TextEnds&) {
        if (ended) throw;
        return std::nullopt;
    }
}

// Throws InputError if the computed place of the atom with that line is beyond a double.
void require_finite(const TextSource& source, std::string_view line, const glm::dvec3& center, std::size_t index,
                    std::size_t count);

// The atom of a line.
struct LineAtom {
    Sphere sphere{};
    std::string_view label{};  // the atom's name is made of this
    bool is_virtual = false;   // no atom (elements.hpp)
    bool is_nowhere = false;   // without a place: left out
};

void show_as(LineAtom& atom, const Element& element, const DataOptions& options);

// The atoms of a frame.
struct Atoms {
    std::vector<Sphere> spheres{};
    std::vector<std::string_view> labels{};    // empty for more than most_named_atoms
    std::vector<std::size_t> virtual_sites{};  // their numbers, ascending
    std::vector<std::size_t> nowhere{};        // likewise
    FileProperties properties{};
};

// Reads a frame's lines. make_reader(piece) makes the reader of a piece's lines, whose read(line, index) gives the LineAtom of atom
// `index`. Throws MemoryError if the atoms do not fit.
template <typename MakeReader>
Atoms read_atom_lines(const TextSource& source, const AtomLines& lines, const MakeReader& make_reader) {
    require_memory_for_spheres(source.name, lines.count);
    Atoms atoms;
    atoms.spheres.resize(lines.count);
    atoms.labels.resize(lines.count <= most_named_atoms ? lines.count : 0);
    struct Numbers {
        std::vector<std::size_t> virtual_sites{};
        std::vector<std::size_t> nowhere{};
    };
    std::vector<Numbers> numbers(lines.pieces.size());
    parallel_in_order(lines.pieces.size(), [&](std::size_t piece) {
        auto reader = make_reader(piece);
        LineWalker walker = lines.walker(source, piece);
        const std::size_t first = piece * atom_lines_a_piece;
        const std::size_t last = std::min(lines.count, first + atom_lines_a_piece);
        for (std::size_t i = first; i < last; ++i) {
            const LineAtom atom = reader.read(lines.step(source, walker), i);
            atoms.spheres[i] = atom.sphere;
            if (!atoms.labels.empty()) atoms.labels[i] = atom.label;
            if (atom.is_virtual) numbers[piece].virtual_sites.push_back(i);
            if (atom.is_nowhere) numbers[piece].nowhere.push_back(i);
        }
    });
    for (const Numbers& of_piece : numbers) {
        atoms.virtual_sites.insert(atoms.virtual_sites.end(), of_piece.virtual_sites.begin(), of_piece.virtual_sites.end());
        atoms.nowhere.insert(atoms.nowhere.end(), of_piece.nowhere.begin(), of_piece.nowhere.end());
    }
    return atoms;
}

// Reads the wanted columns of a frame's lines. fields_of(line, index, most, fields) appends the first `most` fields of atom `index`
// to `fields`.
template <typename FieldsOf>
FileProperties read_line_properties(const TextSource& source, const AtomLines& lines, const std::vector<PropertyColumn>& columns,
                                    const DataOptions& options, const FieldsOf& fields_of) {
    return read_properties(columns, options, lines.count, source.name, [&](PropertyTable& table) {
        if (lines.count == 0) return;
        std::vector<std::string_view> fields;
        LineWalker walker = lines.walker(source, 0);
        for (std::size_t i = 0; i < lines.count; ++i) {
            fields.clear();
            fields_of(lines.step(source, walker), i, table.places(), fields);
            table.add([&](std::size_t place) { return place < fields.size() ? fields[place] : std::string_view(); });
        }
    });
}

// The same for columns that are the words of each line.
inline FileProperties read_word_properties(const TextSource& source, const AtomLines& lines,
                                           const std::vector<PropertyColumn>& columns, const DataOptions& options) {
    const auto split = [](std::string_view line, std::size_t, std::size_t most, std::vector<std::string_view>& words) {
        split_line(line, most, words);
    };
    return read_line_properties(source, lines, columns, options, split);
}

// Makes SphereData of atoms. name_of(label): the name of an atom with a label.
SphereData data_of(Atoms atoms, const std::string& name, const DataOptions& options, std::string (*name_of)(std::string_view));

// The name of an atom by its element: as in the file, or the symbol of an atomic number.
std::string name_of_species(std::string_view species);

}  // namespace sphereview
