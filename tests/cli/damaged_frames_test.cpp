// Pictures of frames of files that are cut off, wrong or changed.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "cli/fails.hpp"
#include "cli/frames.hpp"
#include "support/eventually.hpp"
#include "support/gzip.hpp"
#include "support/json.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

const std::string pdb_atom = "ATOM      1  N   ALA A   1       1.000   0.000   0.000  1.00  0.00           N\n";
const std::string pdb_model = "MODEL\n" + pdb_atom + pdb_atom + "ENDMDL\n";

class DamagedFrames : public Frames {
protected:
    // "0; 0 1 2; WORDS": the status, the frames of which there are pictures, and what was said.
    std::string made(const std::string& file, const std::string& frames, const std::vector<std::string>& more = {}) const {
        const Outcome outcome = render(all_words({file, "--frames", frames, "-s", "9x9", "-o", "out/{frame}.png"}, more));
        std::vector<std::string> pictures;
        std::error_code ignored;  // there may be no folder
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path("out"), ignored)) {
            pictures.push_back(entry.path().stem().string());
        }
        std::ranges::sort(pictures);
        std::filesystem::remove_all(folder_.path("out"));
        std::string all = std::to_string(outcome.status) + ";";
        for (const std::string& picture : pictures) all += " " + picture;
        return all + "; " + outcome.errors;
    }
};

// Of many that fail each for itself, the last line names some.
TEST_F(DamagedFrames, NameSomeOfManyThatFail) {
    std::string text;
    for (int i = 0; i < 14; ++i) text += "1\n\nO " + std::to_string(i) + " x 0\n";
    folder_.write("a.xyz", moving_atom(1) + text);
    const std::string said = made("a.xyz", "all");
    EXPECT_TRUE(said.starts_with("2; 0; ")) << said;
    EXPECT_TRUE(contains(said, "\nsphereview: 14 of 15 pictures failed: a.xyz, 1; a.xyz, 2; ")) << said;
    EXPECT_TRUE(said.ends_with("; a.xyz, 10; and 4 more\n")) << said;
}

// The camera sees what the others hold, in every part.
TEST_F(DamagedFrames, DoNotStopTheOthersThatOneCameraSees) {
    const auto frames = [](const std::string& second) {
        return "1\n\nO 0 0 0\n1\n\nO " + second + "\n1\n\nO 5 0 0\n1\n\nO 9 0 0\n";
    };
    folder_.write("a.xyz", frames("7 0 0"));
    expect_done({"a.xyz", "--frames", "0,2,3", "-s", "30x20", "-o", "good/{frame}"});
    folder_.write("a.xyz", frames("7 x 0"));
    const std::string fault = "a.xyz:6:5: found 'x', expected the y of atom 1 of 1, a number\n";
    const std::vector<std::string> parts = {"1/2", "2/2"};
    for (const std::string& part : parts) {
        const Outcome outcome = render({"a.xyz", "--frames", "all", "-s", "30x20", "-o", "parts/{frame}", "--part", part,
                                        "--manifest", part == "1/2" ? "1.jsonl" : "2.jsonl"});
        EXPECT_EQ(outcome.status, part == "1/2" ? 0 : 2) << outcome;
        EXPECT_EQ(outcome.errors, part == "1/2" ? "" : fault + "sphereview: 1 of 2 pictures failed: a.xyz, 1\n");
    }
    EXPECT_FALSE(folder_.has("parts/1.png"));
    for (const char* name : {"0.png", "2.png", "3.png"}) {
        EXPECT_TRUE(folder_.read(std::string("parts/") + name) == folder_.read(std::string("good/") + name)) << name;
    }
    const Outcome proved = sphereview({"verify", "1.jsonl", "2.jsonl", "--backend", "cpu"});
    EXPECT_EQ(proved.output, "3 of 3 pictures rendered again: all are equal\n");
    EXPECT_EQ(proved.errors, "1 of 4 pictures has no line: a.xyz, 1\n");

    // Of the first frame come ranges and radii, too; and a film is there whole or not at all.
    EXPECT_EQ(made("a.xyz", "1:"), "2;; " + fault);
    EXPECT_TRUE(fails(render({"a.xyz", "--frames", "all", "-s", "9x9", "-o", "-"}), 2, fault));
}

