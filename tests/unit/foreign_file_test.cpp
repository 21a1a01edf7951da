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
        {"Water density\nTotal SCF\n 2 0.0 0.0 0.0\n 2 1.0 0 0\n 2 0 1.0 0\n 2 0 0 1.0\n 1 1.0 0 0 0\n", "a Gaussian cube"},
        {"t\nt\n-2 0.0 0.0 0.0 1\n 2 1.0 0 0\n 2 0 1.0 0\n 2 0 0 1.0\n 1 1.0 0 0 0\n", "a Gaussian cube"},
        {"P6\n# by a program\n2 2\n255\n", "a PPM picture"},
        {"P3\r\n2 2\r\n255\r\n1 2 3", "a PPM picture"},
        {"%mem=2GB\n%nprocshared=4\n# b3lyp/6-31g\n\nt\n\n0 1\n", "a Gaussian input"},
        {"#p b3lyp/6-31g opt\n\ntitle\n\n0 1\nH 0 0 0\n", "a Gaussian input"},
        {"%lindaworkers=a\n# hf\n# opt\n\ntitle\n\n-1 2\nH 0 0 0\n", "a Gaussian input"},
        {"water\nSP        RB3LYP      6-31G\nNumber of atoms                            I                3\n",
         "a Gaussian checkpoint"},
        {"! B3LYP def2-SVP\n* xyz 0 1\nH 0 0 0\n*\n", "an ORCA input"},
        {"# a run\n!PBE0\n%pal nprocs 8 end\n*xyzfile 0 1 a.xyz\n", "an ORCA input"},
        {"\n          *****************\n          * O   R   C   A *\n", "an ORCA log"},
        {"&control\n calculation=\"scf\"\n/\n", "a Quantum ESPRESSO input"},
        {"\n     Program PWSCF v.6.4 starts\n", "a Quantum ESPRESSO log"},
        {"# a run\n&GLOBAL\n  PROJECT x\n&END\n", "a CP2K input"},
        {"# c\n%BLOCK LATTICE_CART\n", "a CASTEP cell"},
        {"default_name\n     2\n  1.0000000  2.0000000  3.0000000  4.0000000  5.0000000  6.0000000\n", "AMBER coordinates"},
        {"default_name\n     1  0.1000000E+01\n  1.0000000  2.0000000  3.0000000\n", "AMBER coordinates"},
        {"ACE\n   2.000   1.000   0.000   2.000   1.000   0.000   2.000   1.000   0.000   2.000\n   1.000   0.000\n",
         "an AMBER trajectory"},
        {"* TITLE\n*\n    2  EXT\n         1         1  ALA       N               1.0\n", "CHARMM coordinates"},
        {"; topology\n#include \"amber.ff\"\n", "a GROMACS topology"},
        {"; one\n\n; two\n[ moleculetype ]\nSOL 2\n", "a GROMACS topology"},
        {"!BIOSYM archive 3\nPBC=OFF\n", "a BIOSYM archive"},
        {"# c\nCRYSTAL\nPRIMVEC\n1 0 0\n", "an XSF file"},
        {"ANIMSTEPS 4\nCRYSTAL\nPRIMVEC 1\n1 0 0\n", "an XSF file"},
        {"TITL x\nCELL 0.71073 4 4 4 90 90 90\n", "a SHELX file"},
        {"DL_POLY\n  0  0\nNa+ 1\n 1.0 2.0 3.0\n", "a DL_POLY configuration"},
        {"DL_POLY\n  2  3  8\n 9 0 0\n 0 9 0\n 0 0 9\nO_w 1\n 1.0 2.0 3.0\n", "a DL_POLY configuration"},
        {"<molecule id=\"m1\" xmlns=\"http://www.xml-cml.org/schema\">", "a CML file"},
        {"<X3D>", "an X3D model"},
        {"FEA1\1"s, "a Feather table"},
        {"NRRD0004\n", "an NRRD picture"},
        {">sp|P1\nMKV\n", "a FASTA file"},
        {"$MeshFormat\n2.2 0 8\n", "a Gmsh mesh"},
        {"[Molden Format]\n[Atoms] AU\n", "a Molden file"},
        {"TITLE = \"x\"\nVARIABLES = \"X\" \"Y\" \"Z\"\nZONE I=2\n1 2 3\n", "a Tecplot file"},
        {"[1, 2, 3]\n", "a JSON file"},
        {"2\n1 2 3 -100 255 0 0\n4 5 6 -100 0 255 0\n", "a Leica point cloud (PTS)"},
        {"2\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n1 2 3 0.5\n", "a Leica point cloud (PTX)"},
        {"# comment\n\n@<TRIPOS>MOLECULE\nx\n", "a MOL2 file"},
        {"\0\0\0\x0DVERSION 2019\0"s, "a GROMACS run input (TPR)"},
        {"\xFF\xFF\x26\xFD\0"s, "a GROMACS file of energies (EDR)"},
        {"\0\x02\x9F\x29\0"s, "a GROMACS checkpoint (CPT)"},
        {std::string(80, 'A') + "\1\0\0\0"s + std::string(48, '\x3F') + "\0\0"s, "an STL model"},
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

