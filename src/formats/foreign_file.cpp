#include "formats/foreign_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/gunzip.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/csv_records.hpp"
#include "formats/elements.hpp"
#include "formats/lines.hpp"

namespace sphereview {

namespace {

using namespace std::string_view_literals;

struct Mark {
    std::string_view bytes;
    std::string_view kind;
    std::size_t offset = 0;
};

// Of what a text begins with, behind blank lines or comments and in lower case.
constexpr std::size_t of_text = std::string_view::npos;

// Bytes that no text holds, or that begin files of one kind alone.
constexpr auto marks = std::to_array<Mark>({
    {"BZh"sv, "a file that is packed with bzip2, which is not unpacked here: gzip is"},
    {"\xFD"
     "7zXZ\0"sv,
     "a file that is packed with xz, which is not unpacked here: gzip is"},
    {"\x28\xB5\x2F\xFD"sv, "a file that is packed with zstd, which is not unpacked here: gzip is"},
    {"\x04\x22\x4D\x18"sv, "a file that is packed with lz4, which is not unpacked here: gzip is"},
    {"\x1F\x9D"sv, "a file that is packed with compress, which is not unpacked here: gzip is"},
    {"\x1F\x8B"sv, "a file that is packed with gzip twice"},
    {"7z\xBC\xAF\x27\x1C"sv, "a 7z archive"},
    {"Rar!\x1A\x07"sv, "a RAR archive"},
    {"PK\x05\x06"sv, "a zip archive"},
    {"ustar"sv, "a tar archive", 257},
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv, "an old Office file, such as Excel's .xls; save the table as CSV"},
    {"\xFF\xD8\xFF"sv, "a JPEG picture"},
    {"\x89PNG\r\n"sv, "a PNG picture"},
    {"GIF87a"sv, "a GIF picture"},
    {"GIF89a"sv, "a GIF picture"},
    {"II*\0"sv, "a TIFF picture"},
    {"MM\0*"sv, "a TIFF picture"},
    {"II+\0"sv, "a TIFF picture"},
    {"MM\0+"sv, "a TIFF picture"},
    {"8BPS\0"sv, "a Photoshop picture"},
    {"\x76\x2F\x31\x01"sv, "an OpenEXR picture"},
    {"WEBP"sv, "a WebP picture", 8},
    {"AVI "sv, "an AVI film", 8},
    {"ftypavif"sv, "an AVIF picture", 4},
    {"ftyphei"sv, "a HEIC picture", 4},
    {"ftyp"sv, "an MP4 film", 4},
    {"\x1A\x45\xDF\xA3"sv, "a Matroska or WebM film"},
    {"%PDF-"sv, "a PDF document"},
    {"%!PS"sv, "a PostScript document"},
    {"{\\rtf"sv, "an RTF document"},
    {"\x89HDF\r\n"sv, "an HDF5 file"},
    {"\x0E\x03\x13\x01"sv, "an HDF4 file"},
    {"CDF\x01"sv, "a NetCDF file"},
    {"CDF\x02"sv, "a NetCDF file"},
    {"CDF\x05"sv, "a NetCDF file"},
    {"CORD"sv, "a DCD trajectory", 4},
    {"VELD"sv, "a DCD file of velocities", 4},
    {"CORD"sv, "a DCD trajectory", 8},
    {"\0\0\x07\xCB"sv, "a GROMACS trajectory (XTC)"},
    {"\0\0\x07\xE7"sv, "a GROMACS trajectory (XTC)"},
    {"\0\0\x07\xC9"sv, "a GROMACS trajectory (TRR)"},
    {"\xDF\x65\xDF\x65\xDF\x65\xDF\x65"sv, "a GSD file"},
    {"MMTF"sv, "an MMTF file"},
    {"\x93NUMPY"sv, "a NumPy array; numpy.savetxt writes it as CSV"},
    {"\x80\x03"sv, "a Python pickle"},
    {"\x80\x04"sv, "a Python pickle"},
    {"\x80\x05"sv, "a Python pickle"},
    {"MATLAB 5.0 MAT-file"sv, "a MATLAB file; writematrix writes a table as CSV"},
    {"RDX2\n"sv, "an R data file; write.csv writes a table as CSV"},
    {"RDX3\n"sv, "an R data file; write.csv writes a table as CSV"},
    {"PAR1"sv, "a Parquet table"},
    {"FEA1"sv, "a Feather table"},
    {"NRRD00"sv, "an NRRD picture"},
    {"ASTM-E57"sv, "an E57 point cloud"},
    {"PXR-USDC"sv, "a USD scene"},
    {"\xFF\xFF\x26\xFD"sv, "a GROMACS file of energies (EDR)"},
    {"\0\x02\x9F\x29"sv, "a GROMACS checkpoint (CPT)"},
    {"VERSION "sv, "a GROMACS run input (TPR)", 4},
    {"VERSION "sv, "a GROMACS run input (TPR)", 8},
    {"ARROW1"sv, "an Arrow table"},
    {"SQLite format 3\0"sv, "an SQLite database"},
    {"LASF"sv, "a LAS point cloud"},
    {"SIMPLE  ="sv, "a FITS file"},
    {"DICM"sv, "a DICOM file", 128},
    {"MAP "sv, "an MRC or CCP4 map", 208},
    {"glTF"sv, "a glTF model"},
    {"Kaydara FBX"sv, "an FBX model"},
    {"BLENDER"sv, "a Blender file"},
    {"\x7F"
     "ELF"sv,
     "a program"},
    {"MZ\x90\0"sv, "a program"},
    {"<!doctype html"sv, "an HTML page", of_text},
    {"<html"sv, "an HTML page", of_text},
    {"<!--"sv, "an HTML page or XML file", of_text},
    {"<svg"sv, "an SVG picture", of_text},
    {"<vtkfile"sv, "a VTK file", of_text},
    {"<?xml"sv, "an XML file", of_text},
    {"# vtk datafile"sv, "a VTK file", of_text},
    {"# .pcd"sv, "a PCD point cloud", of_text},
    {"#vrml"sv, "a VRML model", of_text},
    {"#inventor"sv, "an Inventor model", of_text},
    {"#!/"sv, "a script", of_text},
    {"off\n"sv, "an OFF model", of_text},
    {"off\r"sv, "an OFF model", of_text},
    {"coff\n"sv, "an OFF model", of_text},
    {"lammps "sv, "a LAMMPS data file", of_text},
    {"@<tripos>"sv, "a MOL2 file", of_text},
    {"psf\n"sv, "a PSF file", of_text},
    {"psf\r"sv, "a PSF file", of_text},
    {"psf ext"sv, "a PSF file", of_text},
    {"psf cmap"sv, "a PSF file", of_text},
    {"%version "sv, "an AMBER topology", of_text},
    {"entering gaussian"sv, "a Gaussian log", of_text},
    {"%chk="sv, "a Gaussian input", of_text},
    {"%oldchk="sv, "a Gaussian input", of_text},
    {"%rwf="sv, "a Gaussian input", of_text},
    {"%mem="sv, "a Gaussian input", of_text},
    {"%nproc"sv, "a Gaussian input", of_text},
    {"program pwscf"sv, "a Quantum ESPRESSO log", of_text},
    {"&control"sv, "a Quantum ESPRESSO input", of_text},
    {"&system"sv, "a Quantum ESPRESSO input", of_text},
    {"&global"sv, "a CP2K input", of_text},
    {"&force_eval"sv, "a CP2K input", of_text},
    {"%block lattice_"sv, "a CASTEP cell", of_text},
    {"%block positions_"sv, "a CASTEP cell", of_text},
    {"systemname "sv, "a SIESTA input", of_text},
    {"systemlabel "sv, "a SIESTA input", of_text},
    {"$coord"sv, "a Turbomole file", of_text},
    {"[molden format]"sv, "a Molden file", of_text},
    {"!biosym archive"sv, "a BIOSYM archive", of_text},
    {"<molecule"sv, "a CML file", of_text},
    {"<cml"sv, "a CML file", of_text},
    {"<x3d"sv, "an X3D model", of_text},
    {"<collada"sv, "a Collada model", of_text},
    {"$meshformat"sv, "a Gmsh mesh", of_text},
    {"#!tdv"sv, "a Tecplot file", of_text},
    {"#usda"sv, "a USD scene", of_text},
    {"#binvox"sv, "a binvox file", of_text},
    {"*heading"sv, "an Abaqus input", of_text},
    {"version https://git-lfs"sv, "a pointer of Git LFS, not the file itself: git lfs pull fetches that", of_text},
});

// What files are by the endings of their names, where they begin with nothing that tells.
struct Ending {
    std::string_view ending;
    std::string_view kind;
};
constexpr auto foreign_endings = std::to_array<Ending>({
    {".bcif", "a BinaryCIF file"},
    {".car", "a BIOSYM archive"},
    {".cell", "a CASTEP cell"},
    {".cml", "a CML file"},
    {".cpt", "a GROMACS checkpoint (CPT)"},
    {".crd", "coordinates of CHARMM or AMBER"},
    {".cube", "a Gaussian cube"},
    {".edr", "a GROMACS file of energies (EDR)"},
    {".fasta", "a FASTA file"},
    {".fchk", "a Gaussian checkpoint"},
    {".fdf", "a SIESTA input"},
    {".gjf", "a Gaussian input"},
    {".inpcrd", "AMBER coordinates"},
    {".itp", "a GROMACS topology"},
    {".mdcrd", "an AMBER trajectory"},
    {".mmtf", "an MMTF file"},
    {".molden", "a Molden file"},
    {".mol2", "a MOL2 file"},
    {".msh", "a Gmsh mesh"},
    {".nii", "a NIfTI picture"},
    {".nrrd", "an NRRD picture"},
    {".parm7", "an AMBER topology"},
    {".prmtop", "an AMBER topology"},
    {".pts", "a Leica point cloud (PTS)"},
    {".ptx", "a Leica point cloud (PTX)"},
    {".res", "a SHELX file"},
    {".rst7", "AMBER coordinates"},
    {".stl", "an STL model"},
    {".tpr", "a GROMACS run input (TPR)"},
    {".x3d", "an X3D model"},
    {".xsf", "an XSF file"},
});

// The first lines of a text, as they are; missing ones are empty.
using FirstLines = std::array<std::string_view, 12>;

// What a text begins with.
struct Opening {
    std::string_view text{};  // without white space around it
    FirstLines lines{};       // from its first one on, blank or not
    FirstLines code{};        // behind comments
};

FirstLines first_lines(std::string_view text) {
    FirstLines lines{};
    for (std::string_view& line : lines) line = take_line(text);
    return lines;
}

// Lines that begin with '#' or, as in topologies, with ';'.
std::string_view behind_all_comments(std::string_view text) {
    text = behind_comments(text);
    while (text.starts_with(';')) {
        take_line(text);
        text = behind_comments(text);
    }
    return text;
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
    return opening.text.starts_with(';') && any_begins(opening.lines, "#include \"");
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

// Objects, and lists of objects or lists: TOML's tables have names in their brackets.
std::string_view json_kind(std::string_view text) {
    const auto next = [&text] {
        text.remove_prefix(1);
        text = trimmed(text, white_space);
        return text.empty() ? '\0' : text[0];
    };
    const std::string_view whole = text;
    if (text.starts_with('[')) {
        const char second = next();
        if (second == '{') return "a JSON file";
        const bool is_list = (second >= '0' && second <= '9') || second == '-';
        if (is_list) return text.find(',') < text.find(']') ? "a JSON file" : "";
        if (second != '[') return "";
        const char third = next();
        return (third >= '0' && third <= '9') || third == '-' || third == '[' ? "a JSON file" : "";
    }
    if (!text.starts_with('{')) return "";
    const char second = next();
    if (text.starts_with("s_m_m2io_version")) return "a Maestro file";
    if (second != '"' && second != '}') return "";
    return whole.find("\"asset\"") != std::string_view::npos && whole.find("\"version\"") != std::string_view::npos ? "a glTF model"
                                                                                                                    : "a JSON file";
}

std::string_view zip_kind(std::string_view head) {
    if (!head.starts_with("PK\x03\x04")) return "";
    if (head.find("xl/") != std::string_view::npos) return "an Excel workbook; save the table as CSV";
    if (head.find("opendocument.spreadsheet") != std::string_view::npos) return "a spreadsheet; save the table as CSV";
    if (head.find(".npy") != std::string_view::npos) return "NumPy arrays; numpy.savetxt writes one as CSV";
    return "a zip archive";
}

// Two letters that a text may begin with, too: the sizes behind them tell.
bool is_bmp(std::string_view head) {
    return head.size() > 18 && head.starts_with("BM") && head.substr(6, 4) == "\0\0\0\0"sv && head.substr(15, 3) == "\0\0\0"sv;
}

// A header of 80 bytes, the number of triangles, and 50 bytes for each.
bool is_binary_stl(std::string_view head) {
    constexpr std::size_t header = 84;
    constexpr std::size_t triangle = 50;
    if (head.size() < header + triangle) return false;
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) count |= std::uint64_t{static_cast<unsigned char>(head[80 + i])} << (8 * i);
    if (count == 0) return false;
    const bool is_whole = head.size() == header + triangle * count;
    // Of a longer file only the beginning is known: what stands behind each triangle is nearly always 0.
    bool ends_in_zeros = header + triangle * count > head.size();
    for (std::size_t end = header + triangle; end <= head.size(); end += triangle) {
        ends_in_zeros = ends_in_zeros && head.substr(end - 2, 2) == "\0\0"sv;
    }
    return is_whole || (ends_in_zeros && head.size() > header + 10 * triangle);
}

// By what a text begins with, in lower case.
std::string_view kind_of_mark(std::string_view lower) {
    for (const Mark& mark : marks) {
        if (mark.offset != of_text || !lower.starts_with(mark.bytes)) continue;
        return lower.find("<vtkfile") == std::string_view::npos ? mark.kind : "a VTK file";
    }
    return "";
}

}  // namespace

