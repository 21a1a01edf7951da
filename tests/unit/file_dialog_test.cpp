#include "platform/file_dialog.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <vector>

#include "support/environment.hpp"
#include "support/eventually.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_match.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

// A PATH with nothing but our own zenity and kdialog; each notes its arguments, one a line.
struct FileDialog : testing::Test {
    test::TemporaryFolder folder;
    test::Variable path{"PATH", folder.path("bin")};
    test::Variable desktop{"XDG_CURRENT_DESKTOP", {}};
    test::Variable choice{"SPHEREVIEW_FILE_DIALOG", {}};

    void install(const std::string& name, const std::string& script) const {
        const std::string file = folder.write("bin/" + name, "#!/bin/sh\nfor argument; do echo \"$argument\"; done > '" +
                                                                 folder.path("arguments") + "'\n" + script + "\n");
        fs::permissions(file, fs::perms::owner_all);
    }
    std::vector<std::string> arguments() const { return test::lines(folder.read("arguments")); }

    SystemFileDialog::Result answer() const {
        std::atomic<int> calls = 0;
        SystemFileDialog dialog(request, [&] { ++calls; });
        EXPECT_TRUE(test::eventually([&] { return calls == 1; }));
        const auto result = dialog.result();
        EXPECT_TRUE(result.has_value());
        return result.value_or(FileDialogFailed{"no result"});
    }
    std::string failure() const {
        const auto result = answer();
        const auto* failed = std::get_if<FileDialogFailed>(&result);
        return failed == nullptr ? "it did not fail" : failed->reason;
    }

    FileDialogRequest request{false, "Open a scene", "/home/a b", "", {{"Scenes", {".toml", ".txt"}}, {"All files", {}}}};
};

}  // namespace

TEST_F(FileDialog, IsThereWhereAProgramIs) {
    EXPECT_FALSE(SystemFileDialog::available());
    install("kdialog", "");
    EXPECT_TRUE(SystemFileDialog::available());
    const test::Variable none("SPHEREVIEW_FILE_DIALOG", "none");
    EXPECT_FALSE(SystemFileDialog::available());
}

TEST_F(FileDialog, GivesTheChosenPathAsItIs) {
    const std::string chosen = "/home/a b/it's \"K\xC3\xBCgeln\" $HOME;.toml ";
    folder.write("chosen", chosen + "\n");
    install("zenity", "echo a warning >&2; /bin/cat '" + folder.path("chosen") + "'");
    const auto result = answer();
    ASSERT_TRUE(std::holds_alternative<FileChosen>(result));
    EXPECT_EQ(std::get<FileChosen>(result).path, chosen);
    EXPECT_EQ(arguments(), (std::vector<std::string>{"--file-selection", "--title=Open a scene", "--filename=/home/a b/",
                                                     "--file-filter=Scenes | *.toml *.txt", "--file-filter=All files | *"}));
}

TEST_F(FileDialog, LetsZenityAskBeforeAFileIsReplaced) {
    install("zenity", "echo /x");
    request.saving = true;
    request.name = "new.toml";
    answer();
    EXPECT_EQ(arguments(), (std::vector<std::string>{"--file-selection", "--title=Open a scene", "--filename=/home/a b/new.toml",
                                                     "--save", "--confirm-overwrite", "--file-filter=Scenes | *.toml *.txt",
                                                     "--file-filter=All files | *"}));
}

TEST_F(FileDialog, IsKdialogUnderKde) {
    install("zenity", "echo /from/zenity");
    install("kdialog", "echo /from/kdialog");
    EXPECT_EQ(std::get<FileChosen>(answer()).path, "/from/zenity");
    const test::Variable kde("XDG_CURRENT_DESKTOP", "X-Own:KDE");
    EXPECT_EQ(std::get<FileChosen>(answer()).path, "/from/kdialog");
    EXPECT_EQ(arguments(), (std::vector<std::string>{"--title", "Open a scene", "--getopenfilename", "/home/a b/",
                                                     "Scenes (*.toml *.txt)", "All files (*)"}))
        << "the filters are one argument of two lines";
    request.saving = true;
    request.name = "n";
    answer();
    EXPECT_EQ(arguments()[2], "--getsavefilename");
    EXPECT_EQ(arguments()[3], "/home/a b/n");
    fs::remove(folder.path("bin/kdialog"));
    EXPECT_EQ(std::get<FileChosen>(answer()).path, "/from/zenity");
}

TEST_F(FileDialog, IsCancelled) {
    install("zenity", "echo 'Gtk-WARNING: a theme is missing' >&2; exit 1");
    EXPECT_TRUE(std::holds_alternative<FileDialogCancelled>(answer()));
}

TEST_F(FileDialog, SaysWhyItFailed) {
    EXPECT_EQ(failure(), "zenity or kdialog cannot be started: No such file or directory") << "though it is not available";
    install("zenity", "echo 'This option is not available.' >&2; exit 255");
    EXPECT_EQ(failure(), "zenity failed with status 255: This option is not available.");
    install("zenity", "echo >&2; echo 'a warning' >&2; echo 'Gtk-WARNING **: cannot open display: :9' >&2; exit 1");
    EXPECT_EQ(failure(), "zenity failed with status 1: Gtk-WARNING **: cannot open display: :9");
    install("zenity", "kill -SEGV $$");
    EXPECT_EQ(failure(), "zenity was ended by signal 11");
    install("zenity", "exit 0");
    EXPECT_EQ(failure(), "zenity names no file");
}

TEST_F(FileDialog, IsClosedByDestruction) {
    install("zenity", "echo $$ > '" + folder.path("number") + "'; /bin/sleep 1000");
    std::atomic<int> calls = 0;
    std::string number;
    {
        SystemFileDialog dialog(request, [&] { ++calls; });
        ASSERT_TRUE(test::eventually([&] {
            std::ifstream(folder.path("number")) >> number;
            return !number.empty();
        }));
        EXPECT_FALSE(dialog.result().has_value());
    }
    EXPECT_FALSE(fs::exists("/proc/" + number));
    EXPECT_EQ(calls, 0);
}

}  // namespace sphereview
