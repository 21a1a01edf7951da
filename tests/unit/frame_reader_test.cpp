// Reading frame by frame gives what reading the whole file gives.
#include "formats/frame_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "base/background_job.hpp"
#include "formats/scene_format.hpp"
#include "support/gzip.hpp"
#include "support/temporary_folder.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

// Frames of 1, 2, ... atoms; of each format that steps over them.
std::map<std::string, std::string> trajectories(int frames) {
    std::map<std::string, std::string> texts;
    for (int frame = 0; frame < frames; ++frame) {
        const std::string count = std::to_string(frame + 1);
        std::string& xyz = texts["a.xyz"] += "\n" + count + "\nframe " + std::to_string(frame) + "\n";
        std::string& dump = texts["a.lammpstrj"] +=
            "ITEM: TIMESTEP\n" + std::to_string(frame) + "\nITEM: NUMBER OF ATOMS\n" + count +
            "\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS id type xs ys zs radius\n";
        std::string& gro = texts["a.gro"] += "frame\n" + count + "\n";
        std::string& sdf = texts["a.sdf"] += "a\n\n\n  " + count + "  0  0     0  0            999 V2000\n";
        for (int atom = 0; atom <= frame; ++atom) {
            const std::string x = std::to_string(10 * frame + atom);
            xyz += "O " + x + " 0 0\n";
            dump += std::to_string(atom + 1) + " 1 0." + x + " 0 0 0.5\n";
            gro +=
                "    1SOL     OW    1   0." + std::string(2 - std::min<std::size_t>(x.size(), 2), '0') + x + "0   0.000   0.000\n";
            sdf += "    " + x + ".0 0.0 0.0 O 0\n";
        }
        gro += "   1.0 1.0 1.0\n";
        sdf += "M  END\n$$$$\n";
    }
    return texts;
}

// An XDATCAR of 30 frames: the first ten share a head, the next ten have one each, with other cells and numbers of atoms, and the
// last ten share the last of these. `atoms`: in each line, so much more of them than without.
std::string xdatcar(int atoms = 1) {
    std::string text;
    for (int frame = 0; frame < 30; ++frame) {
        const int count = atoms * (frame < 10 ? 2 : std::min(frame, 19) - 8);
        if (frame == 0 || (frame >= 10 && frame < 20)) {
            text += " \n1\n" + std::to_string(10 + frame) + " 0 0\n0 10 0\n0 0 10\nO H\n1 " + std::to_string(count - 1) + "\n";
        }
        text += "Direct configuration= " + std::to_string(frame + 1) + "\n";
        for (int atom = 0; atom < count; ++atom)
            text += "0." + std::to_string(frame) + " 0.5 0." + std::to_string(atom % 10) + "\n";
    }
    return text + "\n";
}

SphereData read_at_once(const std::string& text, const std::string& name, std::int64_t frame) {
    return format_of_name(name).read(text, name, {.frame = frame});
}

class FrameReading : public testing::Test {
protected:
    // Whether a text in which so many frames stand before a fault is damaged there.
    bool is_damaged(const std::string& text, std::int64_t frames) const {
        FrameReader reader(folder_.write("a.xyz", text), {});
        EXPECT_EQ(reader.count(), frames);
        EXPECT_NE(reader.fault(), "");
        return reader.is_damaged();
    }

    test::TemporaryFolder folder_;
};

}  // namespace

TEST_F(FrameReading, GivesEachFrameInAnyOrder) {
    for (const auto& [name, text] : trajectories(5)) {
        SCOPED_TRACE(name);
        std::string crlf;
        for (const char c : text) crlf += c == '\n' ? "\r\n" : std::string(1, c);
        const std::string plain = folder_.write(name, text);
        const std::string marked = folder_.write("marked-" + name, "\xEF\xBB\xBF" + text);
        const std::string windows = folder_.write("windows-" + name, crlf);
        const std::string packed = folder_.write(name + ".gz", test::gzipped(text));
        for (const std::string& path : {plain, marked, windows, packed}) {
            SCOPED_TRACE(path);
            FrameReader reader(path, {});
            for (const std::int64_t frame : {1, 0, 4, 2, 2, 3}) {
                EXPECT_EQ(reader.read(frame).scene, read_at_once(text, name, frame).scene) << frame;
            }
            EXPECT_EQ(reader.count(), 5);
            EXPECT_EQ(reader.count(2), 2);
            EXPECT_EQ(reader.fault(), "");
            EXPECT_EQ(message_of<InputError>([&] { reader.read(5); }), path + ": found 5 frames, 0 to 4, expected frame 5");
        }
    }
}