std::string_view foreign_kind(std::string_view head) {
    constexpr std::size_t enough = 4096;
    const std::string_view raw = head.substr(0, enough);
    const bool is_binary = raw.find('\0') != std::string_view::npos;
    if (const std::string_view kind = zip_kind(head); !kind.empty()) return kind;
    if (is_bmp(head)) return "a BMP picture";
    const std::string_view text = trimmed(raw, white_space);
    const std::string_view code = behind_all_comments(text);
    for (const std::string_view beginning : {text, code}) {
        if (const std::string_view kind = kind_of_mark(lower_case(beginning)); !kind.empty()) return kind;
    }
    for (const Mark& mark : marks) {
        // Behind its beginning a text may hold such letters, too.
        if (mark.offset != of_text && (mark.offset == 0 || is_binary) && head.size() > mark.offset &&
            head.substr(mark.offset).starts_with(mark.bytes)) {
            return mark.kind;
        }
    }
    if (const std::string_view kind = json_kind(text); !kind.empty()) return kind;
    const Opening opening{text, first_lines(raw), first_lines(code)};
    for (const Shape& shape : shapes) {
        if (!is_binary && shape.shows(opening)) return shape.kind;
    }
    if (is_binary && is_binary_stl(head)) return "an STL model";
    if (is_binary && !is_utf16(raw)) return binary_data;
    return "";
}

std::string_view foreign_kind_of_name(std::string_view name) {
    const std::string lower = lower_case(without_gzip_ending(name));
    const auto found = std::ranges::find_if(foreign_endings, [&](const Ending& ending) { return lower.ends_with(ending.ending); });
    return found == foreign_endings.end() ? "" : found->kind;
}

}  // namespace sphereview
