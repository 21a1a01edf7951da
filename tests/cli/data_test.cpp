// Files of atoms and particles, and packed ones.
#include <gtest/gtest.h>

#include "cli/fails.hpp"
#include "cli/in_folder.hpp"
#include "support/gzip.hpp"
#include "support/json.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

constexpr const char* two_frames = "1\nfirst\nO 0 0 100\n2\nsecond\nN 0 0 100\nH 1 0 100\n";

class Data : public InFolder {
protected:
    std::string as_text(const std::vector<std::string>& arguments, const std::string& input = "") const {
        return sphereview(all_words(all_words({"convert"}, arguments), {"-", "--to", "text"}), input).output;
    }
};

TEST_F(Data, IsConvertedToTextAndToml) {
    folder_.write("a.xyz", two_frames);
    EXPECT_EQ(as_text({"a.xyz"}), "1\n255 13 13\n0 0 100\n0.66\n");
    EXPECT_EQ(as_text({"a.xyz", "--frame", "1"}), "2\n48 80 248\n0 0 100\n0.71\n255 255 255\n1 0 100\n0.31\n");
    EXPECT_EQ(as_text({"a.xyz", "--frame", "1", "--radius", "2.5"}), "2\n48 80 248\n0 0 100\n2.5\n255 255 255\n1 0 100\n2.5\n");
    EXPECT_EQ(as_text({"-"}, two_frames), as_text({"a.xyz"}));

    folder_.write("A.CSV", "Name,X,Y,Z,R,G,B\nsun,1,2,3,255,220,0\n\"the moon\",4,5,6,,,\n");
    const Outcome outcome = sphereview({"convert", "A.CSV", "a.toml", "--radius", "3", "--no-fit"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.output + outcome.errors, "");
    EXPECT_EQ(folder_.read("a.toml"),
              "[[sphere]]\nname = \"sun\"\ncolor = [255, 220, 0]\ncenter = [1.0, 2.0, 3.0]\nradius = 3.0\n\n"
              "[[sphere]]\nname = \"the moon\"\ncolor = [255, 255, 255]\ncenter = [4.0, 5.0, 6.0]\nradius = 3.0\n");
    const Outcome poorer = sphereview({"convert", "A.CSV", "a.txt", "--radius", "3"});
    EXPECT_EQ(poorer.status, 0);
    EXPECT_EQ(poorer.errors, "A.CSV: the text format cannot hold the names (2); left out\n");
    EXPECT_EQ(as_text({"a.toml"}), as_text({"A.CSV", "--radius", "3"}));
}

TEST_F(Data, IsOnlyRead) {
    folder_.write("a.xyz", two_frames);
    for (const auto& [name, format] : std::vector<std::pair<std::string, std::string>>{{"b.csv", "CSV"},
                                                                                       {"b.XYZ", "XYZ"},
                                                                                       {"b.pdb", "PDB"},
                                                                                       {"b.cif", "mmCIF"},
                                                                                       {"b.csv.gz", "CSV"},
                                                                                       {"b.toml.gz", "gzip"},
                                                                                       {"b.txt.GZ", "gzip"}}) {
        const std::string fault =
            name + ": found a name for " + format + ", which is only read; expected one that ends with .txt or .toml";
        expect_fault({"convert", "a.xyz", name}, fault);
        if (format != "gzip") expect_fault({"convert", "a.xyz", name, "--to", "toml"}, fault);  // no command could open it
        EXPECT_FALSE(folder_.has(name));
    }
    folder_.write("picture.PNG", "mine");
    expect_fault({"convert", "a.xyz", "picture.PNG"},
                 "picture.PNG: found a picture's name, expected one that ends with .txt or .toml");
    EXPECT_EQ(folder_.read("picture.PNG"), "mine");
}

TEST_F(Data, IsRenderedAndExplainedByFrame) {
    folder_.write("a.xyz", two_frames);
    folder_.write("0.txt", "1\n255 13 13\n0 0 100\n0.66\n");
    folder_.write("1.txt", "2\n48 80 248\n0 0 100\n20\n255 255 255\n1 0 100\n20\n");
    const std::vector<std::string> small = {"--size", "64x48", "--backend", "cpu", "--no-fit"};
    const auto render = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(), small.begin(), small.end());
        return sphereview(arguments);
    };
    EXPECT_EQ(render({"0.txt", "1.txt"}).status, 0);
    EXPECT_EQ(render({"a.xyz"}).status, 0);
    EXPECT_TRUE(folder_.has("a.png"));
    EXPECT_EQ(render({"a.xyz", "--expect", "0.png"}).status, 0);
    EXPECT_EQ(render({"a.xyz", "--frame", "1", "--radius", "20", "--expect", "1.png"}).status, 0);
    EXPECT_EQ(render({"a.xyz", "--frame", "0", "--radius", "20", "--expect", "1.png"}).status, 1);

    const Outcome outcome =
        sphereview({"explain", "a.xyz", "--pixel", "500,500", "--frame", "1", "--radius", "20", "--no-fit", "--json"});
    const auto report = Json::parse(outcome.output);
    EXPECT_EQ(report["visible"], 0);
    EXPECT_EQ(report["color"], (Json{48, 80, 248}));
}

