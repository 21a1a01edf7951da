// What is kept of changes, and when.
#include "viewer/recovery.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <random>
#include <thread>

#include "app/load_scene.hpp"
#include "base/input_file.hpp"
#include "formats/scene_format.hpp"
#include "support/environment.hpp"
#include "support/no_threads.hpp"
#include "support/spheres.hpp"
#include "support/temporary_folder.hpp"
#include "unit/random_scene.hpp"
#include "unit/scene_difference.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

struct RecoveryTest : testing::Test {
    test::TemporaryFolder folder;
    test::Variable state{"XDG_STATE_HOME", folder.path("state")};

    Scene kept_scene() const {
        const fs::directory_iterator files(folder.path("state/sphereview"));
        const auto kept =
            std::ranges::find(begin(files), end(files), ".toml", [](const auto& file) { return file.path().extension(); });
        return load_scene(kept->path().string()).scene;
    }
};

struct AutosaveTest : RecoveryTest {
    // Looks at the document so much later, and says whether changes are kept then.
    bool kept_after(Autosave::Clock::duration time) {
        now += time;
        for (const bool ended : {false, true}) {  // what the first look begins is looked at by the second
            if (ended) autosave.finish();
            autosave.look(document, {"/scene.txt"}, now);
        }
        return fs::exists(folder.path("state/sphereview")) && !fs::is_empty(folder.path("state/sphereview"));
    }
    void begin_to_keep_a_large_scene() {
        Scene large = scene_of_alike(20'000);
        document = Document(std::move(large));
        change();
        autosave.look(document, {}, now);
        autosave.look(document, {}, now + 1h);
    }
    void change() { document.apply(InsertSpheres{{0}, {{}}}, "Add"); }

    Document document;
    Autosave autosave;
    Autosave::Clock::time_point now = Autosave::Clock::now();
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

Scene seeded_scene(unsigned seed) {
    std::mt19937_64 random(seed);
    return random_scene(random);
}

Scene scene_in(const Recovery& recovery) { return parse_scene(InputFile(recovery.file).bytes(), recovery.file); }

}  // namespace

TEST_F(RecoveryTest, GivesEveryBitBack) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        const Scene scene = seeded_scene(seed);
        Other other([&] { return write_recovery(scene, {"/scenes/a b.toml"}); });
        other.end();
        const auto recoveries = list_recoveries();
        ASSERT_EQ(recoveries.size(), 1U) << seed;
        EXPECT_EQ(recoveries[0].original.path, "/scenes/a b.toml");
        ASSERT_EQ(difference(scene_in(recoveries[0]), scene), "") << "seed " << seed;
        EXPECT_TRUE(remove_recovery(recoveries[0].file));
        EXPECT_TRUE(list_recoveries().empty());
    }
}

TEST_F(RecoveryTest, KnowsWhatWasEdited) {
    const std::string odd = "/K\xC3\xBCgeln/\xFF\n\r\t %41'\"#.toml";
    for (const std::string& original : {std::string(), odd, std::string("relative.txt")}) {
        std::optional<EditedFrame> frame;
        if (original == odd) frame = EditedFrame{12, std::int64_t{1} << 40, -7, true};
        Other other([&] { return write_recovery({}, {original, frame}); });
        other.end();
        const auto recoveries = list_recoveries();
        ASSERT_EQ(recoveries.size(), 1U);
        EXPECT_EQ(recoveries[0].original.path, original == "relative.txt" ? (fs::current_path() / original).string() : original);
        EXPECT_EQ(recoveries[0].original.frame, frame);
        EXPECT_EQ(difference(scene_in(recoveries[0]), Scene{}), "");
        const auto age = std::chrono::system_clock::now() - recoveries[0].time;
        EXPECT_LT(age, std::chrono::hours(1));
        EXPECT_GT(age, std::chrono::hours(-1));
        remove_recovery(recoveries[0].file);
    }
}

TEST_F(RecoveryTest, LeavesARunningProcessItsOwn) {
    Other first([] { return write_recovery(seeded_scene(2), {"/first"}); });
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // the order is by time, in milliseconds
    Other second([] { return write_recovery(seeded_scene(3), {"/not yet"}) && write_recovery(seeded_scene(4), {"/second"}); });
    EXPECT_TRUE(write_recovery(seeded_scene(1), {"/own"}));  // last: a copy of this process would share its lock
    EXPECT_TRUE(list_recoveries().empty());
    second.end();
    ASSERT_EQ(list_recoveries().size(), 1U);
    first.end();
    const auto recoveries = list_recoveries();
    ASSERT_EQ(recoveries.size(), 2U);
    EXPECT_EQ(recoveries[0].original.path, "/second");
    EXPECT_EQ(difference(scene_in(recoveries[0]), seeded_scene(4)), "");
    EXPECT_EQ(recoveries[1].original.path, "/first");
    EXPECT_EQ(difference(scene_in(recoveries[1]), seeded_scene(2)), "");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"state"});
    EXPECT_TRUE(remove_own_recovery());
    EXPECT_TRUE(remove_own_recovery()) << "it is gone";
    EXPECT_EQ(list_recoveries().size(), 2U);
}

