#include "formats/foreign_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/gunzip.hpp"
#include "base/text.hpp"
#include "formats/foreign_lines.hpp"
#include "formats/lines.hpp"

namespace sphereview {

namespace {

using namespace std::string_view_literals;

struct Mark {
    std::string_view bytes;
    std::string_view kind;
    std::size_t offset = 0;
};

// Marks the beginning of a text behind blank lines or comments, in lower case.
constexpr std::size_t of_text = std::string_view::npos;

// Bytes that no text holds, or that begin files of one kind alone.
constexpr auto marks = std::to_array<Mark>({
    {"BZh"sv, "a file that is packed with bzip2, which is not unpacked here: gzip is"},
    {"\3757zXZ\0"sv, "a file that is packed with xz, which is not unpacked here: gzip is"},
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
    {"\177ELF"sv, "a program"},
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

// Lines that begin with '#' or, as in topologies, with ';'.
std::string_view behind_all_comments(std::string_view text) {
    text = behind_comments(text);
    while (text.starts_with(';')) {
        take_line(text);
        text = behind_comments(text);
    }
    return text;
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
    if (!is_binary) return kind_of_lines(raw, code);
    if (is_binary_stl(head)) return "an STL model";
    return is_utf16(raw) ? "" : binary_data;
}

std::string_view foreign_kind_of_name(std::string_view name) {
    const std::string lower = lower_case(without_gzip_ending(name));
    const auto found = std::ranges::find_if(foreign_endings, [&](const Ending& ending) { return lower.ends_with(ending.ending); });
    return found == foreign_endings.end() ? "" : found->kind;
}

}  // namespace sphereview