// Their coordinates are right-handed, ours are left-handed: seen as it should be, data looks like a scene with z turned round.
TEST_F(Data, IsNotMirrored) {
    folder_.write("hand.xyz", "4\n\nC 0 0 0\nO 2 0 0\nN 0 3 0\nS 0 0 4\n");
    folder_.write("hand.txt",
                  "4\n144 144 144\n0 0 0\n0.76\n255 13 13\n2 0 0\n0.66\n48 80 248\n0 3 0\n0.71\n255 255 48\n0 0 -4\n1.05\n");
    const auto render = [&](const std::string& scene, const std::string& view, const std::string& option, const std::string& file) {
        return sphereview({"render", scene, "--view", view, "--size", "50x50", "--backend", "cpu", option, file}).status;
    };
    for (const std::string view : {"front", "right", "top", "iso", "20,30"}) {
        EXPECT_EQ(render("hand.txt", view, "-o", "hand.png"), 0);
        EXPECT_EQ(render("hand.xyz", view, "--expect", "hand.png"), 0) << view;
    }
    EXPECT_EQ(render("hand.txt", "front", "-o", "hand.png"), 0);
    EXPECT_EQ(sphereview({"render", "hand.xyz", "--size", "50x50", "--backend", "cpu", "--expect", "hand.png"}).status, 0);
    // As a native scene it keeps its hand, whatever view is asked for.
    EXPECT_EQ(sphereview({"convert", "hand.xyz", "hand.toml"}).status, 0);
    EXPECT_EQ(render("hand.toml", "front", "--expect", "hand.png"), 0);
}

// 40 points of some 20,000 nm: with spheres of radius 1 no pixel shows one.
TEST_F(Data, OfPointsAloneGetsARadiusThatIsSeen) {
    std::string text = "x,y,z\n";
    for (int i = 0; i < 40; ++i) {
        text +=
            std::to_string(i * 7919 % 20011) + "," + std::to_string(i * 104729 % 20021) + "," + std::to_string(i * 31 % 400) + "\n";
    }
    folder_.write("nm.csv", text);
    const std::vector<std::string> usual = {"render", "nm.csv", "-s", "300x300", "--backend", "cpu"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), usual.begin(), usual.end());
        return sphereview(more);
    };
    const Outcome outcome = with({});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome;
    EXPECT_TRUE(outcome.errors.starts_with("nm.csv: no radius in the file: all get ")) << outcome;
    const Picture picture = decode_png(folder_.read("nm.png"));
    int drawn = 0;
    for (int y = 0; y < 300; ++y) {
        for (int x = 0; x < 300; ++x) drawn += picture.at(x, y)[0] > 0 ? 1 : 0;
    }
    EXPECT_GT(drawn, 90);
    EXPECT_LT(drawn, 45000);

    const Outcome blind = with({"--radius", "1e-3"});
    EXPECT_EQ(blind.status, 0) << blind;
    EXPECT_EQ(lines(blind.errors).size(), 1U) << blind;
    EXPECT_TRUE(blind.errors.starts_with("nm.csv: no pixel shows a sphere, though the camera sees all: ")) << blind;
    EXPECT_EQ(with({"--radius", "1e-3", "--no-fit"}).errors, "");  // the eye is in the first
}