TEST_F(DamagedFrames, SayOnceWhatSeveralHaveWrong) {
    const std::string without = "1\nProperties=species:S:1:pos:R:3\nO 0 0 0\n";
    folder_.write("a.xyz", "1\nProperties=species:S:1:pos:R:3:q:R:1\nO 0 0 0 1\n" + without + without);
    EXPECT_EQ(made("a.xyz", "all", {"--size-by", "q"}),
              "2; 0; a.xyz: radii by q: 1 times the value\n"
              "a.xyz: found no property 'q', expected one that the file has, element, or x, y, z or radius\n"
              "sphereview: 2 of 3 pictures failed: a.xyz, 1; a.xyz, 2\n");
}

TEST_F(DamagedFrames, OfOneSceneStopNoOtherScene) {
    folder_.write("a.xyz", moving_atom(2));
    folder_.write("b.xyz", "1\n\nO x 0 0\n" + moving_atom(2));
    folder_.write("c.xyz", moving_atom(1));
    const std::string said =
        "c.xyz: found 1 frame, number 0, expected frame 1\n"
        "b.xyz:3:3: found 'x', expected the x of atom 1 of 1, a number\n";
    for (const char* skip : {"--no-sync", "--skip-existing"}) {
        const Outcome outcome = render({"c.xyz", "b.xyz", "a.xyz", "--frames", "0,1", "-s", "9x9", "--manifest", "made.jsonl", "-o",
                                        "out/{name}{frame}", skip});
        EXPECT_EQ(outcome.status, 2) << outcome;
        const bool is_first = std::string(skip) == "--no-sync";
        EXPECT_EQ(outcome.errors, said + "sphereview: 2 of " + (is_first ? "3" : "2") + " scenes failed: c.xyz b.xyz\n");
    }
    EXPECT_TRUE(folder_.has("out/a0.png") && folder_.has("out/a1.png") && !folder_.has("out/b1.png"));
}

// It is reported in its turn, and nothing is written over what it is read from.
TEST_F(DamagedFrames, OfASceneThatCannotBeOpenedAreReported) {
    folder_.write("a.xyz", moving_atom(2));
    folder_.write("bad.xyz", "x\n");
    const std::vector<std::string> arguments = {"a.xyz", "bad.xyz", "--frames", "all", "-s", "9x9", "-o", "out/{name}{frame}"};
    const Outcome outcome = render(all_words(arguments, {"--json"}));
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_TRUE(outcome.errors.ends_with("\nsphereview: 1 of 2 scenes failed: bad.xyz\n")) << outcome;
    const std::vector<std::string> reports = lines(outcome.output);
    ASSERT_EQ(reports.size(), 3U) << outcome;
    const Json last = Json::parse(reports[2]);
    EXPECT_EQ(last["scene"], "bad.xyz");
    EXPECT_EQ(last["status"], 2);
    EXPECT_TRUE(outcome.errors.starts_with(std::string(last["error"]) + "\n")) << outcome;
    const Outcome alone = render({"bad.xyz", "--frames", "all", "--json"});
    EXPECT_EQ(lines(alone.output).size(), 1U) << alone;
    EXPECT_TRUE(fails(alone, 2, "bad.xyz"));

    EXPECT_TRUE(fails(render(all_words(arguments, {"--manifest", "bad.xyz"})), 2,
                      "bad.xyz: cannot be both the manifest and the scene bad.xyz"));
    EXPECT_EQ(folder_.read("bad.xyz"), "x\n");
    // Where there is no scene at all, an earlier manifest stays.
    folder_.write("made.jsonl", "earlier\n");
    const Outcome none = render({"bad.xyz", "missing.xyz", "--frames", "all", "--manifest", "made.jsonl"});
    EXPECT_EQ(none.status, 2) << none;
    EXPECT_TRUE(none.errors.ends_with("\nsphereview: 2 of 2 scenes failed: bad.xyz missing.xyz\n")) << none;
    EXPECT_EQ(folder_.read("made.jsonl"), "earlier\n");
    // Parts count its pictures, too: with other places than elsewhere some would be made twice, and some never.
    EXPECT_TRUE(
        fails(render({"missing.xyz", "a.xyz", "--frames", "all", "--part", "2/2", "-o", "parts/{frame}"}), 2, "missing.xyz: "));
    EXPECT_FALSE(folder_.has("parts"));
}

