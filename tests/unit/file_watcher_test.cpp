#include "base/file_watcher.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "support/eventually.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

using Paths = std::set<std::string>;

// A watcher, and all that it has told.
class Watch {
public:
    explicit Watch(FileWatcher::Method method) : watcher([this] { ++calls; }, method) {}

    bool tells_of(const std::string& path) {
        return test::eventually([&] {
            collect();
            return told.contains(path);
        });
    }
    void collect() {
        for (const std::string& path : watcher.take_changed()) told.insert(path);
    }
    // After what was told so far.
    void forget() {
        collect();
        told.clear();
    }

    std::atomic<int> calls = 0;
    Paths told;
    FileWatcher watcher;  // last: its thread uses the others
};

class FileWatcherTest : public testing::TestWithParam<FileWatcher::Method> {
protected:
    test::TemporaryFolder folder;
    Watch watch{GetParam()};
};

}  // namespace

TEST_P(FileWatcherTest, TellsOfAFileThatIsWrittenInPlace) {
    const std::string file = folder.write("a", "old");
    watch.watcher.watch({file});
    folder.write("a", "new content");
    EXPECT_TRUE(watch.tells_of(file));
    EXPECT_GE(watch.calls, 1);
}

TEST_P(FileWatcherTest, TellsAgainAndAgain) {
    const std::string file = folder.write("a", "old");
    watch.watcher.watch({file});
    for (int i = 0; i < 3; ++i) {
        watch.forget();
        folder.write("a", std::string(static_cast<std::size_t>(10 + i), 'x'));
        ASSERT_TRUE(watch.tells_of(file)) << i;
    }
}

TEST_P(FileWatcherTest, FollowsANameThroughRenames) {
    const std::string file = folder.write("a", "old");
    watch.watcher.watch({file});
    for (int i = 0; i < 2; ++i) {
        watch.forget();
        folder.write("beside", "new" + std::to_string(i));
        fs::rename(folder.path("beside"), file);
        ASSERT_TRUE(watch.tells_of(file)) << i;
    }
}

TEST_P(FileWatcherTest, FollowsANameThroughDeletion) {
    const std::string file = folder.write("a", "old");
    watch.watcher.watch({file});
    fs::remove(file);
    folder.write("a", "written again");
    EXPECT_TRUE(watch.tells_of(file));
}

TEST_P(FileWatcherTest, TellsOfAFileThatComesUp) {
    const std::string file = folder.path("a");
    const std::string far = folder.path("not/yet/here");
    watch.watcher.watch({file, far});
    folder.write("a", "new");
    EXPECT_TRUE(watch.tells_of(file));
    folder.write("not/yet/here", "new");
    EXPECT_TRUE(watch.tells_of(far));
}

TEST_P(FileWatcherTest, TellsOfAFileThatStaysOpen) {
    const std::string file = folder.write("a", "old");
    watch.watcher.watch({file});
    std::ofstream open(file, std::ios::binary | std::ios::app);
    open << "more" << std::flush;
    EXPECT_TRUE(watch.tells_of(file));
}

TEST_P(FileWatcherTest, FollowsSymbolicLinks) {
    fs::create_directories(folder.path("far/v1"));
    fs::create_directories(folder.path("far/v2"));
    folder.write("far/v1/real", "old");
    folder.write("far/v2/real", "another");
    fs::create_symlink("v1", folder.path("far/current"));
    fs::create_symlink("far/current/real", folder.path("link"));
    const std::string link = folder.path("link");
    watch.watcher.watch({link});

    folder.write("far/v1/real", "written where the link leads");
    EXPECT_TRUE(watch.tells_of(link));
    watch.forget();
    fs::create_symlink("v2", folder.path("far/next"));
    fs::rename(folder.path("far/next"), folder.path("far/current"));
    EXPECT_TRUE(watch.tells_of(link)) << "a folder on the way was replaced";
    watch.forget();
    folder.write("far/v2/real", "written where it leads now");
    EXPECT_TRUE(watch.tells_of(link));
    watch.forget();
    folder.write("other", "not far");
    fs::remove(link);
    fs::create_symlink("other", link);
    EXPECT_TRUE(watch.tells_of(link)) << "the link was replaced";
}

TEST_P(FileWatcherTest, SurvivesALoopOfLinks) {
    fs::create_symlink("b", folder.path("a"));
    fs::create_symlink("a", folder.path("b"));
    const std::string file = folder.path("a");
    watch.watcher.watch({file});
    fs::remove(folder.path("b"));
    folder.write("b", "an end");
    EXPECT_TRUE(watch.tells_of(file));
}

