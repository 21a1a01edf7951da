// Allocations of the program fail in turn, alone or with all that follow: every 13th of a command's own, and some of those by which
// the command line is declared, which are the same for all commands. With SPHEREVIEW_EVERY_FAILURE=on (./dev test --long): every
// single one, both alone and with all that follow.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "support/gzip.hpp"
#include "support/render.hpp"

namespace sphereview::test {
namespace {

// More than any of these commands makes: about 6,500, most of them for the declarations, which verify makes twice.
constexpr int last = 12'000;

class FailingMalloc : public testing::Test {
protected:
    FailingMalloc() {
        folder_.write("red.txt", red_scene);
        folder_.write("red.toml", "[[sphere]]\nname = 'red'\ncolor = [250, 0, 0]\ncenter = [0, 0, 200]\nradius = 20\n");
        folder_.write("red.csv.gz", gzipped("x,y,z,name\n0,0,200,\"a \"\"red\"\" sphere, with a long name\"\n"));
        folder_.write("red.cif", "data_\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n0 0 0\n");
        folder_.write("bad.txt", "1\n255\n");
        folder_.write("blue.txt", blue_scene);
        folder_.write("charges.csv", "x,y,z,charge\n0,0,0,1\n5,0,0,2\n");
        folder_.write("frames.xyz", "1\n\nO 0 0 0\n1\n\nN 0 0 0\n");
        folder_.write("bin/ffmpeg", "#!/bin/sh\nfor film; do :; done\nexec /bin/cat >\"$film\"\n");
        std::filesystem::permissions(folder_.path("bin/ffmpeg"), std::filesystem::perms::owner_all);
        render(folder_, {"red.txt", "-s", "8x8", "-o", "golden.png"});
        render(folder_, {"frames.xyz", "--frames", "all", "-s", "8x8", "-o", "{frame}.png", "--manifest", "made.jsonl"});
    }

    // Whether it fails alone or with all that follow, the program ends with a documented status and has a line to say why.
    void expect_good_ends(const std::vector<std::string>& arguments, int usual_status = 0, int step_of_declarations = 131) {
        const bool every = std::getenv("SPHEREVIEW_EVERY_FAILURE") != nullptr;
        const int declarations = every ? 0 : allocations_of({"render", "--nonsense"}, 2);
        const int all = every ? last : allocations_of(arguments, usual_status) + 50;  // not always as many
        int told = 0;
        for (int number = 1; number <= all; number += every ? 1 : number < declarations ? step_of_declarations : 13) {
            for (const bool on : {false, true}) {
                if (!every && on != (number % 2 == 0)) continue;
                const Outcome outcome = without(number, on, arguments);
                const bool good = outcome.status == usual_status || outcome.status == 3 || outcome.status == 4;
                ASSERT_TRUE(good && outcome.signal == 0) << number << (on ? " and on: " : ": ") << outcome;
                EXPECT_EQ(outcome.status == 3, outcome.errors.find("memory ran out") != std::string::npos)
                    << number << ": " << outcome;
                if (outcome.status == 3) ++told;
                for (const std::string& name : folder_.names()) {
                    ASSERT_FALSE(name.starts_with(".")) << number << (on ? " and on: " : ": ") << name << " is left; " << outcome;
                }
            }
        }
        EXPECT_GT(told, every ? 1'000 : 1'000 / step_of_declarations);   // else none failed
        EXPECT_EQ(without(last, true, arguments).status, usual_status);  // else there are more
    }

    // About how many the program makes.
    int allocations_of(const std::vector<std::string>& arguments, int usual_status) const {
        int fewest = 0;
        int most = last;
        while (most - fewest > 8) {
            const int middle = (fewest + most) / 2;
            (without(middle, true, arguments).status == usual_status ? most : fewest) = middle;
        }
        return most;
    }

    // The allocation of this number fails, and all that follow.
    Outcome without(int number, bool on, const std::vector<std::string>& arguments) const {
        Command command;
        command.folder = folder_.path();
        command.arguments = arguments;
        command.environment = {{"LD_PRELOAD", FAILING_MALLOC},
                               {"PATH", folder_.path("bin")},
                               {"FAILING_ALLOCATION", std::to_string(number)},
                               {on ? "FAILING_ALLOCATIONS" : "NOTHING", "on"}};
        return run(command);
    }

    TemporaryFolder folder_;
};

TEST_F(FailingMalloc, OfRenderIsTold) {
    expect_good_ends({"render", "red.txt", "--backend", "cpu", "-s", "8x8", "-o", "out.png", "--json", "--samples", "4"});
    expect_good_ends({"render", "red.txt", "--backend", "cpu", "-s", "8x8", "--expect", "golden.png", "--diff", "diff.png"});
    expect_good_ends({"render", "bad.txt", "--backend", "cpu"}, 2);
}

TEST_F(FailingMalloc, OfConvertIsTold) {
    expect_good_ends({"convert", "red.toml", "out.txt"});
    expect_good_ends({"convert", "red.csv.gz", "out.toml"});
#ifndef WITHOUT_GEMMI
    expect_good_ends({"convert", "red.cif", "out.toml"});
#endif
}

TEST_F(FailingMalloc, OfFramesIsTold) {
    expect_good_ends({"render", "frames.xyz", "--frames", "all", "--backend", "cpu", "-s", "8x8", "-o", "{frame}.png", "--manifest",
                      "new.jsonl"});
    expect_good_ends({"verify", "made.jsonl", "--backend", "cpu"});
}

TEST_F(FailingMalloc, OfAFilmIsTold) {
    expect_good_ends({"render", "frames.xyz", "--frames", "all", "--backend", "cpu", "-s", "8x8", "--movie", "new.mp4"});
}

TEST_F(FailingMalloc, OfALegendIsTold) {
    expect_good_ends({"render", "charges.csv", "--backend", "cpu", "-s", "200x200", "--color-by", "charge", "--legend", "--axes",
                      "--scale-bar", "-o", "out.png"});
}

TEST_F(FailingMalloc, OfCompareIsTold) { expect_good_ends({"compare", "golden.png", "blue.txt"}, 1); }

TEST_F(FailingMalloc, OfExplainIsTold) { expect_good_ends({"explain", "red.toml", "--pixel", "500,500", "--json"}); }

TEST_F(FailingMalloc, OfAWrongUseIsTold) { expect_good_ends({"render", "--nonsense"}, 2, 17); }

}  // namespace
}  // namespace sphereview::test
