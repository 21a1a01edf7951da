#include "formats/foreign_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/text.hpp"
#include "formats/lines.hpp"

namespace sphereview {

namespace {

using namespace std::string_view_literals;

struct Mark {
    std::string_view bytes;
    std::string_view kind;
    std::size_t offset = 0;
};

// Of what a text begins with, behind blank lines and in lower case.
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
    {"psf"sv, "a PSF file", of_text},
    {"%version "sv, "an AMBER topology", of_text},
    {"entering gaussian"sv, "a Gaussian log", of_text},
    {"%chk="sv, "a Gaussian input", of_text},
    {"%nproc"sv, "a Gaussian input", of_text},
    {"version https://git-lfs"sv, "a pointer of Git LFS, not the file itself: git lfs pull fetches that", of_text},
});

// The first lines of a text, as they are; missing ones are empty.
using FirstLines = std::array<std::string_view, 8>;

FirstLines first_lines(std::string_view text) {
    FirstLines lines{};
    for (std::string_view& line : lines) line = take_line(text);
    return lines;
}

bool is_stl(const FirstLines& lines) {
    return lower_case(lines[0].substr(0, 5)) == "solid" && lower_case(trimmed(lines[1])).starts_with("facet ");
}

// "2 atom types" within the first lines; an XYZ may begin with "100 atoms".
bool is_lammps_data(const FirstLines& lines) {
    return std::ranges::any_of(lines, [](std::string_view line) {
        const auto words = words_of(line);
        return words.size() == 3 && is_digits(words[0]) && words[1] == "atom" && words[2] == "types";
    });
}

// "v 1 2 3" behind other lines that begin with a word of the format's.
bool is_obj(std::string_view text) {
    constexpr auto others = std::to_array<std::string_view>({"mtllib", "o", "g", "s", "usemtl", "vn", "vt"});
    for (const std::string_view line : first_lines(behind_comments(text))) {
        const auto words = words_of(line);
        if (words.empty()) continue;
        if (words[0] == "mtllib") return true;
        if (words[0] == "v") return words.size() >= 4 && std::all_of(words.begin() + 1, words.end(), is_number);
        if (std::ranges::find(others, words[0]) == others.end()) return false;
    }
    return false;
}

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
        if (second != '[') return "";
        const char third = next();
        return (third >= '0' && third <= '9') || third == '-' || third == '[' ? "a JSON file" : "";
    }
    if (!text.starts_with('{')) return "";
    const char second = next();
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

}  // namespace

std::string_view foreign_kind(std::string_view head) {
    constexpr std::size_t enough = 4096;
    const std::string_view raw = head.substr(0, enough);
    const bool is_binary = raw.find('\0') != std::string_view::npos;
    if (const std::string_view kind = zip_kind(head); !kind.empty()) return kind;
    if (is_bmp(head)) return "a BMP picture";
    const std::string_view text = trimmed(raw, white_space);
    const std::string lower = lower_case(text);
    for (const Mark& mark : marks) {
        if (mark.offset == of_text) {
            if (!lower.starts_with(mark.bytes)) continue;
            return lower.find("<vtkfile") == std::string::npos ? mark.kind : "a VTK file";
        }
        // Behind its beginning a text may hold such letters, too.
        if ((mark.offset == 0 || is_binary) && head.size() > mark.offset && head.substr(mark.offset).starts_with(mark.bytes))
            return mark.kind;
    }
    if (const std::string_view kind = json_kind(text); !kind.empty()) return kind;
    const FirstLines lines = first_lines(raw);
    if (is_stl(lines)) return "an STL model";
    if (is_obj(text)) return "an OBJ model";
    if (is_lammps_data(lines)) return "a LAMMPS data file";
    if (is_binary && !is_utf16(raw)) return "binary data";
    return "";
}

}  // namespace sphereview
