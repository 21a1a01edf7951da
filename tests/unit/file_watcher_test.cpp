#include "base/file_watcher.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <fstream>

#include "support/eventually.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

using Paths = std::vector<std::string>;

class FileWatcherTest : public testing::Test {
protected:
    // The next look, a second later.
    Paths look() { return watcher.look(now += std::chrono::seconds(1)); }

    // What two looks find, of which the first sees the change and the second that it is over.
    Paths news() {
        EXPECT_EQ(look(), Paths());
        Paths told = look();
        EXPECT_EQ(look(), Paths()) << "told twice";
        return told;
    }

    test::TemporaryFolder folder;
    FileWatcher watcher{std::chrono::minutes(1)};
    FileWatcher::Time now;
};

TEST_F(FileWatcherTest, TellsAgainAndAgainOfAFileThatIsWrittenInPlace) {
    const std::string file = folder.write("a", "old");
    watcher.watch({file});
    EXPECT_EQ(news(), Paths());
    for (std::size_t i = 0; i < 3; ++i) {
        folder.write("a", std::string(10 + i, 'x'));
        EXPECT_EQ(news(), Paths{file});
    }
    // By its time alone.
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::milliseconds(1));
    EXPECT_EQ(news(), Paths{file});
}

TEST_F(FileWatcherTest, WaitsUntilAFileIsLeftAlone) {
    const std::string file = folder.write("a", "old");
    watcher.watch({file});
    std::ofstream open(file, std::ios::binary | std::ios::app);
    for (int i = 0; i < 5; ++i) {
        open << "more" << std::flush;
        EXPECT_EQ(look(), Paths());
    }
    EXPECT_EQ(look(), Paths{file});
}

TEST_F(FileWatcherTest, LooksAFewTimesASecond) {
    EXPECT_EQ(watcher.next_look(), std::nullopt) << "there is nothing to watch";
    const std::string file = folder.write("a", "old");
    watcher.watch({file, ""});
    now += std::chrono::hours(1);
    EXPECT_EQ(watcher.look(now), Paths());
    EXPECT_EQ(watcher.next_look(), now + std::chrono::milliseconds(250));
    folder.write("a", "new content");
    for (int i = 0; i < 4; ++i) EXPECT_EQ(watcher.look(now += std::chrono::milliseconds(100)), Paths());
    EXPECT_EQ(watcher.look(now += std::chrono::milliseconds(100)), Paths());  // 200 ms after the look that saw it
    EXPECT_EQ(watcher.look(now += std::chrono::milliseconds(100)), Paths{file});
}

TEST_F(FileWatcherTest, FollowsANameThroughRenamesAndDeletion) {
    const std::string file = folder.write("a", "old");
    watcher.watch({file});
    for (const char* content : {"newer", "newest"}) {  // of other sizes: times may be the same
        folder.write("beside", content);
        fs::rename(folder.path("beside"), file);
        EXPECT_EQ(news(), Paths{file});
    }
    fs::remove(file);
    EXPECT_EQ(news(), Paths{file}) << "it is gone";
    folder.write("a", "written again");
    EXPECT_EQ(news(), Paths{file});
}

TEST_F(FileWatcherTest, TakesAFifoInThePlaceOfAFileForNoFile) {
    const std::string file = folder.write("a", "old");
    watcher.watch({file, folder.path("")});
    fs::remove(file);
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    EXPECT_EQ(news(), (Paths{file, folder.path("")})) << "it is gone";
    EXPECT_TRUE(file_states(file).empty());
    EXPECT_TRUE(file_states(folder.path("")).empty());
    fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::hours(1));
    EXPECT_EQ(news(), Paths()) << "as whoever writes into it does";
    fs::remove(file);
    folder.write("a", "new");
    EXPECT_EQ(news(), (Paths{file, folder.path("")}));
}