// Also of a packed one, whose text is of unknown length.
TEST_F(FrameReading, OfXdatcarFindsTheHeadThatHolds) {
    for (const std::string& text : {xdatcar(), xdatcar(4000)}) {  // in one window, and in several
        const std::string path = folder_.write("XDATCAR", text);
        FrameReader reader(path, {});
        for (const std::int64_t frame : {29, 0, 15, 19, 20, 9, 10}) {
            EXPECT_EQ(reader.read(frame).scene, read_at_once(text, path, frame).scene) << frame;
        }
        EXPECT_EQ(reader.count(), 30);
        EXPECT_EQ(reader.fault(), "");
        EXPECT_EQ(reader.read(29).warnings, std::vector<std::string>());
    }
}

TEST_F(FrameReading, OfXdatcarSaysWhereAFrameIsWrong) {
    std::string text = xdatcar();
    const std::string path = folder_.write("XDATCAR", text.replace(text.rfind("0.29 0.5"), 8, "0.29 x  "));
    FrameReader reader(path, {});
    const std::string said = message_of<InputError>([&] { read_at_once(text, path, 29); });
    EXPECT_TRUE(said.ends_with("found 'x', expected the y of atom 11 of 11, a number")) << said;
    EXPECT_EQ(message_of<InputError>([&] { reader.read(29); }), said);
}

// What follows the atoms is no frame.
TEST_F(FrameReading, OfPoscarThereIsOneFrame) {
    const std::string text = "a\n1\n9 0 0\n0 9 0\n0 0 9\nO\n2\nDirect\n0 0 0\n0.5 0 0\n\n0.1 0.2 0.3\n0.1 0.2 0.3\n";
    FrameReader reader(folder_.write("POSCAR", text), {});
    EXPECT_EQ(reader.count(), 1);
    EXPECT_EQ(reader.fault(), "");
    EXPECT_EQ(reader.read(0).scene, read_at_once(text, "POSCAR", 0).scene);
}

// Zero bytes behind the last frame, as some programs write them.
TEST_F(FrameReading, EndsWhereTheTextDoes) {
    for (const auto& [name, text] : trajectories(3)) {
        FrameReader reader(folder_.write(name, text + std::string(5, '\0')), {});
        EXPECT_EQ(reader.count(), 3) << name;
        EXPECT_EQ(reader.fault(), "") << name;
        const SphereData last = reader.read(2);
        EXPECT_EQ(last.scene, read_at_once(text, name, 2).scene) << name;
        EXPECT_TRUE(last.warnings.empty()) << name;
    }
}

TEST_F(FrameReading, TellsHowFarItIsAndCanBeStopped) {
    for (const auto& [name, text] : trajectories(9)) {
        for (const std::string& path : {folder_.write(name, text), folder_.write(name + ".gz", test::gzipped(text))}) {
            SCOPED_TRACE(path);
            std::vector<double> parts;
            FrameReader told(path, {});
            told.watch([&](double part) { parts.push_back(part); });
            EXPECT_EQ(told.count(), 9);
            EXPECT_EQ(parts.size(), 9U);
            EXPECT_TRUE(std::ranges::is_sorted(parts));
            EXPECT_EQ(parts.back(), 1.0);
            FrameReader stopped(path, {});
            stopped.watch([](double) { throw Cancelled(); });
            EXPECT_THROW(stopped.count(), Cancelled);
        }
    }
}