TEST_P(FileWatcherTest, TakesAFolderForAllFilesInIt) {
    folder.write("shaders/a", "old");
    folder.write("elsewhere", "old");
    const std::string shaders = folder.path("shaders");
    fs::create_symlink(folder.path("elsewhere"), folder.path("shaders/linked"));
    watch.watcher.watch({shaders});
    folder.write("shaders/a", "new content");
    EXPECT_TRUE(watch.tells_of(shaders));
    watch.forget();
    folder.write("shaders/b", "another");
    EXPECT_TRUE(watch.tells_of(shaders));
    watch.forget();
    folder.write("elsewhere", "new content");
    EXPECT_TRUE(watch.tells_of(shaders));
}

TEST_P(FileWatcherTest, FindsAFolderThatWasReplaced) {
    const std::string file = folder.write("sub/a", "old");
    watch.watcher.watch({file});
    fs::rename(folder.path("sub"), folder.path("gone"));
    folder.write("sub/a", "in a new folder");
    EXPECT_TRUE(watch.tells_of(file));
    watch.forget();
    folder.write("sub/a", "and written there");
    EXPECT_TRUE(watch.tells_of(file));
}

TEST_P(FileWatcherTest, TellsOfNothingElse) {
    const std::string file = folder.write("a", "old");
    const std::string before = folder.write("before", "old");
    const std::string last = folder.write("last", "old");
    watch.watcher.watch({before});
    watch.watcher.watch({file, last});
    folder.write("b", "not watched");
    folder.write("before", "not watched any more");
    fs::remove(file);
    std::ifstream(last).get();
    folder.write("last", "the one");
    EXPECT_TRUE(watch.tells_of(last));
    watch.collect();
    EXPECT_EQ(watch.told, Paths{last});
}

TEST_P(FileWatcherTest, KeepsWatchingWhatStaysOnTheList) {
    const std::string file = folder.write("a", "old");
    const std::string other = folder.write("b", "old");
    watch.watcher.watch({file});
    folder.write("a", "new content");
    watch.watcher.watch({file, other});
    EXPECT_TRUE(watch.tells_of(file)) << "it changed before the list did";
}

TEST_P(FileWatcherTest, EndsAtOnce) {
    const std::string file = folder.write("a", "old");
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < 20; ++i) {
        FileWatcher watcher([] {}, GetParam());
        watcher.watch({file});
    }
    // Each that waits for its next look would take half a second.
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(8));
}

INSTANTIATE_TEST_SUITE_P(Methods, FileWatcherTest, testing::Values(FileWatcher::Method::system, FileWatcher::Method::looking),
                         [](const auto& instance) { return instance.param == FileWatcher::Method::system ? "System" : "Looking"; });

#ifdef __linux__

namespace {

Paths threads() {
    Paths threads;
    for (const auto& entry : fs::directory_iterator("/proc/self/task")) threads.insert(entry.path().string());
    return threads;
}

// How often a thread has gone to sleep.
std::string sleeps(const std::string& thread) {
    std::ifstream file(thread + "/status");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("voluntary_ctxt_switches")) return line;
    }
    return "";
}

// Whether a second comes in which the watcher's thread never wakes.
bool sleeps_for_a_second(FileWatcher::Method method, std::chrono::seconds limit) {
    const test::TemporaryFolder folder;
    const Paths before = threads();
    Watch watch(method);
    std::string thread;
    for (const std::string& now : threads()) {
        if (!before.contains(now)) thread = now;
    }
    watch.watcher.watch({folder.write("a", "old")});
    folder.write("a", "new content");
    EXPECT_TRUE(watch.tells_of(folder.path("a")));
    return test::eventually(
        [&] {
            const std::string count = sleeps(thread);
            std::this_thread::sleep_for(std::chrono::milliseconds(1100));
            return !count.empty() && sleeps(thread) == count;
        },
        limit);
}

}  // namespace

TEST(FileWatcherRest, IsCompleteWhereTheSystemTells) {
    EXPECT_TRUE(sleeps_for_a_second(FileWatcher::Method::system, std::chrono::seconds(30)));
    EXPECT_FALSE(sleeps_for_a_second(FileWatcher::Method::looking, std::chrono::seconds(3))) << "this test cannot fail";
}

#endif

}  // namespace sphereview
