#include "formats/foreign_lines.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/csv_records.hpp"
#include "formats/elements.hpp"
#include "formats/lines.hpp"

namespace sphereview {

namespace {

// The first lines of a text, as they are; missing ones are empty.
using FirstLines = std::array<std::string_view, 12>;

// What a text begins with.
struct Opening {
    std::string_view text{};
    FirstLines lines{};  // from its first one on, blank or not
    FirstLines code{};   // behind comments
};

FirstLines first_lines(std::string_view text) {
    FirstLines lines{};
    for (std::string_view& line : lines) line = take_line(text);
    return lines;
}

bool is_blank(std::string_view line) { return trimmed(line, white_space).empty(); }

// A line of `count` numbers and nothing else, of which the first is a whole one where `whole_first`.
bool is_numbers(std::string_view line, std::size_t count, bool whole_first = false) {
    const auto words = words_of(line);
    std::int64_t ignored = 0;
    return words.size() == count && std::ranges::all_of(words, is_number) && (!whole_first || parse_whole(words[0], ignored));
}

bool is_any_number(std::string_view line) { return !is_blank(line) && is_numbers(line, words_of(line).size()); }

bool any_begins(const FirstLines& lines, std::string_view beginning) {
    return std::ranges::any_of(lines, [&](std::string_view line) { return line.starts_with(beginning); });
}

// Whether each number of a line has so many digits behind its point.
bool has_decimals(std::string_view line, std::size_t decimals) {
    const auto words = words_of(line);
    const auto has = [&](std::string_view word) {
        const std::size_t point = word.find('.');
        return point != std::string_view::npos && word.size() - point - 1 == decimals && is_number(word);
    };
    return !words.empty() && std::ranges::all_of(words, has);
}

bool is_ascii_stl(const Opening& opening) {
    const FirstLines& lines = opening.lines;
    return lower_case(lines[0].substr(0, 5)) == "solid" && lower_case(trimmed(lines[1])).starts_with("facet ");
}

// The kind, and below it, or below a comment, the size. P6 is a space group, too, and so the title of crystals.
bool is_ppm(const Opening& opening) {
    const std::string_view kind = trimmed(opening.lines[0]);
    const std::string_view size = trimmed(opening.lines[opening.lines[1].starts_with('#') ? 2 : 1]);
    return (kind == "P3" || kind == "P6") && is_numbers(size, 2, true);
}

// "2 atom types" within the first lines; an XYZ may begin with "100 atoms".
bool is_lammps_data(const Opening& opening) {
    return std::ranges::any_of(opening.lines, [](std::string_view line) {
        const auto words = words_of(line);
        return words.size() == 3 && is_digits(words[0]) && words[1] == "atom" && words[2] == "types";
    });
}

// "v 1 2 3" behind other lines that begin with a word of the format's.
bool is_obj(const Opening& opening) {
    constexpr auto others = std::to_array<std::string_view>({"mtllib", "o", "g", "s", "usemtl", "vn", "vt"});
    for (const std::string_view line : opening.code) {
        const auto words = words_of(line);
        if (words.empty()) continue;
        if (words[0] == "mtllib") return true;
        if (words[0] == "v") return words.size() >= 4 && std::all_of(words.begin() + 1, words.end(), is_number);
        if (std::ranges::find(others, words[0]) == others.end()) return false;
    }
    return false;
}

// Two titles, the number of atoms with an origin, three axes, and an atom of five numbers.
bool is_cube(const Opening& opening) {
    const FirstLines& lines = opening.lines;
    const bool has_origin = is_numbers(lines[2], 4, true) || is_numbers(lines[2], 5, true);
    return !is_any_number(lines[0]) && has_origin && is_numbers(lines[3], 4, true) && is_numbers(lines[4], 4, true) &&
           is_numbers(lines[5], 4, true) && is_numbers(lines[6], 5, true);
}

// A route that begins with '#', a title and the charge with the spin, with blank lines between.
bool is_gaussian_input(const Opening& opening) {
    const FirstLines& lines = opening.lines;
    std::size_t i = 0;
    while (i < lines.size() && lines[i].starts_with('%')) ++i;
    if (i == lines.size() || !lines[i].starts_with('#')) return false;
    while (i < lines.size() && !is_blank(lines[i])) ++i;
    if (i + 3 >= lines.size() || is_any_number(lines[i + 1])) return false;
    return !is_blank(lines[i + 1]) && is_blank(lines[i + 2]) && is_numbers(lines[i + 3], 2, true);
}

bool is_gaussian_checkpoint(const Opening& opening) {
    const std::string_view line = opening.lines[2];
    return line.starts_with("Number of atoms ") && line.find(" I ") != std::string_view::npos;
}

bool is_orca_input(const Opening& opening) {
    return opening.code[0].starts_with('!') && std::ranges::any_of(opening.code, [](std::string_view line) {
               const std::string lower = lower_case(line);
               return lower.starts_with("* xyz") || lower.starts_with("*xyz") || lower.starts_with("* int");
           });
}

bool is_orca_log(const Opening& opening) { return opening.text.find("* O   R   C   A *") != std::string_view::npos; }

// A title, the number of atoms, perhaps a time, and places with seven digits behind the point.
bool is_amber_coordinates(const Opening& opening) {
    const FirstLines& lines = opening.lines;
    const bool has_count = is_numbers(lines[1], 1, true) || is_numbers(lines[1], 2, true);
    const std::size_t numbers = words_of(lines[2]).size();
    // Points may have a header in a comment, and their number below it.
    const bool has_title = !is_any_number(lines[0]) && comment_mark(lines[0]).empty();
    return has_title && has_count && (numbers == 3 || numbers == 6) && has_decimals(lines[2], 7);
}

// A title, and places with three digits behind the point, ten in a line of ten columns of eight characters.
bool is_amber_trajectory(const Opening& opening) {
    const FirstLines& lines = opening.lines;
    return !is_any_number(lines[0]) && lines[1].size() == 80 && words_of(lines[1]).size() == 10 && has_decimals(lines[1], 3) &&
           std::ranges::any_of(lines,
                               [](std::string_view line) { return words_of(line).size() % 10 != 0 && has_decimals(line, 3); });
}

// Lines of title that begin with '*', the last of them without a word, and the number of atoms.
bool is_charmm_coordinates(const Opening& opening) {
    if (!opening.lines[0].starts_with('*')) return false;
    const auto count = std::ranges::find_if_not(opening.lines, [](std::string_view line) { return line.starts_with('*'); });
    if (count == opening.lines.end() || trimmed(count[-1]) != "*") return false;
    const auto words = words_of(*count);
    return !words.empty() && is_digits(words[0]) && (words.size() == 1 || (words.size() == 2 && words[1] == "EXT"));
}

// "[ moleculetype ]" and other sections, perhaps behind an #include.
bool is_gromacs_topology(const Opening& opening) {
    constexpr auto sections = std::to_array<std::string_view>({"defaults", "atomtypes", "bondtypes", "moleculetype", "atoms",
                                                               "bonds", "system", "molecules", "settles", "position_restraints"});
    const auto words = words_of(opening.code[0]);
    const bool begins = words.size() == 3 && words[0] == "[" && words[2] == "]";
    if (begins && std::ranges::find(sections, words[1]) != sections.end()) return true;
    return trimmed(opening.text, white_space).starts_with(';') && any_begins(opening.lines, "#include \"");
}

bool is_xsf(const Opening& opening) {
    constexpr auto beginnings = std::to_array<std::string_view>({"CRYSTAL", "SLAB", "POLYMER", "MOLECULE", "DIM-GROUP", "PRIMVEC"});
    const std::string_view first = trimmed(opening.code[0]);
    const bool begins = first.starts_with("ANIMSTEPS ") || std::ranges::find(beginnings, first) != beginnings.end();
    return begins &&
           (any_begins(opening.code, "PRIMVEC") || any_begins(opening.code, "CONVVEC") || any_begins(opening.code, "ATOMS"));
}

bool is_shelx(const Opening& opening) {
    return opening.lines[0].starts_with("TITL") && std::ranges::any_of(opening.lines, [](std::string_view line) {
               return line.starts_with("CELL ") && is_numbers(line.substr(5), 7);
           });
}

// A title, two or more whole numbers, perhaps a box, and a name with its atom's place below.
bool is_dl_poly(const Opening& opening) {
    const FirstLines& lines = opening.lines;
    const auto keys = words_of(lines[1]);
    if (is_any_number(lines[0]) || keys.size() < 2 || keys.size() > 5 || !is_digits(keys[0]) || !is_digits(keys[1])) return false;
    const bool has_box = keys[1] != "0";
    for (std::size_t i = 2; i < 5 && has_box; ++i) {
        if (!is_numbers(lines[i], 3)) return false;
    }
    const auto atom = words_of(lines[has_box ? 5 : 2]);
    const bool is_atom = !atom.empty() && atom.size() <= 2 && is_letter(atom[0][0]) && (atom.size() == 1 || is_digits(atom[1]));
    return is_atom && is_numbers(lines[has_box ? 6 : 3], 3);
}

bool is_fasta(const Opening& opening) {
    const std::string_view sequence = trimmed(opening.lines[1]);
    return opening.lines[0].starts_with('>') && opening.lines[0].size() > 1 && !sequence.empty() &&
           std::ranges::all_of(sequence, [](char c) { return is_letter(c) || c == '*' || c == '-'; });
}

bool is_tecplot(const Opening& opening) {
    const auto begins = [](std::string_view line, std::string_view word) { return lower_case(trimmed(line)).starts_with(word); };
    const auto begins_zone = [&](std::string_view line) { return begins(line, "zone"); };
    return (begins(opening.code[0], "title") || begins(opening.code[0], "variables")) &&
           opening.code[0].find('=') != std::string_view::npos && std::ranges::any_of(opening.code, begins_zone);
}

// The number of points, and for each its place, its intensity and its colour. A scene's text has its colour first.
bool is_leica_pts(const Opening& opening) {
    const auto is_point = [](std::string_view line) {
        const auto words = words_of(line);
        std::uint8_t byte = 0;
        const auto is_byte = [&byte](std::string_view word) { return parse_whole(word, byte); };
        std::int64_t intensity = 0;
        if (!is_numbers(line, 7) || !parse_whole(words[3], intensity) || !std::all_of(words.end() - 3, words.end(), is_byte))
            return false;
        if (intensity >= 0 && words[0].find('.') == std::string_view::npos) return false;  // an atom by its number, perhaps
        double radius = 0.0;
        return !std::all_of(words.begin(), words.begin() + 3, is_byte) || parse_double(words[6], radius) != NumberFault::none ||
               radius <= 0.0;
    };
    return is_numbers(opening.lines[0], 1, true) && is_point(opening.lines[1]) &&
           (is_blank(opening.lines[2]) || is_point(opening.lines[2]));
}

// Columns and rows, the scanner's place and axes, and a matrix.
bool is_leica_ptx(const Opening& opening) {
    const FirstLines& lines = opening.lines;
    const auto all = [&](std::size_t first, std::size_t last, std::size_t count) {
        return std::all_of(lines.begin() + static_cast<std::ptrdiff_t>(first), lines.begin() + static_cast<std::ptrdiff_t>(last),
                           [&](std::string_view line) { return is_numbers(line, count); });
    };
    return is_numbers(lines[0], 1, true) && is_numbers(lines[1], 1, true) && all(2, 6, 3) && all(6, 10, 4);
}

// Files that only several lines show.
struct Shape {
    bool (*shows)(const Opening& opening);
    std::string_view kind;
};
constexpr auto shapes = std::to_array<Shape>({
    {is_ppm, "a PPM picture"},
    {is_ascii_stl, "an STL model"},
    {is_obj, "an OBJ model"},
    {is_lammps_data, "a LAMMPS data file"},
    {is_cube, "a Gaussian cube"},
    {is_gaussian_input, "a Gaussian input"},
    {is_gaussian_checkpoint, "a Gaussian checkpoint"},
    {is_orca_input, "an ORCA input"},
    {is_orca_log, "an ORCA log"},
    {is_amber_coordinates, "AMBER coordinates"},
    {is_amber_trajectory, "an AMBER trajectory"},
    {is_charmm_coordinates, "CHARMM coordinates"},
    {is_gromacs_topology, "a GROMACS topology"},
    {is_xsf, "an XSF file"},
    {is_shelx, "a SHELX file"},
    {is_dl_poly, "a DL_POLY configuration"},
    {is_fasta, "a FASTA file"},
    {is_tecplot, "a Tecplot file"},
    {is_leica_pts, "a Leica point cloud (PTS)"},
    {is_leica_ptx, "a Leica point cloud (PTX)"},
});
}  // namespace

std::string_view kind_of_lines(std::string_view text, std::string_view code) {
    const Opening opening{text, first_lines(text), first_lines(code)};
    const auto found = std::ranges::find_if(shapes, [&](const Shape& shape) { return shape.shows(opening); });
    return found == shapes.end() ? "" : found->kind;
}

}  // namespace sphereview