TEST_F(RecoveryTest, SaysWhenNothingCanBeKept) {
    folder.write("state", "a file, not a folder");
    EXPECT_FALSE(write_recovery(seeded_scene(1), {"/a"}));
    EXPECT_TRUE(list_recoveries().empty());
    EXPECT_EQ(folder.read("state"), "a file, not a folder");
    const test::Variable none("XDG_STATE_HOME", {});
    const test::Variable home("HOME", {});
    EXPECT_FALSE(write_recovery(seeded_scene(1), {"/a"}));
    EXPECT_TRUE(list_recoveries().empty());
    EXPECT_TRUE(remove_own_recovery());
}

TEST_F(RecoveryTest, PassesOverWhatIsNoRecovery) {
    folder.write("state/sphereview/recovery-1x.toml", "# another comment\n");
    folder.write("state/sphereview/recovery-2147483646-7.toml", "");
    folder.write("state/sphereview/recovery-.toml", "# sphereview recovery, milliseconds since 1970: x\n# of: /a\n");
    for (const std::string time : {"9223372036854775807", "9223372036855", "-1"}) {  // that the clock cannot say
        folder.write("state/sphereview/recovery-" + time + ".toml",
                     "# sphereview recovery, milliseconds since 1970: " + time + "\n# of: /a\n");
    }
    folder.write("state/sphereview/recovery.toml", "");
    folder.write("state/sphereview/other", "");
    fs::create_directories(folder.path("state/sphereview/recovery-2147483646-8.toml"));
    EXPECT_TRUE(list_recoveries().empty());
    EXPECT_FALSE(remove_recovery(folder.path("state/sphereview"))) << "a folder with files in it";
}

// A file that somebody has made could ask what it likes.
TEST_F(RecoveryTest, IsAskedAboutOnOneLine) {
    folder.write("state/sphereview/recovery-1.toml",
                 "# sphereview recovery, milliseconds since 1970: 1\n# of: %1B[2J/a%0AFORGED%E2%80%A8too\n");
    ASSERT_EQ(list_recoveries().size(), 1U);
    EXPECT_EQ(in_words(list_recoveries().front()),
              R"(sphereview ended with unsaved changes of \x1b[2J/a\x0aFORGED\xe2\x80\xa8too.)");
    EXPECT_EQ(in_words(Recovery()), "sphereview ended with unsaved changes of an untitled scene.");
}

TEST_F(RecoveryTest, IsOfNoFrameWhereTheHeadIsOdd) {
    for (const std::string numbers : {"", "1", "1 2 3", "-1 2 3 1", "1 2 99999999999999999999 1", "a 2 3 1"}) {
        folder.write("state/sphereview/recovery-1.toml",
                     "# sphereview recovery, milliseconds since 1970: 1\n# of: /a\n"
                     "# frame, bytes and time of the file, whether numbers are the file's: " +
                         numbers + "\n");
        ASSERT_EQ(list_recoveries().size(), 1U);
        EXPECT_EQ(list_recoveries().front().original, EditedFile{"/a"}) << numbers;
    }
}

TEST_F(RecoveryTest, OffersOnlyWhatIsSurelyLeftBehind) {
    const fs::path lock = folder.path("state/sphereview/recovery-1.lock");
    folder.write("state/sphereview/recovery-1.toml", "# sphereview recovery, milliseconds since 1970: 1\n# of: /a\n");
    EXPECT_EQ(list_recoveries().size(), 1U) << "nobody has locked it";
    EXPECT_TRUE(unclear_recoveries().empty());
    ASSERT_EQ(mkfifo(lock.c_str(), 0600), 0);
    EXPECT_TRUE(list_recoveries().empty()) << "and does not wait for the FIFO";
    fs::remove(lock);
    fs::create_symlink(lock, lock);
    EXPECT_TRUE(list_recoveries().empty()) << "the lock cannot be opened";
    EXPECT_EQ(unclear_recoveries(), std::vector<std::string>{folder.path("state/sphereview/recovery-1.toml")});
    fs::remove(lock);
    folder.write("state/sphereview/recovery-1.lock", "");
    EXPECT_EQ(list_recoveries().size(), 1U) << "who locked it has ended";
}

TEST_F(AutosaveTest, KeepsChangesSomeSecondsLaterAndOnce) {
    EXPECT_FALSE(kept_after(0s));
    EXPECT_FALSE(autosave.due()) << "nothing has changed";
    change();
    EXPECT_FALSE(kept_after(0s));
    ASSERT_TRUE(autosave.due());
    EXPECT_GT(*autosave.due(), now);
    EXPECT_FALSE(kept_after(1s));
    change();  // does not put it off
    EXPECT_TRUE(kept_after(1s));
    EXPECT_FALSE(kept_after(0s) && autosave.due()) << "nothing more to do";
    change();
    kept_after(0s);
    EXPECT_TRUE(autosave.due());
}