#ifdef __linux__
// The frames behind those that are in memory are gone: that is said once.
TEST_F(DamagedFrames, AreLostTogetherWhereTheFileBecomesShorter) {
    std::string text;
    for (int i = 0; i < 20; ++i) text += "1\n" + std::string(1'000'000, 'c') + "\nO 0 0 0\n";
    folder_.write("a.xyz", text);
    ASSERT_EQ(mkfifo(folder_.path("2.png").c_str(), 0600), 0);
    const OneCore one;
    Running program(cpu_render(folder_, {"a.xyz", "--frames", "all", "-s", "9x9", "-o", "{frame}"}));
    ASSERT_TRUE(eventually([&] { return folder_.has("1.png"); }));
    std::filesystem::resize_file(folder_.path("a.xyz"), 1'000'000);
    // Whether the program waits for a reader of its third picture, or finds the file shorter before: neither waits for ever.
    const int reader = open(folder_.path("2.png").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(reader, 0);
    const Outcome outcome = program.wait();
    close(reader);
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_TRUE(matches(outcome.errors,
                        "a.xyz: cannot be read: it has become shorter meanwhile\n"
                        "sphereview: ended where a scene could not be read; [0-9]+ of 20 pictures were done\n"))
        << outcome;
}
#endif

TEST_F(DamagedFrames, WarnOncePerFile) {
    folder_.write("cut.xyz", moving_atom(2) + "2\n\nO 1 0 0\n");
    EXPECT_EQ(made("cut.xyz", "all"),
              "0; 0 1; cut.xyz:10:1: the text ends, expected atom 2 of 2 of frame 2; what follows frame 1 is passed over\n");
}

// As a program leaves it that was ended while it wrote.
TEST_F(DamagedFrames, EndBeforeOneThatIsCutWithinItsLine) {
    folder_.write("cut.xyz", moving_atom(2) + "2\n\nO 1 0 0\nO 1 0");
    const std::string fault = "cut.xyz:10:6: the text ends, expected the whole line of the last atom of frame 2";
    EXPECT_EQ(made("cut.xyz", "all"), "0; 0 1; " + fault + "; what follows frame 1 is passed over\n");
    EXPECT_EQ(made("cut.xyz", ":7"), "0; 0 1; " + fault + "; what follows frame 1 is passed over\n");
    EXPECT_EQ(made("cut.xyz", "1:"), "0; 1; " + fault + "; what follows frame 1 is passed over\n");
    for (const char* frames : {"2", "0,2"}) {
        EXPECT_EQ(made("cut.xyz", frames), "2;; cut.xyz: found 2 frames, 0 to 1, expected frame 2; " + fault + "\n");
    }
}

// Of files that are read whole, too.
TEST_F(DamagedFrames, OfAPdbFileEndBeforeOneThatIsCutWithinItsLine) {
    folder_.write("cut.pdb", pdb_model + pdb_model + pdb_model.substr(0, 50));
    EXPECT_EQ(
        made("cut.pdb", "all"),
        "0; 0 1; cut.pdb:10:45: the line ends, expected the atom's y in columns 39 to 46; what follows frame 1 is passed over\n");
    EXPECT_TRUE(made("cut.pdb", "2").starts_with("2;; "));
}

TEST_F(DamagedFrames, OfAPdbFileEndBeforeAModelWithoutItsEnd) {
    folder_.write("cut.pdb", pdb_model + pdb_model + "MODEL\n" + pdb_atom);
    const std::string fault = "cut.pdb:11:1: the text ends, expected ENDMDL of frame 2";
    EXPECT_EQ(made("cut.pdb", "all"), "0; 0 1; " + fault + "; what follows frame 1 is passed over\n");
    EXPECT_TRUE(made("cut.pdb", "2").ends_with(fault + "\n"));
    const Outcome one = render({"cut.pdb", "--frame", "2", "-s", "9x9"});
    EXPECT_EQ(one.status, 2) << one;
    EXPECT_TRUE(one.errors.ends_with(fault + "\n")) << one;
}

// Others may be lost with its end, but for those before it.
TEST_F(DamagedFrames, OfAPdbFileFollowOneThatIsCutOff) {
    folder_.write("a.pdb", pdb_model + "MODEL\n" + pdb_atom + pdb_model);
    const std::string cut = "a.pdb:7:1: found 'MODEL', expected ENDMDL of frame 1 above it; frame 1 may be cut off\n";
    EXPECT_EQ(made("a.pdb", "all"), "2; 0 1 2; " + cut);
    EXPECT_EQ(made("a.pdb", "-1,0"), "2; 0 2; " + cut);
    EXPECT_EQ(made("a.pdb", "1"), "2; 1; " + cut);
    EXPECT_EQ(made("a.pdb", "0"), "0; 0; ");
    // Nor with a cut off end behind them.
    folder_.write("b.pdb", folder_.read("a.pdb") + pdb_model.substr(0, 50));
    EXPECT_TRUE(made("b.pdb", "0").starts_with("0; 0; b.pdb:12:45: the line ends, "));
    EXPECT_TRUE(made("b.pdb", "1").starts_with("2; 1; "));
    const Outcome one = render({"a.pdb", "--frame", "1", "-s", "9x9"});
    EXPECT_EQ(one.status, 0) << one;
    EXPECT_EQ(one.errors, cut);
}

#ifndef WITHOUT_GEMMI
TEST_F(DamagedFrames, OfAnMmcifFileSayOnceWhereTheyEnd) {
    folder_.write("cut.cif",
                  "data_own\nloop_\n_atom_site.pdbx_PDB_model_num\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
                  "1 0 0 0\n2 0 0 0\n3 0 0 0\n3 1 0");
    const std::string said = made("cut.cif", "all");
    EXPECT_TRUE(said.starts_with("0; 0 1; ")) << said;
    EXPECT_EQ(said.find("; what follows frame 1 is passed over\n") + 38, said.size()) << said;
}
#endif

// There were more, which nobody can find.
TEST_F(DamagedFrames, ThatAreLostGiveAnotherStatus) {
    folder_.write("a.xyz", moving_atom(3) + "2x\n\nO 0 0 0\nO 1 0 0\n" + moving_atom(2));
    const std::string fault =
        "a.xyz:10:1: found '2x', expected the number of atoms of frame 3, a whole number; what follows frame 2 is passed over\n";
    EXPECT_EQ(made("a.xyz", "all"), "2; 0 1 2; " + fault);
    EXPECT_EQ(made("a.xyz", "1:4"), "2; 1 2; " + fault);
    EXPECT_EQ(made("a.xyz", "0:3"), "0; 0 1 2; ");
    const std::vector<std::string> all = {"a.xyz", "--frames", "all", "-s", "9x9", "--skip-existing"};
    EXPECT_EQ(render(all).status, 2);
    EXPECT_EQ(render(all).status, 2) << "they are not there either";
}

TEST_F(DamagedFrames, OfADumpAreLostBehindOneWithoutTheHeadOfItsAtoms) {
    const std::string begin = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n";
    const std::string frame = begin + "ITEM: ATOMS id type x y z radius\n1 1 0 0 0 1\n";
    folder_.write("a.lammpstrj", frame + begin + "1 1 0 0 0 1\n" + frame + frame);
    EXPECT_EQ(made("a.lammpstrj", "all"),
              "2; 0; a.lammpstrj:19:1: found '1', expected ITEM: ATOMS of frame 1; what follows frame 0 is passed over\n");
}

// Nobody can tell how many frames it had.
TEST_F(DamagedFrames, AreRefusedOfAPackedFileThatIsCutOff) {
    const std::string packed = gzipped(moving_atom(2));
    folder_.write("a.xyz.gz", packed.substr(0, packed.size() - 9));
    const std::string said = "2;; a.xyz.gz: cannot be unpacked: its gzip data end too early\n";
    EXPECT_EQ(made("a.xyz.gz", "all"), said);
    EXPECT_EQ(made("a.xyz.gz", "all", {"--fit", "first"}), said);
}

}  // namespace
}  // namespace sphereview::test
