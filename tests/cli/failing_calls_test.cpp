// Every system call of the program fails in turn, by strace: each ends in a documented status, with one line that says why, and
// leaves an output whole or as it was. Of commands that make many, every seventh, and every one with SPHEREVIEW_EVERY_FAILURE=on
// (./dev test --long).
#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "support/folders.hpp"
#include "support/gzip.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

namespace fs = std::filesystem;

// A system call, by its name and by how many of its name the thread makes until then.
struct Call {
    std::string name;
    int number;
    std::string line;  // of the trace
};

// What each call can fail with. EINTR is no failure: the call is made again.
std::vector<std::string> faults_of(const std::string& call) {
    static const std::map<std::string, std::vector<std::string>> faults = {
        {"brk", {"retval=0"}},  // how it says that memory ran out
        {"clone", {"error=EAGAIN"}},
        {"clone3", {"error=EAGAIN"}},
        {"close", {"error=EIO", "error=EINTR"}},
        {"fsync", {"error=EIO", "error=EINTR"}},
        {"getcwd", {"error=ENOMEM"}},
        {"mmap", {"error=ENOMEM"}},
        {"mprotect", {"error=ENOMEM"}},
        {"munmap", {"error=ENOMEM"}},
        {"newfstatat", {"error=EACCES", "error=ENOMEM"}},
        {"fstat", {"error=ENOMEM"}},
        {"openat", {"error=EMFILE", "error=EACCES", "error=EINTR"}},
        {"read", {"error=EIO", "error=EINTR"}},
        {"readlink", {"error=EACCES"}},
        {"rename", {"error=EACCES"}},
        {"write", {"error=ENOSPC", "error=EINTR"}},
    };
    // These cannot fail, or the C library itself waits in them and ends the process when they do.
    static const std::set<std::string> without = {"exit", "exit_group", "futex", "rt_sigreturn"};
    if (without.contains(call)) return {};
    const auto found = faults.find(call);
    return found == faults.end() ? std::vector<std::string>{"error=EIO"} : found->second;
}

// The calls of a trace since main() began, whose first act is to handle SIGINT. What comes before is the dynamic loader's, and so
// would be what has its number in another thread.
std::vector<Call> calls_of_main(const std::string& trace) {
    std::vector<Call> calls;
    std::map<std::pair<std::string, std::string>, int> counts;  // of each thread, as strace counts
    std::map<std::string, int> of_loader;
    std::set<std::pair<std::string, int>> known;
    bool in_main = false;
    for (const std::string& line : lines(trace)) {
        std::istringstream words(line);
        std::string thread;
        std::string name;
        if (!(words >> thread) || !std::getline(words >> std::ws, name, '(') || name.find(' ') != std::string::npos) continue;
        in_main = in_main || line.find("rt_sigaction(SIGINT") != std::string::npos;
        const int number = ++counts[{thread, name}];
        if (!in_main) of_loader[name] = number;
        if (number > of_loader[name] && known.emplace(name, number).second) calls.push_back({name, number, line});
    }
    return calls;
}

constexpr const char* frames =
    "1\nProperties=species:S:1:pos:R:3:charge:R:1\nO 0 0 0 1\n"
    "1\nProperties=species:S:1:pos:R:3:charge:R:1\nO 0 0 0 2\n";

class FailingCalls : public testing::Test {
protected:
    FailingCalls() {
        files_ = {{"red.txt", red_scene},
                  {"red.csv.gz", gzipped("x,y,z\n0,0,200\n")},
                  {"red.cif", "data_\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n0 0 0\n"},
                  {"blue.txt", blue_scene},
                  {"frames.xyz", frames},
                  {"linked.png", "old"}};
        reset();
        render(folder_, {"red.txt", "-s", "8x8", "-o", "golden.png"});
        render(folder_, {"frames.xyz", "--frames", "all", "-s", "8x8", "-o", "made-{frame}.png", "--manifest", "made.jsonl"});
        for (const char* name : {"golden.png", "made-0.png", "made-1.png", "made.jsonl"}) files_[name] = folder_.read(name);
        log_.write("bin/ffmpeg", "#!/bin/sh\nfor film; do :; done\nexec /bin/cat >\"$film\"\n");
        fs::permissions(log_.path("bin/ffmpeg"), fs::perms::owner_all);
    }

    // One core makes one thread, whose calls are the same in each run.
    void use_one_core() {
        cpu_set_t cores;
        ASSERT_EQ(sched_getaffinity(0, sizeof cores, &cores), 0);
        int first = 0;
        while (!CPU_ISSET(first, &cores)) ++first;
        CPU_ZERO(&cores);
        CPU_SET(first, &cores);
        ASSERT_EQ(sched_setaffinity(0, sizeof cores, &cores), 0);
    }