TEST_F(FileWatcherTest, TellsOfAFileThatComesUpAlsoInANewFolder) {
    const std::string file = folder.path("not/yet/here");
    watcher.watch({file});
    EXPECT_EQ(news(), Paths());
    folder.write("not/yet/here", "new");
    EXPECT_EQ(news(), Paths{file});
    fs::rename(folder.path("not"), folder.path("gone"));
    EXPECT_EQ(news(), Paths{file});
    folder.write("not/yet/here", "for a moment");
    EXPECT_EQ(look(), Paths());
    fs::remove(file);
    EXPECT_EQ(look(), Paths());
    EXPECT_EQ(look(), Paths{file}) << "once";
    folder.write("not/yet/here", "in a new folder");
    EXPECT_EQ(news(), Paths{file});
}

TEST_F(FileWatcherTest, FollowsSymbolicLinks) {
    folder.write("far/v1/real", "old");
    folder.write("far/v2/real", "new");
    fs::last_write_time(folder.path("far/v2/real"), fs::last_write_time(folder.path("far/v1/real")));
    fs::create_symlink("v1", folder.path("far/current"));
    fs::create_symlink("far/current/real", folder.path("link"));
    const std::string link = folder.path("link");
    watcher.watch({link});
    folder.write("far/v1/real", "written where the link leads");
    EXPECT_EQ(news(), Paths{link});
    fs::create_symlink("v2", folder.path("far/next"));
    fs::rename(folder.path("far/next"), folder.path("far/current"));
    EXPECT_EQ(news(), Paths{link}) << "a folder on the way was replaced";
    folder.write("far/v1/same", "new");
    fs::last_write_time(folder.path("far/v1/same"), fs::last_write_time(folder.path("far/v2/real")));
    fs::remove(link);
    fs::create_symlink("far/v1/same", link);
    EXPECT_EQ(news(), Paths{link}) << "only the link was replaced";
    fs::remove(link);
    fs::create_symlink("link", link);
    EXPECT_EQ(news(), Paths{link}) << "it leads to itself";
}

TEST_F(FileWatcherTest, TakesAFolderForAllFilesInIt) {
    folder.write("shaders/a", "old");
    folder.write("elsewhere", "old");
    const std::string shaders = folder.path("shaders");
    fs::create_symlink(folder.path("elsewhere"), folder.path("shaders/linked"));
    watcher.watch({shaders});
    for (const char* name : {"shaders/a", "shaders/b", "elsewhere"}) {
        folder.write(name, "new content");
        EXPECT_EQ(news(), Paths{shaders}) << name;
    }
    fs::remove(folder.path("shaders/b"));
    EXPECT_EQ(news(), Paths{shaders}) << "the program's own shader is to be used again";
}

TEST_F(FileWatcherTest, KeepsWatchingWhatStaysOnTheList) {
    const std::string file = folder.write("a", "old");
    const std::string other = folder.write("b", "old");
    watcher.watch({file, other});
    folder.write("a", "new content");
    folder.write("b", "new content");
    watcher.watch({file});
    EXPECT_EQ(news(), Paths{file}) << "it changed before the list did; the other is not watched any more";
}

TEST_F(FileWatcherTest, DoesNotWaitForADiskThatHangs) {
    const auto hangs = std::make_shared<std::atomic<bool>>(true);
    FileWatcher patient(std::chrono::milliseconds(1),
                        [hangs, first = std::make_shared<std::atomic<bool>>(true)](const std::string&) {
                            if (!first->exchange(false)) hangs->wait(true);
                            return FileStates{{"", FileState{{}, *hangs ? 1U : 2U, {}}}};
                        });
    patient.watch({"a"});
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(patient.look(now += std::chrono::seconds(1)), Paths());
        EXPECT_EQ(patient.next_look(), now + std::chrono::milliseconds(250)) << "nobody asks without a pause";
    }
    *hangs = false;
    hangs->notify_all();
    EXPECT_TRUE(test::eventually([&] { return patient.look(now += std::chrono::seconds(1)) == Paths{"a"}; }));
}

}  // namespace
}  // namespace sphereview