// Longer than what is read at a time, so that frames go over the window's end, and lines, too.
TEST_F(FrameReading, HoldsOnlyAPart) {
    std::string text;
    for (int frame = 0; frame < 40; ++frame) {
        text += "7000\nframe\n";
        for (int atom = 0; atom < 7000; ++atom) text += "Si " + std::to_string(frame) + " " + std::to_string(atom) + " 0.25\n";
    }
    ASSERT_GT(text.size(), 4'200'000U);
    for (const std::string& path : {folder_.write("long.xyz", text), folder_.write("long.xyz.gz", test::gzipped(text))}) {
        FrameReader reader(path, {});
        for (std::int64_t frame = 0; frame < 40; ++frame) {
            const Scene scene = reader.read(frame).scene;
            ASSERT_EQ(scene.spheres.size(), 7000U);
            EXPECT_EQ(scene.spheres[0].center.x, static_cast<double>(frame));
            EXPECT_EQ(scene.spheres[6999].center.y, 6999.0);
        }
        EXPECT_EQ(reader.count(), 40);
        EXPECT_EQ(reader.read(3).scene.spheres[1].center.x, 3.0);
    }
}

TEST_F(FrameReading, FaultsSayWhereInTheFile) {
    const std::string bad = "1\nfirst\nO 0 0 0\n2\nsecond\nO 0 0 0\nO 0 x 0\n1\nthird\nO 1 0 0\n3\nlast\nO 1 0 0\n";
    const std::string path = folder_.write("bad.xyz", bad);
    FrameReader reader(path, {});
    EXPECT_EQ(message_of<InputError>([&] { reader.read(1); }), path + ":7:5: found 'x', expected the y of atom 2 of 2, a number");
    EXPECT_EQ(reader.read(2).scene.spheres[0].center.x, 1.0);
    EXPECT_EQ(reader.count(), 3);
    EXPECT_EQ(reader.fault(), path + ":14:1: the text ends, expected atom 2 of 3 of frame 3");
    EXPECT_EQ(message_of<InputError>([&] { reader.read(3); }), reader.fault());

    // One more atom than the first frame says, whose element is a number.
    const std::string more = folder_.write("more.xyz", "1\nfirst\n8 0 0 0\n8 0 0 0\n");
    FrameReader one_more(more, {});
    EXPECT_EQ(one_more.count(), 1);
    EXPECT_EQ(one_more.fault(), more + ":4:3: found '0', expected the end of the line after the number of atoms of frame 1");

    const std::string empty = folder_.write("empty.xyz", "");
    EXPECT_EQ(message_of<InputError>([&] { FrameReader(empty, {}).count(); }),
              empty + ":1:1: the text is empty, expected the number of atoms of frame 0");
}

// Wherever a program was ended that wrote the last frame, it is there whole or not at all.
TEST_F(FrameReading, ACutAnywhereLeavesTheFramesBefore) {
    std::map<std::string, std::string> whole = trajectories(4);
    std::map<std::string, std::string> begun = trajectories(3);
    whole["XDATCAR"] = xdatcar();
    begun["XDATCAR"] = whole["XDATCAR"].substr(0, whole["XDATCAR"].rfind("Direct"));
    for (const auto& [name, text] : whole) {
        const std::int64_t before = name == "XDATCAR" ? 29 : 3;
        std::int64_t cuts = 0;
        for (std::size_t size = begun[name].size() + 1; size < text.size(); ++size) {
            SCOPED_TRACE(name + " " + std::to_string(size));
            FrameReader reader(folder_.write(name, text.substr(0, size)), {});
            const std::int64_t count = reader.count();
            EXPECT_TRUE(count == before || count == before + 1);
            EXPECT_FALSE(reader.is_damaged());
            if (count > before) {
                reader.read(before);
            } else if (!reader.fault().empty()) {
                ++cuts;
                EXPECT_EQ(message_of<InputError>([&] { reader.read(before); }), reader.fault());
            }
            reader.read(before - 1);
            // The same at once.
            const SphereData data = read_at_once(text.substr(0, size), name, 0);
            EXPECT_EQ(data.frames, count);
            EXPECT_EQ(data.warnings.empty(), reader.fault().empty());
        }
        EXPECT_GT(cuts, 40) << name;
    }
}

