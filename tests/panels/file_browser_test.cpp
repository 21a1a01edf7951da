#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "panels/file_listing.hpp"
#include "panels/harness.hpp"
#include "panels/panel_context.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

TEST(Paths, AreTypedAbsoluteRelativeOrFromHome) {
    EXPECT_EQ(typed_path("/a/b", "/x"), "/a/b");
    EXPECT_EQ(typed_path("b/c", "/x"), "/x/b/c");
    EXPECT_EQ(typed_path("../c", "/x/y"), "/x/c");
    EXPECT_EQ(typed_path("  /a/b/ \n", "/x"), "/a/b");
    EXPECT_EQ(typed_path("/", "/x"), "/");
    EXPECT_EQ(typed_path("", "/x"), "/x");
    EXPECT_EQ(typed_path("..", "/"), "/");
    EXPECT_EQ(typed_path("~", "/x"), home_folder());
    EXPECT_EQ(typed_path("~/c", "/x"), home_folder() / "c");
    EXPECT_EQ(typed_path("~c", "/x"), "/x/~c") << "another user's home is not looked up";
}

TEST(Paths, KeepTheirBytes) {
    for (const std::string text : {"/a/Kugeln äöü.txt", "/球/四.toml", "/bad \xff utf"})
        EXPECT_EQ(text_from(path_from(text)), text);
}

TEST(Paths, HaveEndings) {
    EXPECT_TRUE(has_ending("a.txt", ".txt"));
    EXPECT_TRUE(has_ending("A.TXT", ".txt"));
    EXPECT_FALSE(has_ending("a.txt.png", ".txt"));
    EXPECT_FALSE(has_ending("txt", ".txt"));
}

TEST(Labels, AreFitForImGui) {
    EXPECT_EQ(as_label("a##b###c"), "a# #b# # #c");
    EXPECT_EQ(as_label("a\nb\tc\x7f"), "a b c ");
    EXPECT_EQ(as_label("ä"), "ä");
    EXPECT_EQ(on_one_line("##\r\n"), "##  ");
}

std::vector<std::string> names_of(const Listing& listing) {
    std::vector<std::string> names;
    for (const FileBrowser::Entry& entry : listing.entries) names.push_back(entry.name + (entry.is_folder ? "/" : ""));
    return names;
}

using Names = std::vector<std::string>;

TEST(FileListing, HasFoldersFirstAndDoesNotMindCapitals) {
    const test::TemporaryFolder folder;
    for (const char* name :
         {"b.txt", "A.txt", "c.TOML", "a.txt", "picture.png", ".hidden.txt", "Zoo/x", "ape/x", ".git/x", "ä.txt"}) {
        folder.write(name, "");
    }
    const Listing listing = list_folder(folder.path(), {".txt", ".toml"}, false);
    EXPECT_EQ(listing.error, "");
    EXPECT_EQ(names_of(listing), (Names{"../", "ape/", "Zoo/", "A.txt", "a.txt", "b.txt", "c.TOML", "ä.txt"}));
    EXPECT_EQ(names_of(list_folder(folder.path(), {".txt"}, true)),
              (Names{"../", ".git/", "ape/", "Zoo/", ".hidden.txt", "A.txt", "a.txt", "b.txt", "ä.txt"}));
    EXPECT_EQ(names_of(list_folder(folder.path(), {}, false)).size(), 9U);
}

TEST(FileListing, FollowsLinksAndShowsThoseThatLeadNowhere) {
    const test::TemporaryFolder folder;
    folder.write("real/x", "");
    fs::create_directory_symlink(folder.path("real"), folder.path("link"));
    fs::create_symlink(folder.path("nothing"), folder.path("broken"));
    EXPECT_EQ(names_of(list_folder(folder.path(), {}, false)), (Names{"../", "link/", "real/", "broken"}));
}

