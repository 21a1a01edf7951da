// Files that no format here reads say what they are.
#include "formats/foreign_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "formats/scene_format.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

using namespace std::string_literals;

// At `offset` of zeros.
std::string at(std::size_t offset, const std::string& text) { return std::string(offset, '\0') + text + std::string(40, '\0'); }

}  // namespace

TEST(ForeignFile, SaysWhatItIs) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"BZh91AY&SY\x93\xC0"s, "packed with bzip2"},
        {"\xFD\x37zXZ\0\0\4"s, "packed with xz"},
        {"\x28\xB5\x2F\xFD\x24"s, "packed with zstd"},
        {"7z\xBC\xAF\x27\x1C\0"s, "a 7z archive"},
        {"PK\3\4\x14\0 .. xl/worksheets/sheet1.xml"s, "an Excel workbook"},
        {"PK\3\4\x14\0 .. a.txt"s, "a zip archive"},
        {at(257, "ustar\0"s), "a tar archive"},
        {"\xFF\xD8\xFF\xE0\0\x10JFIF"s, "a JPEG picture"},
        {"\x89PNG\r\n\x1A\n"s, "a PNG picture"},
        {"GIF89a\1"s, "a GIF picture"},
        {"II*\0\10\0"s, "a TIFF picture"},
        {"RIFF\x10\0\0\0WEBPVP8 "s, "a WebP picture"},
        {"BM\x36\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\1"s, "a BMP picture"},
        {"%PDF-1.7\n", "a PDF document"},
        {"\x89HDF\r\n\x1A\n"s, "an HDF5 file"},
        {"CDF\1\0\0"s, "a NetCDF file"},
        {"T\0\0\0CORD\1\0\0\0"s, "a DCD trajectory"},
        {"\0\0\x07\xCB\0\0\0\3"s, "XTC"},
        {"\0\0\x07\xC9\0\0\0\r"s, "TRR"},
        {"# vtk DataFile Version 3.0\ncells\nASCII\n", "a VTK file"},
        {"<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">", "a VTK file"},
        {"<?xml version=\"1.0\"?>\n<TrackMate/>", "an XML file"},
        {"<!DOCTYPE html>\n<html>", "an HTML page"},
        {"\n <html><body>404", "an HTML page"},
        {"solid cube\n facet normal 0 0 1\n", "an STL model"},
        {"# Blender\nmtllib a.mtl\n", "an OBJ model"},
        {"# Blender\no Cube\nv 1 1 1\n", "an OBJ model"},
        {"v 1.0 2.0 3.0\nv 4 5 6\n", "an OBJ model"},
        {"glTF\2\0\0\0"s, "a glTF model"},
        {"{\n \"asset\": {\"version\": \"2.0\"}}", "a glTF model"},
        {"[[1, 2, 3]]", "a JSON file"},
        {"{\"a\": 1}", "a JSON file"},
        {"LAMMPS data file\n\n2 atoms\n", "a LAMMPS data file"},
        {"my system\n\n  2 atoms\n  1 atom types\n", "a LAMMPS data file"},
        {"@<TRIPOS>MOLECULE\n", "a MOL2 file"},
        {"\x93NUMPY\1\0"s, "a NumPy array"},
        {"MATLAB 5.0 MAT-file, Platform", "a MATLAB file"},
        {"1 2\0 3"s, "binary data"},
    };
    for (const auto& [bytes, kind] : cases) {
        EXPECT_NE(foreign_kind(bytes).find(kind), std::string::npos) << kind << ": " << foreign_kind(bytes);
        for (const std::string name : {"a.txt", "a.csv", "a.xyz", "a"}) {
            const std::string message = message_of<InputError>([&bytes = bytes, &name] { parse_scene(bytes, name); });
            EXPECT_EQ(message, name + ": found " + std::string(foreign_kind(bytes)) +
                                   ", expected text, TOML, XYZ, CSV, PDB, mmCIF, LAMMPS, GROMACS, POSCAR, SDF, PQR or PLY");
        }
    }
}

TEST(ForeignFile, IsNoneOfOurs) {
    for (const std::string text :
         {"", "1\n255 0 0\n1 2 3 4\n", "[[sphere]]\nname = \"a\"\n", "[camera]\n", "# vtk\nbackground = \"white\"\n",
          "BM,x,y,z\n1,2,3,4\n", "4\n1.0\nO 0 0 0\nH 1 0 0\nH 0 1 0\nH 0 0 1\n", "3\n1\n2 3 4\n5 6 7\n8 9 1\n2 3 4\n5\n6 7\n",
          "v,x,y,z\nv,1,2,3\n", "data_a\nloop_\n", "1 atoms\n\nH 0 0 0\n1 atoms\n\nH 0 0 0\n", "HEADER    PLANT PROTEIN\n",
          "xxxxCORD,x,y,z\n"}) {
        EXPECT_EQ(foreign_kind(text), "") << text;
    }
    EXPECT_EQ(foreign_kind("\xFF\xFEx\0,\0y\0"s), "");  // UTF-16
}

}  // namespace sphereview