TEST_F(FrameReading, TellsDamageFromACut) {
    const std::string frame = "1\n\nO 0 0 0\n";
    EXPECT_TRUE(is_damaged(frame + frame + "2x\n\nO 0 0 0\n" + frame, 2));
    EXPECT_TRUE(is_damaged(frame + frame + "O 0 0 0\n" + frame, 2)) << "one atom more";
    EXPECT_FALSE(is_damaged(frame + frame + "x", 2));
    EXPECT_FALSE(is_damaged(frame + frame + "x\n\n", 2)) << "nothing was to be had behind it";
    EXPECT_FALSE(is_damaged(frame + frame + "2\n\nO 0 0 0\n", 2));
    // What follows may be farther than what is read at once.
    EXPECT_TRUE(is_damaged(frame + frame + "x\n" + std::string(std::size_t{5} << 20U, ' ') + "\n" + frame, 2));
}

TEST_F(FrameReading, ANumberOfAtomsThatSwallowsFramesIsDamage) {
    const std::string frame = "2\n1\nO 0 0 0\nH 0 0 1\n";
    EXPECT_TRUE(is_damaged(frame + "200\n1\nO 0 0 0\nH 0 0 1\n" + frame, 1));
    EXPECT_FALSE(is_damaged(frame + "200\n1\nO 0 0 0\nH 0 0 1\n", 1)) << "its comment is no frame";
}

// What a file system leaves of a file that was made larger before it was written.
TEST_F(FrameReading, ManyFramesBeforeManyZeroBytesTakeNoLonger) {
    std::string text;
    for (int frame = 0; frame < 20'000; ++frame) text += "1\n\nO 0 0 0\n";
    FrameReader reader(folder_.write("a.xyz", text + std::string(std::size_t{3} << 20U, '\0')), {});
    EXPECT_EQ(reader.count(), 20'000);  // in minutes, were the zeros looked at for each
    EXPECT_EQ(reader.fault(), "");
    EXPECT_EQ(reader.read(19'999).scene.spheres.size(), 1U);
}

TEST_F(FrameReading, LinesBehindAnOnlyFrameAreNoDamage) {
    const std::string frame = "1\n\nO 0 0 0\n";
    const std::string lines = "1600.1 3650.2\nO O\nInChI=1S/H2O/h1H2\n";
    EXPECT_FALSE(is_damaged(frame + lines, 1));
    std::string many;
    for (int line = 0; line < 2000; ++line) many += "1600.1 3650.2\n";
    EXPECT_FALSE(is_damaged(frame + many, 1));
    EXPECT_TRUE(is_damaged(frame + many + frame, 1));
    EXPECT_TRUE(is_damaged(frame + lines + frame, 1));
    EXPECT_TRUE(is_damaged(frame + lines + std::string(std::size_t{5} << 20U, ' ') + "\n" + frame, 1));
}

TEST_F(FrameReading, OtherFilesAreReadWhole) {
    const std::string points = folder_.write("points.xyz", "0 0 0\n1 0 0\n2 0 0\n");
    FrameReader bare(points, {});
    EXPECT_EQ(bare.count(), 1);
    EXPECT_EQ(bare.read(0).scene.spheres.size(), 3U);

    const std::string models =
        folder_.write("a.pdb",
                      "MODEL        1\nATOM      1  N   ALA A   1       1.000   0.000   0.000  1.00  0.00           N\nENDMDL\n"
                      "MODEL        2\nATOM      1  N   ALA A   1       2.000   0.000   0.000  1.00  0.00           N\nENDMDL\n");
    FrameReader pdb(models, {});
    EXPECT_EQ(pdb.count(), 2);
    for (const std::int64_t frame : {1, 0, 0, 1}) {
        EXPECT_EQ(pdb.read(frame).scene.spheres.at(0).center.x, static_cast<double>(frame) + 1.0);
    }
    EXPECT_EQ(message_of<InputError>([&] { pdb.read(2); }), models + ": found 2 frames, 0 to 1, expected frame 2");

    FrameReader text(folder_.write("a.txt", "1\n255 0 0\n0 0 200\n20\n"), {});
    EXPECT_EQ(text.count(), 1);
    EXPECT_EQ(text.read(0).scene.spheres.size(), 1U);
}

}  // namespace sphereview