TEST(FileListing, SaysWhyThereIsNone) {
    const test::TemporaryFolder folder;
    folder.write("file", "");
    EXPECT_EQ(list_folder(folder.path("missing"), {}, false).error,
              "Cannot read " + folder.path("missing") + ": No such file or directory");
    EXPECT_EQ(list_folder(folder.path("file"), {}, false).error, "Cannot read " + folder.path("file") + ": Not a directory");
    EXPECT_EQ(list_folder(folder.path("missing"), {}, false).entries.size(), 0U);
}

TEST(FileListing, TheRootHasNothingAbove) {
    const Listing listing = list_folder("/", {}, false);
    EXPECT_EQ(listing.error, "");
    EXPECT_FALSE(listing.entries.empty());
    EXPECT_NE(listing.entries.at(0).name, "..");
}

class BrowserDialog : public testing::Test {
protected:
    test::TemporaryFolder folder;
    DialogHarness harness;
    std::vector<std::string> accepted;

    BrowserDialog() {
        for (const char* name : {"four.txt", "Sieben Kugeln äöü.toml", "picture.png", "sub/deep.txt"}) folder.write(name, "0\n");
    }

    void open(bool saving = false) {
        FileBrowser browser;
        browser.saving = saving;
        browser.title = saving ? "Save scene" : "Open scene";
        browser.folder = folder.path();
        browser.endings = {".txt", ".toml"};
        browser.accept = [this](const std::string& path) { accepted.push_back(path); };
        harness.put(browser);
    }
    FileBrowser& browser() { return harness.top<FileBrowser>(); }
};

using Accepted = std::vector<std::string>;

TEST_F(BrowserDialog, ListsAndOpensByDoubleClick) {
    open();
    EXPECT_EQ(harness.top_id(), "browser");
    EXPECT_TRUE(harness.panels.has("entry four.txt"));
    EXPECT_FALSE(harness.panels.has("entry picture.png"));
    harness.panels.double_click("entry Sieben Kugeln äöü.toml");
    EXPECT_EQ(accepted, Accepted{folder.path("Sieben Kugeln äöü.toml")});
    EXPECT_TRUE(harness.dialogs.empty());
}

TEST_F(BrowserDialog, OpensByClickAndButton) {
    open();
    harness.click("browser ok");
    EXPECT_EQ(browser().error, "Choose a file.");
    harness.click("entry four.txt");
    EXPECT_TRUE(accepted.empty());
    EXPECT_EQ(browser().name, "four.txt");
    harness.click("browser ok");
    EXPECT_EQ(accepted, Accepted{folder.path("four.txt")});
}

TEST_F(BrowserDialog, WalksThroughFolders) {
    open();
    harness.panels.double_click("entry sub");
    harness.panels.frames(3);
    EXPECT_EQ(browser().folder, folder.path("sub"));
    EXPECT_TRUE(harness.panels.has("entry deep.txt"));
    harness.panels.double_click("entry ..");
    harness.panels.frames(3);
    EXPECT_EQ(browser().folder, folder.path());
    harness.click("browser up");
    EXPECT_EQ(browser().folder, fs::path(folder.path()).parent_path().string());
    harness.click("browser home");
    EXPECT_EQ(browser().error, "");
    harness.type_over("browser path", folder.path("sub") + "/");
    harness.enter();
    EXPECT_EQ(browser().folder, folder.path("sub"));
    EXPECT_TRUE(accepted.empty());
    harness.type_over("browser path", "..");
    harness.enter();
    EXPECT_EQ(browser().folder, folder.path());
}

TEST_F(BrowserDialog, RefusesWhatIsNotThere) {
    open();
    harness.type_over("browser path", folder.path("missing"));
    harness.enter();
    EXPECT_EQ(browser().folder, folder.path());
    EXPECT_EQ(browser().error, "Cannot read " + folder.path("missing") + ": No such file or directory");
    harness.type_over("browser name", "missing.txt");
    harness.enter();
    EXPECT_EQ(browser().error, "There is no file " + folder.path("missing.txt") + ".");
    EXPECT_TRUE(accepted.empty());
    harness.escape();
    EXPECT_TRUE(harness.dialogs.empty());
    EXPECT_TRUE(accepted.empty());
}

