// The times that files have of their frames.
#include "formats/frame_time.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "formats/frame_reader.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

namespace {

class FrameTimes : public testing::Test {
protected:
    // As "0.50 ps" of each frame, read one after the other and from the last one on; "-" where there is none.
    std::vector<std::string> times_of(const std::string& name, const std::string& text) {
        FrameReader reader(folder_.write(name, text), {});
        const std::int64_t count = reader.count();
        std::vector<std::string> times;
        for (std::int64_t frame = 0; frame < count; ++frame) times.push_back(words(reader.read(frame)));
        for (std::int64_t frame = count; frame-- > 0;) {
            EXPECT_EQ(words(reader.read(frame)), times[static_cast<std::size_t>(frame)]) << name << ", " << frame;
            FrameReader other(folder_.path(name), {});
            EXPECT_EQ(words(other.read(frame)), times[static_cast<std::size_t>(frame)]) << name << ", " << frame;
        }
        return times;
    }

    static std::string words(const SphereData& data) { return data.time ? data.time->text + " " + data.time->unit : "-"; }

    test::TemporaryFolder folder_;
};

std::string pdb_atom(int x) {
    return "ATOM      1  N   ALA A   1       " + std::to_string(x) + ".000   0.000   0.000  1.00  0.00           N\n";
}

}  // namespace

TEST_F(FrameTimes, OfXyzAreInItsComment) {
    const std::string atom = "\nO 0 0 0\n";
    EXPECT_EQ(
        times_of("a.xyz", "1\nTime=0.50 Properties=species:S:1:pos:R:3" + atom + "1\n i =  3, time =        1.500, E = -17.1" +
                              atom + "1\ntime=\"2e3\" energy=1" + atom + "1\ndowntime=3 Time=soon" + atom + "1\nno time" + atom),
        (std::vector<std::string>{"0.50 ", "1.500 ", "2e3 ", "-", "-"}));
    EXPECT_EQ(times_of("b.xyz", "1\nTime=0.1000000000000000055511151231257827" + atom), std::vector<std::string>{"0.1 "});
    EXPECT_EQ(times_of("c.xyz", "1\nTime=nan" + atom), std::vector<std::string>{"-"});
}

TEST_F(FrameTimes, OfGromacsAreInTheTitle) {
    const std::string rest = "\n1\n    1SOL     OW    1   0.100   0.000   0.000\n   1.0 1.0 1.0\n";
    EXPECT_EQ(times_of("a.gro", "Water t=   0.00000 step= 0" + rest + "at= 3 t= 1.5" + rest + "t= 2 t=3.50 step= 7" + rest +
                                    "t=" + rest + "Water" + rest),
              (std::vector<std::string>{"0.00000 ps", "1.5 ps", "3.50 ps", "-", "-"}));
}

TEST_F(FrameTimes, OfLammpsAreItsOwnOrItsSteps) {
    const auto frame = [](const std::string& items) {
        return items + "ITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS id type x y z\n1 1 0 0 0\n";
    };
    EXPECT_EQ(times_of("a.lammpstrj", frame("ITEM: TIMESTEP\n100\n") + frame("ITEM: TIMESTEP\n200\n")),
              (std::vector<std::string>{"100 steps", "200 steps"}));
    // The units stand above the first frame alone.
    EXPECT_EQ(times_of("b.lammpstrj", frame("ITEM: UNITS\nmetal\nITEM: TIME\n0.5\nITEM: TIMESTEP\n100\n") +
                                          frame("ITEM: TIMESTEP\n200\nITEM: TIME\n1\n") + frame("ITEM: TIMESTEP\n300\n")),
              (std::vector<std::string>{"0.5 ps", "1 ps", "300 steps"}));
    EXPECT_EQ(times_of("c.lammpstrj", frame("ITEM: UNITS\nlj\nITEM: TIME\n0.5\n")), std::vector<std::string>{"0.5 "});
    EXPECT_EQ(times_of("d.lammpstrj", frame("ITEM: TIME\n0.5\n")), std::vector<std::string>{"0.5 "});
    EXPECT_EQ(times_of("e.lammpstrj", frame("")), std::vector<std::string>{"-"});
}

TEST_F(FrameTimes, OfPdbAreInTheTitleAboveTheModel) {
    const auto model = [](const std::string& title, int number) {
        return title + "CRYST1\nMODEL        " + std::to_string(number) + "\n" + pdb_atom(number) + "TER\nENDMDL\n";
    };
    EXPECT_EQ(times_of("a.pdb", model("TITLE     Water t=   0.00000 step= 0\nREMARK    A BOX\n", 1) +
                                    model("TITLE     Water t=  10.00000 step= 5\n", 2) + model("", 3) +
                                    model("TITLE     t= 3\nTITLE     t= 4\n", 4)),
              (std::vector<std::string>{"0.00000 ps", "10.00000 ps", "-", "4 ps"}));
}

// What a frame that is read behind another one is looked for from.
TEST_F(FrameTimes, OfPdbWhoseFramesEndWithEnd) {
    const std::string text = "TITLE     t= 1\n" + pdb_atom(1) + "END\nTITLE     t= 2\n" + pdb_atom(2) + "END\n" + pdb_atom(3) +
                             "END\n" + pdb_atom(4) + "END\n";
    EXPECT_EQ(times_of("a.pdb", text), (std::vector<std::string>{"1 ps", "2 ps", "-", "-"}));
    FrameReader reader(folder_.path("a.pdb"), {});
    for (std::int64_t frame = 0; frame < 4; ++frame) {
        EXPECT_EQ(reader.read(frame).scene.spheres.at(0).center.x, static_cast<double>(frame + 1));
    }
    EXPECT_EQ(reader.count(), 4);
}

TEST_F(FrameTimes, OthersHaveNone) {
    EXPECT_EQ(
        times_of("XDATCAR", "a\n1\n9 0 0\n0 9 0\n0 0 9\nO\n1\nDirect configuration= 1\n0 0 0\nDirect configuration= 2\n0 0 0\n"),
        (std::vector<std::string>{"-", "-"}));
}

}  // namespace sphereview