TEST_F(Data, OfWhichNoPixelShowsASphereIsWarnedOf) {
    const std::string said = "a.txt: no pixel shows a sphere; --fit frames all";
    for (const char* place : {"0 0 -300", "900 0 300"}) {  // behind the eye, and beside the picture
        folder_.write("a.txt", std::string("1  255 0 0  ") + place + " 50");
        const Outcome outcome = sphereview({"render", "a.txt", "-s", "20x20", "--backend", "cpu", "--json"});
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_EQ(outcome.errors, said + "\n");
        EXPECT_EQ(Json::parse(outcome.output)["warnings"], Json::parse("[\"" + said + "\"]"));
    }
    EXPECT_EQ(sphereview({"render", "a.txt", "-s", "20x20", "--fit"}).errors, "");
    folder_.write("a.txt", "0\n");
    EXPECT_EQ(sphereview({"render", "a.txt", "-s", "20x20"}).errors, "") << "there is none";
}

TEST_F(Data, SaysWhatItLeavesOutAndPassesOver) {
    folder_.write("a.csv", "x,y,z,radius,mass\x1B[31m\n0,0,0,1,5\nnan,nan,nan,1,5\n");
    const std::vector<std::string> usual = {"render", "a.csv", "-s", "9x9", "--backend", "cpu"};
    const std::string warning = "a.csv: 1 row has no coordinates and is left out\n";
    EXPECT_EQ(sphereview(usual).errors, warning);
    std::vector<std::string> verbose = usual;
    verbose.emplace_back("--verbose");
    const std::string columns = "a.csv: columns that are passed over: 'mass\\x1b[31m'; --color-by and --size-by can use them\n";
    EXPECT_TRUE(sphereview(verbose).errors.starts_with(warning + columns));
    std::vector<std::string> json = usual;
    json.emplace_back("--json");
    const auto report = Json::parse(sphereview(json).output);
    EXPECT_EQ(report["warnings"], Json{"a.csv: 1 row has no coordinates and is left out"});
    EXPECT_EQ(report["notes"].size(), 1U);
    EXPECT_EQ(report["properties"], (Json{"radius", "mass\x1B[31m"}));
    EXPECT_EQ(sphereview({"convert", "a.csv", "a.txt"}).errors, warning);
    EXPECT_EQ(sphereview({"convert", "a.csv", "a.txt", "--verbose"}).errors, warning + columns + "a.csv: CSV, 1 sphere\n");
    EXPECT_EQ(sphereview({"explain", "a.csv", "--pixel", "1,1", "--size", "9x9"}).errors, warning);
}

