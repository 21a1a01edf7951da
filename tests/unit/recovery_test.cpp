#include "viewer/recovery.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <functional>
#include <random>
#include <thread>

#include "base/input_file.hpp"
#include "formats/scene_format.hpp"
#include "support/environment.hpp"
#include "support/temporary_folder.hpp"
#include "unit/random_scene.hpp"
#include "unit/scene_difference.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

struct RecoveryTest : testing::Test {
    test::TemporaryFolder folder;
    test::Variable state{"XDG_STATE_HOME", folder.path("state")};
};

// Another process that does something and then runs on until it is killed.
class Other {
public:
    explicit Other(const std::function<bool()>& action) {
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0) ADD_FAILURE() << "no pipe";
        child_ = fork();
        if (child_ == 0) {
            const char done = action() ? 'y' : 'n';
            [[maybe_unused]] const auto written = write(ends[1], &done, 1);
            while (true) pause();
        }
        char done = 0;
        EXPECT_EQ(read(ends[0], &done, 1), 1);
        EXPECT_EQ(done, 'y');
        close(ends[0]);
        close(ends[1]);
    }
    ~Other() { end(); }
    Other(const Other&) = delete;
    Other& operator=(const Other&) = delete;

    void end() {
        if (child_ <= 0) return;
        kill(child_, SIGKILL);
        waitpid(child_, nullptr, 0);
        child_ = 0;
    }

private:
    pid_t child_ = 0;
};

Scene scene_of(unsigned seed) {
    std::mt19937_64 random(seed);
    return random_scene(random);
}

Scene scene_in(const Recovery& recovery) { return parse_scene(InputFile(recovery.file).bytes(), recovery.file); }

}  // namespace

TEST_F(RecoveryTest, GivesEveryBitBack) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        const Scene scene = scene_of(seed);
        Other other([&] { return write_recovery(scene, "/scenes/a b.toml"); });
        other.end();
        const auto recoveries = list_recoveries();
        ASSERT_EQ(recoveries.size(), 1U) << seed;
        EXPECT_EQ(recoveries[0].original, "/scenes/a b.toml");
        ASSERT_EQ(difference(scene_in(recoveries[0]), scene), "") << "seed " << seed;
        EXPECT_TRUE(remove_recovery(recoveries[0].file));
        EXPECT_TRUE(list_recoveries().empty());
    }
}

TEST_F(RecoveryTest, KnowsWhatWasEdited) {
    const std::string odd = "/K\xC3\xBCgeln/\xFF\n\r\t %41'\"#.toml";
    for (const std::string& original : {std::string(), odd, std::string("relative.txt")}) {
        Other other([&] { return write_recovery({}, original); });
        other.end();
        const auto recoveries = list_recoveries();
        ASSERT_EQ(recoveries.size(), 1U);
        EXPECT_EQ(recoveries[0].original, original == "relative.txt" ? (fs::current_path() / original).string() : original);
        EXPECT_EQ(difference(scene_in(recoveries[0]), Scene{}), "");
        const auto age = std::chrono::system_clock::now() - recoveries[0].time;
        EXPECT_LT(age, std::chrono::hours(1));
        EXPECT_GT(age, std::chrono::hours(-1));
        remove_recovery(recoveries[0].file);
    }
}

TEST_F(RecoveryTest, LeavesARunningProcessItsOwn) {
    Other first([] { return write_recovery(scene_of(2), "/first"); });
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // the order is by time, in milliseconds
    Other second([] { return write_recovery(scene_of(3), "/not yet") && write_recovery(scene_of(4), "/second"); });
    EXPECT_TRUE(write_recovery(scene_of(1), "/own"));  // last: a copy of this process would share its lock
    EXPECT_TRUE(list_recoveries().empty());
    second.end();
    ASSERT_EQ(list_recoveries().size(), 1U);
    first.end();
    const auto recoveries = list_recoveries();
    ASSERT_EQ(recoveries.size(), 2U);
    EXPECT_EQ(recoveries[0].original, "/second");
    EXPECT_EQ(difference(scene_in(recoveries[0]), scene_of(4)), "");
    EXPECT_EQ(recoveries[1].original, "/first");
    EXPECT_EQ(difference(scene_in(recoveries[1]), scene_of(2)), "");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"state"});
    EXPECT_TRUE(remove_own_recovery());
    EXPECT_TRUE(remove_own_recovery()) << "it is gone";
    EXPECT_EQ(list_recoveries().size(), 2U);
}

TEST_F(RecoveryTest, SaysWhenNothingCanBeKept) {
    folder.write("state", "a file, not a folder");
    EXPECT_FALSE(write_recovery(scene_of(1), "/a"));
    EXPECT_TRUE(list_recoveries().empty());
    EXPECT_EQ(folder.read("state"), "a file, not a folder");
    const test::Variable none("XDG_STATE_HOME", {});
    const test::Variable home("HOME", {});
    EXPECT_FALSE(write_recovery(scene_of(1), "/a"));
    EXPECT_TRUE(list_recoveries().empty());
    EXPECT_TRUE(remove_own_recovery());
}

TEST_F(RecoveryTest, PassesOverWhatIsNoRecovery) {
    folder.write("state/sphereview/recovery-1x.toml", "# another comment\n");
    folder.write("state/sphereview/recovery-2147483646-7.toml", "");
    folder.write("state/sphereview/recovery-.toml", "# sphereview recovery, milliseconds since 1970: x\n# of: /a\n");
    folder.write("state/sphereview/recovery.toml", "");
    folder.write("state/sphereview/other", "");
    fs::create_directories(folder.path("state/sphereview/recovery-2147483646-8.toml"));
    EXPECT_TRUE(list_recoveries().empty());
    EXPECT_FALSE(remove_recovery(folder.path("state/sphereview"))) << "a folder with files in it";
}

}  // namespace sphereview