TEST(ForeignFile, MayBeKnownByItsEnding) {
    for (const std::string& text : {"\1\0\2"s, "Some words\n"s}) {
        const std::string message = message_of<InputError>([&] { parse_scene(text, "a.tpr"); });
        EXPECT_TRUE(message.starts_with("a.tpr: found a GROMACS run input (TPR), expected text")) << message;
    }
    EXPECT_TRUE(message_of<InputError>([] {
                    parse_scene("ACE\n 1.000 2.000\n", "b.MDCRD.gz");
                }).starts_with("b.MDCRD.gz: found an AMBER trajectory"));
    // What is read has any name.
    EXPECT_EQ(parse_scene("1\n255 0 0 1 2 3 4\n", "a.pts").spheres.size(), 1U);
    EXPECT_EQ(parse_scene("x,y,z\n1,2,3\n", "a.cube").spheres.size(), 1U);
}

TEST(ForeignFile, IsNoneOfOurs) {
    for (const std::string text : {"",
                                   "1\n255 0 0\n1 2 3 4\n",
                                   "[[sphere]]\nname = \"a\"\n",
                                   "[camera]\n",
                                   "# vtk\nbackground = \"white\"\n",
                                   "BM,x,y,z\n1,2,3,4\n",
                                   "4\n1.0\nO 0 0 0\nH 1 0 0\nH 0 1 0\nH 0 0 1\n",
                                   "3\n1\n2 3 4\n5 6 7\n8 9 1\n2 3 4\n5\n6 7\n",
                                   "v,x,y,z\nv,1,2,3\n",
                                   "data_a\nloop_\n",
                                   "1 atoms\n\nH 0 0 0\n1 atoms\n\nH 0 0 0\n",
                                   "HEADER    PLANT PROTEIN\n",
                                   "xxxxCORD,x,y,z\n",
                                   "psf,x,y,z\n1,2,3,4\n",
                                   "//X Y Z\n2\n1.0000000 2.0000000 3.0000000\n",
                                   "2\n1 2 3 4 255 0 9\n1 2 3 4 255 0 9\n",
                                   "title\n1.0\n4 0 0\n0 4 0\n0 0 4\nNa\n1\nDirect\n0 0 0\n",
                                   "t\n2\n    1SOL     OW    1   0.000   0.000   0.000\n",
                                   "# x y\n\n1 2\n\n4 5\n",
                                   "2\n-1.5 2 3 4 5 6 7\n8 1 0 0 0 0 0\n1 0 0 1 0 0 0\n",
                                   "* a\nx,y,z\n1,2,3\n",
                                   "TITLE x\nATOM\n",
                                   "P6\n1.0\n4 0 0\n0 4 0\n0 0 4\nNa\n1\nDirect\n0 0 0\n",
                                   "vasp.6 crystal\n1.0\n4 0 0\n0 4 0\n0 0 4\nNa\n1\nDirect\n0 0 0\n",
                                   "psf made\n1\n    1SOL     OW    1   0.000   0.000   0.000\n",
                                   ">\n1\n\nH 0 0 0\n",
                                   ";x;y;z\n0;1;2;3\n",
                                   "!x\nx,y,z\n1,2,3\n",
                                   "title = \"a\"\n",
                                   "a b\n1 2 3 4 5 6 7 8 9 10\n"}) {
        EXPECT_EQ(foreign_kind(text), "") << text;
    }
    EXPECT_EQ(foreign_kind("\xFF\xFEx\0,\0y\0"s), "");  // UTF-16
    EXPECT_EQ(foreign_kind("x\0,\0y\0"s), "");
}

}  // namespace sphereview