    // The program with these arguments, whose call fails; "": none.
    Outcome traced(const std::vector<std::string>& arguments, const std::string& input, const std::vector<std::string>& fault) {
        Command command;
        command.program = "/usr/bin/env";
        // Not what it starts in turn, which finds nothing in the folders of PATH but its own.
        command.arguments = {"strace", "-f", "-b", "execve", "-E", "PATH=" + log_.path("bin"), "-qq", "-o", log_.path("trace")};
        command.arguments.insert(command.arguments.end(), fault.begin(), fault.end());
        command.arguments.push_back(build_file("sphereview"));
        command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
        command.folder = folder_.path();
        command.input = input;
        return run(command);
    }

    // The folder as it is before each run: a link to a picture that only its owner may read, and no other output.
    void reset() {
        for (const std::string& name : folder_.names()) {
            if (!files_.contains(name)) fs::remove(folder_.path(name));
        }
        for (const auto& [name, bytes] : files_) folder_.write(name, bytes);
        fs::permissions(folder_.path("linked.png"), fs::perms::owner_read | fs::perms::owner_write);
        fs::create_symlink("linked.png", folder_.path("link.png"));
    }

    std::map<std::string, std::string> contents() const {
        std::map<std::string, std::string> all;
        for (const std::string& name : folder_.names()) {
            const bool link = fs::is_symlink(folder_.path(name));
            all[name] = link ? "link to " + fs::read_symlink(folder_.path(name)).string() : folder_.read(name);
        }
        return all;
    }

    // Where that is so, the test is skipped.
    void expect_that_programs_can_be_traced() {
        const Outcome outcome = traced({"--version"}, "", {});
        if (outcome.status == 0) return;
        const std::string why = "no program can be traced here: " + outcome.errors;
        if (std::getenv("CI") != nullptr) FAIL() << why;
        GTEST_SKIP() << why;
    }

    // As expect_good_ends(), of every seventh failure.
    void expect_good_ends_of_some(const std::vector<std::string>& arguments, std::size_t most_lines = 1,
                                  const std::string& spared = "") {
        step_ = std::getenv("SPHEREVIEW_EVERY_FAILURE") == nullptr ? 7 : 1;
        expect_good_ends(arguments, 0, "", most_lines, spared);
    }

    // `most_lines`: in which a failure is told. `spared`: a call that does not fail.
    void expect_good_ends(const std::vector<std::string>& arguments, int usual_status = 0, const std::string& input = "",
                          std::size_t most_lines = 1, const std::string& spared = "") {
        expect_that_programs_can_be_traced();
        if (HasFailure() || IsSkipped()) return;
        reset();
        const auto before = contents();
        const Outcome usual = traced(arguments, input, {});
        ASSERT_EQ(usual.status, usual_status) << usual;
        const auto after = contents();
        const std::vector<Call> calls = calls_of_main(log_.read("trace"));
        ASSERT_GT(calls.size(), 10U);
        int failures = 0;
        for (const Call& call : calls) {
            if (call.name == spared) continue;
            for (const std::string& fault : faults_of(call.name)) {
                if (failures++ % step_ != 0) continue;
                reset();
                const std::string injected = "inject=" + call.name + ":" + fault + ":when=" + std::to_string(call.number);
                const Outcome outcome = traced(arguments, input, {"-e", "trace=" + call.name, "-e", injected});
                SCOPED_TRACE(injected + ", as in " + call.line);
                expect_good_end(outcome, usual, fault == "error=EINTR");
                // A failure says so in one line, or of several pictures in two; unless that is what cannot be written.
                if (outcome.status != usual.status && call.line.find("write(2,") == std::string::npos) {
                    const std::size_t said = lines(outcome.errors).size();
                    EXPECT_GE(said, 1U) << outcome;
                    EXPECT_LE(said, usual_status == 0 ? lines(usual.errors).size() + most_lines : 1) << outcome;
                }
                // Each file is as it was or as it should be, and nothing else is there.
                for (const auto& [name, bytes] : contents()) {
                    EXPECT_TRUE(
                        (before.contains(name) && before.at(name) == bytes) ||
                        (after.contains(name) && (after.at(name) == bytes || is_part_of_manifest(name, bytes, after.at(name)))))
                        << name << " has other bytes; " << outcome;
                }
                for (const auto& [name, bytes] : before)
                    EXPECT_TRUE(fs::exists(folder_.path(name))) << name << " is lost; " << outcome;
                if (outcome.status == 0) {
                    EXPECT_EQ(contents(), after);
                }
                EXPECT_EQ(fs::status(folder_.path("linked.png")).permissions() & (fs::perms::group_all | fs::perms::others_all),
                          fs::perms::none);
                if (HasFailure()) return;  // one is enough to mend
            }
        }
    }

    TemporaryFolder folder_;

private:
    // Whole lines of it, without those of pictures that failed.
    static bool is_part_of_manifest(const std::string& name, const std::string& bytes, const std::string& whole) {
        const std::vector<std::string> all = lines(whole);
        return name.ends_with(".jsonl") && (bytes.empty() || bytes.ends_with('\n')) &&
               std::ranges::all_of(lines(bytes), [&](const std::string& line) { return std::ranges::count(all, line) == 1; });
    }

