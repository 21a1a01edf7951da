#include "viewer/recovery.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "app/load_scene.hpp"
#include "support/environment.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

struct AutosaveTest : testing::Test {
    // Looks at the document so much later, and says whether changes are kept then.
    bool kept_after(Autosave::Clock::duration time) {
        now += time;
        autosave.look(document, "/scene.txt", now);
        return fs::exists(folder.path("state/sphereview")) && !fs::is_empty(folder.path("state/sphereview"));
    }
    void change() { document.apply(InsertSpheres{{0}, {{}}}, "Add"); }

    test::TemporaryFolder folder;
    test::Variable state{"XDG_STATE_HOME", folder.path("state")};
    Document document;
    Autosave autosave;
    Autosave::Clock::time_point now = Autosave::Clock::now();
};

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
    EXPECT_TRUE(autosave.keep(document, "")) << "at once";
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
    Scene large;
    large.spheres.resize(20'000);
    document = Document(std::move(large));
    change();
    kept_after(0s);
    kept_after(1h);
    ASSERT_TRUE(autosave.due()) << "to see its end";
    autosave.finish();
    ASSERT_TRUE(kept_after(0s));
    EXPECT_FALSE(autosave.due());
    document.mark_saved();
    EXPECT_FALSE(kept_after(0s));
}

TEST_F(AutosaveTest, NeverReplacesWhatIsKeptAtOnce) {
    Scene large;
    large.spheres.resize(20'000);
    document = Document(std::move(large));
    change();
    kept_after(0s);
    kept_after(1h);
    document.apply(RemoveSpheres{{0}}, "Remove");
    ASSERT_TRUE(autosave.keep(document, ""));
    autosave.finish();
    const fs::directory_iterator files(folder.path("state/sphereview"));
    const auto kept = std::ranges::find(begin(files), end(files), ".toml", [](const auto& file) { return file.path().extension(); });
    EXPECT_EQ(load_scene(kept->path().string()).scene.spheres.size(), 20'000u) << "the newer of the two";
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

}  // namespace

}  // namespace sphereview