TEST_F(BrowserDialog, TakesATypedFileOrFolder) {
    open();
    harness.type_over("browser name", "sub");
    harness.enter();
    EXPECT_EQ(browser().folder, folder.path("sub"));
    EXPECT_EQ(browser().name, "");
    harness.type_over("browser name", "../picture.png");
    harness.enter();
    EXPECT_EQ(accepted, Accepted{folder.path("picture.png")}) << "a typed name need not have an ending that is listed";
    open();
    harness.type_over("browser path", folder.path("sub/deep.txt"));
    harness.enter();
    EXPECT_EQ(accepted.back(), folder.path("sub/deep.txt"));
}

TEST_F(BrowserDialog, BeginsNearAMissingFolder) {
    FileBrowser browser;
    browser.folder = folder.path("gone/away");
    browser.title = "Open";
    harness.put(browser);
    EXPECT_EQ(this->browser().folder, folder.path());
    EXPECT_EQ(this->browser().error, "Cannot read " + folder.path("gone/away") + ": No such file or directory");
}

TEST_F(BrowserDialog, SavesUnderANewName) {
    open(true);
    harness.enter();
    EXPECT_EQ(browser().error, "The file needs a name.");
    harness.type_over("browser name", "neue Szene.v2");
    harness.enter();
    EXPECT_EQ(accepted, Accepted{folder.path("neue Szene.v2.txt")});
    open(true);
    harness.type_over("browser name", "b.TOML");
    harness.enter();
    EXPECT_EQ(accepted.back(), folder.path("b.TOML"));
    open(true);
    harness.type_over("browser name", "no/b.toml");
    harness.enter();
    EXPECT_EQ(browser().error, "There is no folder " + folder.path("no") + ".");
}

TEST_F(BrowserDialog, AsksBeforeItReplaces) {
    open(true);
    harness.type_over("browser name", "four.txt");
    harness.click("browser ok");
    EXPECT_EQ(harness.top_id(), "replace");
    harness.click("answer Cancel");
    EXPECT_EQ(harness.top_id(), "browser");
    EXPECT_TRUE(accepted.empty());
    harness.panels.double_click("entry four.txt");
    harness.panels.frames(4);
    EXPECT_EQ(harness.top_id(), "replace");
    harness.click("answer Replace");
    EXPECT_EQ(accepted, Accepted{folder.path("four.txt")});
    EXPECT_TRUE(harness.dialogs.empty());
}

TEST_F(BrowserDialog, AlsoTheNameWithItsEndingIsNotReplacedSilently) {
    open(true);
    harness.type_over("browser name", "four");
    harness.enter();
    EXPECT_EQ(harness.top_id(), "replace");
}

TEST_F(BrowserDialog, ShowsHiddenFilesWhenAsked) {
    folder.write(".secret.txt", "0\n");
    open();
    EXPECT_FALSE(harness.panels.has("entry .secret.txt"));
    harness.click("browser hidden");
    EXPECT_TRUE(harness.panels.has("entry .secret.txt"));
}

TEST_F(BrowserDialog, DrawsOnlyWhatIsSeenOfManyFiles) {
    for (int i = 0; i < 3000; ++i) folder.write("many/" + std::to_string(10000 + i) + ".txt", "");
    folder.write("many/##\n%s.txt", "");
    open();
    harness.panels.double_click("entry many");
    harness.panels.frames(4);
    EXPECT_EQ(browser().entries.size(), 3002U);
    EXPECT_LT(harness.panels.rectangles.size(), 100U);
    harness.panels.double_click("entry ##\n%s.txt");
    EXPECT_EQ(accepted, Accepted{folder.path("many/##\n%s.txt")});
}

}  // namespace

}  // namespace sphereview