TEST_F(AutosaveTest, ForgetsWhatIsSavedOrUndone) {
    change();
    kept_after(0s);
    EXPECT_TRUE(kept_after(1h));
    document.mark_saved();
    EXPECT_FALSE(kept_after(0s));
    change();
    EXPECT_TRUE(autosave.keep(document, {})) << "at once";
    EXPECT_FALSE(autosave.due());
    EXPECT_TRUE(kept_after(1h));
    document.undo();
    EXPECT_FALSE(kept_after(0s));
}

TEST_F(AutosaveTest, KeepsWhatIsOnlyMarkedAsUnsaved) {
    document.mark_unsaved();
    kept_after(0s);
    EXPECT_TRUE(kept_after(1h));
}

TEST_F(AutosaveTest, KeepsALargeSceneInTheBackgroundAndForgetsItAfterwards) {
    begin_to_keep_a_large_scene();
    ASSERT_TRUE(autosave.due()) << "to see its end";
    autosave.finish();
    ASSERT_TRUE(kept_after(0s));
    EXPECT_FALSE(autosave.due());
    document.mark_saved();
    EXPECT_FALSE(kept_after(0s));
}

TEST_F(AutosaveTest, NeverReplacesWhatIsKeptAtOnce) {
    begin_to_keep_a_large_scene();
    document.apply(RemoveSpheres{{0}}, "Remove");
    ASSERT_TRUE(autosave.keep(document, {}));
    autosave.finish();
    EXPECT_EQ(kept_scene().spheres.size(), 20'000u) << "the newer of the two";
}

TEST_F(AutosaveTest, KeepsBeforeSomethingIsReadWhatIsNotKept) {
    EXPECT_EQ(autosave.keep_before_reading(document, {}), nullptr) << "nothing has changed";
    change();
    const auto job = autosave.keep_before_reading(document, {});
    ASSERT_NE(job, nullptr);
    EXPECT_EQ(autosave.keep_before_reading(document, {}), job) << "under way";
    autosave.finish();
    EXPECT_EQ(autosave.keep_before_reading(document, {}), nullptr);
}

TEST_F(AutosaveTest, WritesANewerCopyAfterTheOneThatIsBeingWritten) {
    Scene large = scene_of_alike(300'000);
    document = Document(std::move(large));
    document.mark_unsaved();
    const auto older = autosave.keep_before_reading(document, {});
    document = Document();  // takes much less time
    change();
    change();
    autosave.keep_before_reading(document, {})->wait();
    EXPECT_TRUE(older->ended());
    autosave.finish();
    EXPECT_EQ(kept_scene().spheres.size(), 2U);
}

TEST_F(AutosaveTest, KeepsAlsoWithoutAThreadAndNeverReplacesThatByAnOlderCopy) {
    if (!test::NoThreads::possible) GTEST_SKIP() << "threads can always begin here";
    begin_to_keep_a_large_scene();
    document.apply(RemoveSpheres{{0}}, "Remove");
    {
        const test::NoThreads none;
        EXPECT_EQ(autosave.keep_before_reading(document, {}), nullptr) << "kept";
    }
    autosave.finish();
    EXPECT_EQ(kept_scene().spheres.size(), 20'000u);
}

TEST_F(AutosaveTest, DoesNotTryAgainAndAgainWhereNothingCanBeWritten) {
    folder.write("file", "");
    const test::Variable broken("XDG_STATE_HOME", folder.path("file"));
    change();
    kept_after(0s);
    kept_after(1h);
    EXPECT_FALSE(autosave.due());
    kept_after(1h);
    EXPECT_FALSE(autosave.due());
    change();
    kept_after(0s);
    EXPECT_TRUE(autosave.due());
}

TEST_F(RecoveryTest, OfAHungLoopHasNoHalfOfAChange) {
    ViewerState window{ViewOptions{}, ViewerSettings{}};
    const auto add = [&] { window.document.apply(InsertSpheres{{0}, {{}}}, "Add"); };
    std::promise<void> begun;
    std::jthread loop([&] {
        const std::lock_guard change(window.changing);
        add();
        begun.set_value();
        std::this_thread::sleep_for(200ms);
        add();
    });
    begun.get_future().wait();
    EXPECT_EQ(keep_unsaved_of_hung_loop(window, 30s), "unsaved changes of untitled are kept; the next start offers them");
    EXPECT_EQ(kept_scene().spheres.size(), 2U);
    EXPECT_FALSE(std::async(std::launch::async, [&] { return window.changing.try_lock(); }).get()) << "the loop can change nothing";
    window.changing.unlock();
}

TEST_F(RecoveryTest, OfALoopThatHangsInAChangeIsGivenUp) {
    ViewerState window{ViewOptions{}, ViewerSettings{}};
    const std::lock_guard change(window.changing);
    window.document.mark_unsaved();
    EXPECT_EQ(std::async(std::launch::async, [&] { return keep_unsaved_of_hung_loop(window, 10ms); }).get(), std::nullopt);
    EXPECT_FALSE(folder.has("state/sphereview"));
}

}  // namespace sphereview