    static void expect_good_end(const Outcome& outcome, const Outcome& usual, bool interrupted) {
        const std::set<int> documented = {usual.status, 2, 3, 4};
        EXPECT_TRUE(documented.contains(outcome.status)) << outcome;
        if (interrupted || outcome.status == 0) {
            EXPECT_EQ(outcome.status, usual.status) << outcome;
            EXPECT_EQ(outcome.output, usual.output);
        }
    }

    std::map<std::string, std::string> files_;
    TemporaryFolder log_;
    int step_ = 1;
};

TEST_F(FailingCalls, OfRenderLeaveTheOldPictureOrTheNew) {
    use_one_core();
    expect_good_ends({"render", "red.txt", "--backend", "cpu", "-s", "8x8", "-o", "link.png"});
}

// Some file systems refuse to set a mode: then the picture has the old one anyway, or is not written.
TEST_F(FailingCalls, OfTheModeKeepItOrLeaveTheOldPicture) {
    expect_that_programs_can_be_traced();
    if (HasFailure() || IsSkipped()) return;
    const std::vector<std::string> render = {"render", "red.txt", "--backend", "cpu", "-s", "8x8", "-o", "linked.png"};
    const std::vector<std::string> fault = {"-e", "trace=fchmodat", "-e", "inject=fchmodat:error=EPERM"};
    for (const auto& [mode, status] : {std::pair{fs::perms{0600}, 0}, {fs::perms{0666}, 4}}) {  // the second is beyond the umask
        reset();
        fs::permissions(folder_.path("linked.png"), mode);
        const Outcome outcome = traced(render, "", fault);
        EXPECT_EQ(outcome.status, status) << outcome;
        EXPECT_EQ(folder_.read("linked.png") == "old", status != 0);
        EXPECT_EQ(fs::status(folder_.path("linked.png")).permissions(), mode);
    }
}

TEST_F(FailingCalls, OfRenderThroughPipes) {
    use_one_core();
    expect_good_ends({"render", "-", "--backend", "cpu", "-s", "8x8", "-o", "-"}, 0, red_scene);
}

TEST_F(FailingCalls, OfAComparison) {
    use_one_core();
    expect_good_ends({"render", "red.txt", "--backend", "cpu", "-s", "8x8", "--expect", "golden.png", "--diff", "diff.png"});
}

// Neither picture may become the other without a word.
TEST_F(FailingCalls, OfTwoScenesOfOneName) {
    use_one_core();
    expect_good_ends({"render", "red.txt", "red.csv.gz", "--backend", "cpu", "-s", "8x8", "-o", "{name}.png"}, 2);
}

TEST_F(FailingCalls, OfRenderWithThreads) {
    expect_good_ends({"render", "red.txt", "--backend", "cpu", "-s", "256x256", "-o", "out.png"});
}

TEST_F(FailingCalls, OfConvert) {
    use_one_core();
    expect_good_ends({"convert", "red.csv.gz", "out.toml"});
}

#ifndef WITHOUT_GEMMI
TEST_F(FailingCalls, OfConvertOfAMolecule) {
    use_one_core();
    expect_good_ends({"convert", "red.cif", "out.toml"});
}
#endif

TEST_F(FailingCalls, OfFramesLeaveWholePicturesAndLines) {
    use_one_core();
    expect_good_ends_of_some({"render", "frames.xyz", "--frames", "all", "--backend", "cpu", "-s", "8x8", "-o", "{frame}.png",
                              "--manifest", "new.jsonl"},
                             2);
}

// A close that fails, by strace, closes nothing: the encoder would wait for more.
TEST_F(FailingCalls, OfAFilmLeaveNothingOrAll) {
    use_one_core();
    expect_good_ends_of_some({"render", "frames.xyz", "--frames", "all", "--backend", "cpu", "-s", "8x8", "--movie", "new.mp4"}, 2,
                             "close");
}

TEST_F(FailingCalls, OfALegend) {
    use_one_core();
    expect_good_ends_of_some(
        {"render", "frames.xyz", "--backend", "cpu", "-s", "200x200", "--color-by", "charge", "--legend", "-o", "out.png"});
}

TEST_F(FailingCalls, OfVerify) {
    use_one_core();
    expect_good_ends_of_some({"verify", "made.jsonl", "--backend", "cpu"}, 2);
}

TEST_F(FailingCalls, OfCompare) {
    use_one_core();
    expect_good_ends({"compare", "golden.png", "blue.txt"}, 1);
}

TEST_F(FailingCalls, OfExplain) {
    use_one_core();
    expect_good_ends({"explain", "red.txt", "--pixel", "500,500"});
}

}  // namespace
}  // namespace sphereview::test