TEST_F(Data, HasTheColumnsThatAreAskedFor) {
    folder_.write("a.dat", "a b c d\n1 2 3 4\n");
    const std::string sphere = "1\n255 255 255\n1 2 3\n4\n";
    EXPECT_EQ(as_text({"a.dat", "--columns", "x=a,y=b,z=c,radius=d"}), sphere);
    EXPECT_EQ(as_text({"a.dat", "--columns", "x=1,y=2,z=3,radius=4"}), sphere);
    EXPECT_EQ(sphereview({"explain", "a.dat", "-p", "1,1", "--columns", "x=a,y=b,z=c,radius=d"}).status, 0);
    EXPECT_EQ(sphereview({"render", "a.dat", "-s", "9x9", "--backend", "cpu", "--columns", "x=a,y=b,z=c,radius=d"}).status, 0);
    const Outcome wrong = sphereview({"convert", "a.dat", "-", "--columns", "w=a"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_TRUE(wrong.errors.starts_with("sphereview: --columns: found 'w=a', expected COLUMN=NAME")) << wrong;
}

TEST_F(Data, OfAnotherKindSaysWhatItIs) {
    const std::string formats = ", expected text, TOML, XYZ, CSV, PDB, mmCIF, LAMMPS, GROMACS, POSCAR, SDF, PQR or PLY";
    folder_.write("a.mol2", "@<TRIPOS>MOLECULE\n");
    folder_.write("b.xyz.bz2", "BZh91AY&SY");
    folder_.write("c.csv", "\xFF\xD8\xFF\xE0 JFIF");
    expect_fault({"render", "a.mol2"}, "a.mol2: found a MOL2 file" + formats);
    expect_fault({"convert", "b.xyz.bz2", "b.txt"},
                 "b.xyz.bz2: found a file that is packed with bzip2, which is not unpacked here: gzip is" + formats);
    expect_fault({"explain", "c.csv", "-p", "1,1"}, "c.csv: found a JPEG picture" + formats);
}

// What is read all the same is said in one line on stderr, and by --json.
TEST_F(Data, IsShownWithAWarning) {
    folder_.write("cut.xyz", "1\n\nH 0 0 100\n2\n\nH 0 0 100\n");
    folder_.write("sites.xyz", "2\n\nO 0 0 100\nMW 0 0 100\n");
    const std::string cut = "cut.xyz:7:1: the text ends, expected atom 2 of 2 of frame 1; what follows frame 0 is passed over";
    const std::string sites = "sites.xyz: found 1 virtual site or dummy, which is no atom; ";
    const auto expect_warning = [&](const std::vector<std::string>& arguments, const std::string& warning) {
        const Outcome outcome = sphereview(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_TRUE(outcome.errors.starts_with(warning + "\n")) << outcome;
        return outcome.output;
    };
    EXPECT_EQ(expect_warning({"convert", "cut.xyz", "-", "--to", "text"}, cut), "1\n255 255 255\n0 0 100\n0.31\n");
    expect_warning({"explain", "cut.xyz", "-p", "5,5"}, cut);
    const std::vector<std::string> render = {"render", "cut.xyz", "-s", "8x8", "--backend", "cpu", "--json"};
    EXPECT_EQ(Json::parse(expect_warning(render, cut))["warnings"], (Json{cut}));
    expect_fault({"convert", "cut.xyz", "a.txt", "--frame", "1"}, "cut.xyz:7:1: the text ends, expected atom 2 of 2 of frame 1");

    EXPECT_EQ(expect_warning({"convert", "sites.xyz", "-", "--to", "text"}, sites + "shown small, or not with --no-virtual"),
              "2\n255 13 13\n0 0 100\n0.66\n255 20 147\n0 0 100\n0.2\n");
    EXPECT_EQ(expect_warning({"convert", "sites.xyz", "-", "--to", "text", "--no-virtual"}, sites + "left out"),
              "1\n255 13 13\n0 0 100\n0.66\n");
}

TEST_F(Data, ThatIsBadIsReportedInOneLine) {
    folder_.write("a.xyz", "1\n\nH 1 two 3\n");
    folder_.write("a.csv", "x,y,z\n1,2\n");
    expect_fault({"convert", "a.xyz", "a.txt"}, "a.xyz:3:5: found 'two', expected the y of atom 1 of 1, a number");
    expect_fault({"render", "a.csv"}, "a.csv:2:4: the line ends, expected z");
    EXPECT_FALSE(folder_.has("a.txt"));
    EXPECT_FALSE(folder_.has("a.png"));
}

#ifndef WITHOUT_GEMMI
TEST_F(Data, OfMoleculesIsConvertedAndRendered) {
    folder_.write("a.pdb",
                  "MODEL        1\nATOM      1  N   ALA A  12       0.000   0.000 200.000  1.00 13.79           N\nENDMDL\n"
                  "MODEL        2\nHETATM    1  O   HOH A  12       1.000   0.000 200.000  1.00 13.79           O\nENDMDL\nEND\n");
    folder_.write("a.cif",
                  "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
                  "_atom_site.pdbx_PDB_model_num\nN 0 0 200 1\nO 1 0 200 2\n");
    EXPECT_EQ(as_text({"a.pdb"}), "1\n48 80 248\n0 0 200\n0.71\n");
    EXPECT_EQ(as_text({"a.pdb", "--frame", "1", "--radius", "20"}), "1\n255 13 13\n1 0 200\n20\n");
    EXPECT_EQ(as_text({"a.cif"}), as_text({"a.pdb"}));
    EXPECT_EQ(as_text({"-"}, folder_.read("a.cif")), as_text({"a.pdb"}));
    EXPECT_EQ(as_text({"-"}, folder_.read("a.pdb")), as_text({"a.pdb"}));
    folder_.write("b.pdb.gz", gzipped(folder_.read("a.pdb")));
    folder_.write("b.mmcif.gz", gzipped(folder_.read("a.cif")));
    EXPECT_EQ(as_text({"b.pdb.gz"}), as_text({"a.pdb"}));
    EXPECT_EQ(as_text({"b.mmcif.gz"}), as_text({"a.pdb"}));
    EXPECT_EQ(sphereview({"render", "b.pdb.gz", "--backend", "cpu", "-s", "20x20"}).status, 0);
    EXPECT_TRUE(folder_.has("b.png"));
}
#endif

TEST_F(Data, HasOnlyTheFramesItHas) {
    folder_.write("a.xyz", two_frames);
    folder_.write("a.csv", "x,y,z\n");
    folder_.write("a.txt", "0");
    folder_.write("a.toml", "background = 'white'");
    expect_fault({"convert", "a.xyz", "b.txt", "--frame", "2"}, "a.xyz: found 2 frames, 0 to 1, expected frame 2");
    for (const std::string name : {"a.csv", "a.txt", "a.toml"}) {
        expect_fault({"render", name, "--frame", "1"}, name + ": found 1 frame, number 0, expected frame 1");
        EXPECT_EQ(sphereview({"convert", name, "b.txt", "--frame", "0", "--radius", "1e-3"}).status, 0);
    }
}

TEST(Gzip, APackedSceneIsRenderedUnderItsOwnName) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    folder.write("packed.txt.gz", gzipped(red_scene));
    folder.write("Other.TOML.GZ", gzipped("[[sphere]]\ncolor = [255, 0, 0]\ncenter = [0, 0, 200]\nradius = 20\n"));
    folder.write("no-ending.gz", gzipped(red_scene));
    const Outcome outcome = render(folder, {"red.txt", "packed.txt.gz", "Other.TOML.GZ", "no-ending.gz", "-s", "5x5"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.errors, "");
    for (const std::string name : {"packed.png", "Other.png", "no-ending.png"}) {
        ASSERT_TRUE(folder.has(name)) << name;
        EXPECT_TRUE(folder.read(name) == folder.read("red.png")) << name;
    }
}

TEST(Gzip, AFaultIsPlacedInTheText) {
    const TemporaryFolder folder;
    folder.write("bad.txt.gz", gzipped(bad_scene));
    EXPECT_TRUE(fails(render(folder, {"bad.txt.gz"}), 2, "bad.txt.gz:4:1: found '-5', expected "));
}

TEST(Gzip, ABombIsRefusedInLittleMemory) {
    const TemporaryFolder folder;
    // 1000 members of 1 MB of spaces: 1 GB in 1 MB. As a text it needs memory only until it is refused.
    const std::string spaces = gzipped(std::string(1'000'000, ' '));
    std::string bomb = gzipped("1\n");
    for (int i = 0; i < 1000; ++i) bomb += spaces;
    folder.write("bomb.txt.gz", bomb);
    EXPECT_TRUE(fails(render(folder, {"bomb.txt.gz"}), 2,
                      "bomb.txt.gz: cannot be unpacked: its text is longer than 250 times the file, as no scene's is\n"));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"bomb.txt.gz"});
}

#ifndef SPHEREVIEW_SANITIZED  // AddressSanitizer reserves more address space than any sensible limit
// Small files whose texts, or what is made of them, are large: the figures are told before memory runs out.
TEST(Gzip, WhatDoesNotFitInMemoryIsRefusedWithTheFigures) {
    const TemporaryFolder folder;
    const auto repeated = [](const std::string& row, int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += row;
        return text;
    };
    folder.write("a.csv.gz", gzipped("x,y,z\n" + repeated("0,0,0\n", 6'000'000)));
    folder.write("a.toml.gz", gzipped("hidden = [" + repeated("0,", 4'000'000) + "]\n"));
    std::vector<std::pair<std::string, std::string>> cases = {
        {"a.csv.gz", "a.csv.gz: up to 6,000,000 spheres need 240 MB of memory, "},
        {"a.toml.gz", "a.toml.gz: its values need 344 MB of memory, "}};
#ifndef WITHOUT_GEMMI
    folder.write("a.cif.gz", gzipped("data_\nloop_\n_a.b\n" + repeated("0 ", 5'000'000)));
    cases.emplace_back("a.cif.gz", "a.cif.gz: its values need 340 MB of memory, ");
#endif
    for (const auto& [name, said] : cases) {
        Command command = cpu_render(folder, {name, "-s", "5x5"});
        command.most_memory = 300'000'000;
        const Outcome outcome = run(command);
        EXPECT_TRUE(fails(outcome, 3, said));
        EXPECT_TRUE(outcome.errors.ends_with(" MB are available\n")) << outcome;
    }
}
#endif

}  // namespace
}  // namespace sphereview::test
