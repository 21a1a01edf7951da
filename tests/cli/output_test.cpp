// Output appears whole or not at all.
#include <gtest/gtest.h>

#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class Output : public testing::Test {
protected:
    Output() { folder_.write("red.txt", red_scene); }

    Outcome render_into(const std::string& path) const { return render(folder_, {"red.txt", "-s", "5x5", "-o", path}); }

    TemporaryFolder folder_;
};

TEST_F(Output, ThatCannotBeIsRefusedWithTheReason) {
    folder_.write("folder/file", "");
    fs::create_symlink("loop", folder_.path("loop"));
    fs::create_symlink("missing/new.png", folder_.path("dangling"));
    const auto before = folder_.names();
    const std::string long_name = std::string(300, 'n') + ".png";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"folder", "folder: cannot be written: it is a folder"},
        {"folder/", "folder/: cannot be written: it is a folder"},
        {"new/", "new/: cannot be written: it names a folder"},
        {"missing/new.png", "missing/new.png: cannot be written: the folder missing does not exist"},
        {"red.txt/new.png", "red.txt/new.png: cannot be written: Not a directory"},
        {"dangling", "dangling: cannot be written: the folder missing does not exist"},
        {"loop", "loop: cannot be written: Too many levels of symbolic links"},
        {"/proc/new.png", "/proc/new.png: cannot be written: "},
        {"/dev/full", "/dev/full: cannot be written: No space left on device"},
        {long_name, long_name + ": cannot be written: File name too long"},
    };
    for (const auto& [path, said] : cases) {
        const Outcome outcome = render_into(path);
        EXPECT_EQ(outcome.status, 4) << path << ": " << outcome;
        EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome;
        EXPECT_TRUE(outcome.errors.starts_with(said)) << outcome;
        EXPECT_EQ(folder_.names(), before) << path;
    }
}

TEST_F(Output, ThatIsRefusedIsRefusedBeforeTheScenesAreRead) {
    const Outcome outcome = render(folder_, {"missing.txt", "-o", "folder/new.png"});
    EXPECT_EQ(outcome.status, 4) << outcome;
    EXPECT_TRUE(outcome.errors.starts_with("folder/new.png: cannot be written")) << outcome;
}

TEST_F(Output, DoesNotReplaceWhatIsProtected) {
    folder_.write("protected.png", "old");
    fs::permissions(folder_.path("protected.png"), fs::perms::owner_read);
    folder_.write("locked/old.png", "old");
    fs::permissions(folder_.path("locked"), fs::perms::owner_read | fs::perms::owner_exec);
    for (const char* path : {"protected.png", "locked/new.png"}) {
        Command command = cpu_render(folder_, {"red.txt", "-s", "5x5", "-o", path});
        command.obeys_permissions = true;
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 4) << outcome;
        EXPECT_EQ(outcome.errors, std::string(path) + ": cannot be written: Permission denied\n");
    }
    EXPECT_EQ(folder_.read("protected.png"), "old");
    fs::permissions(folder_.path("locked"), fs::perms::owner_all);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path("locked")), fs::directory_iterator()), 1);
}

TEST_F(Output, BeyondAFileSizeLimitLeavesTheOldFileAndNothingElse) {
    folder_.write("old.png", "old");
    for (const char* path : {"old.png", "new.png"}) {
        Command command = cpu_render(folder_, {"red.txt", "-s", "1000x1000", "-o", path});
        command.largest_file = 100;
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 4) << outcome;
        EXPECT_EQ(outcome.errors, std::string(path) + ": cannot be written: File too large\n");
    }
    Command command;
    command.arguments = {"convert", "red.txt", "old.png", "--to", "toml"};
    command.folder = folder_.path();
    command.largest_file = 10;
    EXPECT_EQ(run(command).status, 4);
    EXPECT_EQ(folder_.read("old.png"), "old");
    EXPECT_EQ(folder_.names(), (Names{"old.png", "red.txt"}));
}

TEST_F(Output, OfTwoRunsIsTheSameBytes) {
    ASSERT_EQ(render(folder_, {"red.txt", "-o", "one.png"}).status, 0);
    ASSERT_EQ(render(folder_, {"red.txt", "-o", "two.png"}).status, 0);
    EXPECT_TRUE(folder_.read("one.png") == folder_.read("two.png"));
}

}  // namespace
}  // namespace sphereview::test
