// What the readers allocate.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "formats/scene_format.hpp"
#include "unit/largest_allocation.hpp"

namespace sphereview {

TEST(Memory, DoesNotFollowTheClaimedCount) {
    for (const std::string text :
         {"2000000000\n1 2 3 4 5 6 7\n", "spheres = \"\"\"\n2000000000\n1 2 3 4 5 6 7\n\"\"\"\n",
          "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2000000000\nITEM: ATOMS x y z\n1 2 3\n",
          "t\n1\n1 0 0\n0 1 0\n0 0 1\nH\n2000000000\nDirect\n0 0 0\n",
          "ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty int x\nproperty int y\nproperty int z\n"
          "end_header\n1 2 3\n",
          "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty int x\nproperty int y\n"
          "property int z\nend_header\n0123456789ab"}) {
        take_largest_allocation();
        EXPECT_THROW(parse_scene(text, "s"), InputError);
        EXPECT_LT(take_largest_allocation(), 16U * 1024);
    }
}

TEST(Memory, OfManySpheresIsOneTightAllocation) {
    constexpr std::size_t count = 10'000;
    std::string text = std::to_string(count) + "\n";
    for (std::size_t i = 0; i < count; ++i) text += "255 128 64\n-12.345678901 23.456789012 150.25\n1.2345678901\n";
    take_largest_allocation();
    const Scene scene = parse_scene(text, "s");
    EXPECT_EQ(scene.spheres.size(), count);
    EXPECT_EQ(take_largest_allocation(), count * sizeof(Sphere));
}

#ifdef __linux__

// What a reader takes beside a text that it is hard to read in little memory: bytes for each byte of the text. A sphere has 40, a
// name some 110. What a foreign parser makes is more; it is asked for before (require_memory), as tests of the program show.
TEST(Memory, ForEachByteOfATextIsBounded) {
    struct Case {
        std::string name;
        std::string head;  // # is how many rows follow
        std::string row;
        double most;
        std::string tail = "";
    };
    const std::string atom = "ATOM      1  N   ALA A   1       0.000   0.000   0.000";
    const std::string other = "ATOM      1  N   ALA B   2       0.000   0.000   0.000";
    std::vector<Case> cases = {
        {"short_rows.csv", "x,y,z\n", "0,0,0\n", 9.0},
        {"names.csv", "name,x,y,z\n", "a,0,0,0\n", 16.0},
        {"quotes.csv", "x,y,z,radius\n", "0,0,0,\"1\"\n", 4.5},
        {"no_rows.csv", "x,y,z\n", "\n", 0.5},
        {"columns.csv", "x,y,z", ",", 3.0},
        {"fields.csv", "x,y,z\n", ",", 0.5},
        {"short_rows.xyz", "#\nProperties=pos:R:3\n", "0 0 0\n", 7.0},
        {"frames.xyz", "", "0\n\n", 0.5},
        {"spheres.txt", "#\n", "0 0 0 0 0 0 1\n", 3.0},
        {"spheres.toml", "spheres = \"\"\"#\n", "0 0 0 0 0 0 1\n", 3.5, "\"\"\"\n"},
        {"tables.toml", "background = 'white'\n", "[[sphere]]\ncolor = [1, 2, 3]\ncenter = [4, 5, 6]\nradius = 7\n", 6.0},
        {"dotted.toml", "", ".a.a.a.a.a.a.a.a.a.a.a=0\n", 107.0},
        {"array.toml", "a = [", "{},", 53.0, "]\n"},
        {"rows.lammpstrj", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n#\nITEM: ATOMS id x y z\n", "123 0 0 0\n", 6.0},
        {"frames.lammpstrj", "", "ITEM: NUMBER OF ATOMS\n0\nITEM: ATOMS x y z\n", 0.5},
        {"columns.lammpstrj", "ITEM: NUMBER OF ATOMS\n0\nITEM: ATOMS x y z", " a", 1.0, "\n"},
        {"rows.gro", "t\n#\n", "    1SOL     OW    1 1.0 1.0 1.0\n", 5.0},
        {"rows.vasp", "t\n1\n1 0 0\n0 1 0\n0 0 1\nH\n#\nDirect\n", "0 0 0\n", 7.0},
        {"groups.vasp", "t\n1\n1 0 0\n0 1 0\n0 0 1\n", "1 ", 2.0, "\nDirect\n"},
        {"symbols.vasp", "t\n1\n1 0 0\n0 1 0\n0 0 1\n", "H ", 2.0, "\n1\nDirect\n0 0 0\n"},
        {"molecules.sdf", "", "\n\n\n  1  0\n0 0 0 H\n$$$$\n", 0.5},
        {"rows.pqr", "", "ATOM 1 N A 1 0 0 0 0 1\n", 4.0},
        {"words.pqr", "ATOM", " a", 0.5, "\n"},
        {"rows.ply", "ply\nformat ascii 1.0\nelement vertex #\nproperty int x\nproperty int y\nproperty int z\nend_header\n",
         "0 0 0\n", 7.0},
        {"header.ply", "ply\nformat ascii 1.0\nelement a 1\n", "property int a\n", 1.0},
    };
    cases.push_back({"one_residue.pdb", "", atom + "\n", 4.0});
    cases.push_back({"residues.pdb", "", atom + "\n" + other + "\n", 4.0});
#ifndef WITHOUT_GEMMI
    cases.push_back(
        {"short_rows.cif", "data_\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n", "0 0 0\n", 34.0});
#endif
    for (const Case& input : cases) {
        const std::size_t rows = 3'000'000 / input.row.size();
        std::string text = input.head;
        if (const auto count = text.find('#'); count != std::string::npos) text.replace(count, 1, std::to_string(rows));
        for (std::size_t i = 0; i < rows; ++i) text += (input.row[0] == '.' ? std::to_string(i) : "") + input.row;
        text += input.tail;
        begin_most_bytes();
        try {
            parse_scene(text, input.name);
        } catch (const InputError&) {
            // Some of them are no scenes.
        }
        const double factor = static_cast<double>(most_bytes()) / static_cast<double>(text.size());
        EXPECT_LE(factor, input.most) << input.name;
    }
}

#endif

}  // namespace sphereview
