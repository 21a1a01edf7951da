#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <filesystem>

#include "base/user_folders.hpp"
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

TEST(Paths, KeepTheirBytesAndHaveEndings) {
    for (const std::string text : {"/a/Kugeln äöü.txt", "/球/四.toml", "/bad \xff utf"})
        EXPECT_EQ(text_from(path_from(text)), text);
    EXPECT_TRUE(has_ending("a.txt", ".txt"));
    EXPECT_TRUE(has_ending("A.TXT", ".txt"));
    EXPECT_FALSE(has_ending("a.txt.png", ".txt"));
    EXPECT_FALSE(has_ending("txt", ".txt"));
}

TEST(Labels, AreFitForImGui) {
    EXPECT_EQ(as_label("a##b###c"), "a# #b# # #c");
    EXPECT_EQ(as_label("a\nb\x7f"), "a\\x0ab\\x7f");
    EXPECT_EQ(as_label("ä"), "ä");
    EXPECT_EQ(as_label(std::string(3000, 'x')), std::string(most_shown, 'x') + "...");
}

std::vector<std::string> names_of(Listing listing, FileOrder order = {}) {
    sort_entries(listing.entries, order);
    std::vector<std::string> names;
    for (const FileEntry& entry : listing.entries) names.push_back(entry.name + (entry.is_folder ? "/" : ""));
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

TEST(FileListing, SaysWhyThereIsNoneAndWhatTheRootHas) {
    const test::TemporaryFolder folder;
    folder.write("file", "");
    EXPECT_EQ(list_folder(folder.path("missing"), {}, false).error,
              "Cannot read " + folder.path("missing") + ": No such file or directory");
    EXPECT_EQ(list_folder(folder.path("file"), {}, false).error, "Cannot read " + folder.path("file") + ": Not a directory");
    EXPECT_EQ(list_folder(folder.path("missing"), {}, false).entries.size(), 0U);
    const Listing listing = list_folder("/", {}, false);
    EXPECT_EQ(listing.error, "");
    EXPECT_FALSE(listing.entries.empty());
    EXPECT_NE(listing.entries.at(0).name, "..");
}

TEST(FileListing, IsSortedByNameSizeOrDateWithFoldersFirst) {
    const test::TemporaryFolder folder;
    const auto write = [&](const char* name, std::size_t bytes, int hour) {
        const std::string path = folder.write(name, std::string(bytes, 'x'));
        fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(hour));
    };
    write("b.txt", 5, 1);
    write("A.txt", 70, 3);
    write("c.txt", 5, 2);
    folder.write("sub/x", "");
    const Listing listing = list_folder(folder.path(), {}, false);
    EXPECT_EQ(names_of(listing, {FileColumn::name, true}), (Names{"../", "sub/", "c.txt", "b.txt", "A.txt"}));
    EXPECT_EQ(names_of(listing, {FileColumn::size, false}), (Names{"../", "sub/", "b.txt", "c.txt", "A.txt"}));
    EXPECT_EQ(names_of(listing, {FileColumn::size, true}), (Names{"../", "sub/", "A.txt", "b.txt", "c.txt"}));
    EXPECT_EQ(names_of(listing, {FileColumn::date, false}), (Names{"../", "sub/", "A.txt", "c.txt", "b.txt"}));
    EXPECT_EQ(names_of(listing, {FileColumn::date, true}), (Names{"../", "sub/", "b.txt", "c.txt", "A.txt"}));
}

TEST(FileListing, SaysSizesAndDatesAsPeopleReadThem) {
    for (const auto& [bytes, text] : {std::pair<std::uint64_t, const char*>{0, "0 B"},
                                      {999, "999 B"},
                                      {1000, "1.0 kB"},
                                      {9'949, "9.9 kB"},
                                      {9'950, "10 kB"},
                                      {999'499, "999 kB"},
                                      {999'500, "1.0 MB"},
                                      {132'000'000, "132 MB"},
                                      {18'446'744'073'709'551'615U, "18446744 TB"}}) {
        EXPECT_EQ(size_text(bytes), text);
    }
    const std::time_t now = std::time(nullptr);
    const std::tm local = *std::localtime(&now);
    EXPECT_EQ(date_text(now).substr(0, 5), std::to_string(1900 + local.tm_year) + "-");
    EXPECT_EQ(date_text(now).size(), std::string("2026-11-29 04:35").size());
    const test::TemporaryFolder folder;
    folder.write("now.txt", "");
    EXPECT_NEAR(static_cast<double>(list_folder(folder.path(), {}, false).entries.back().changed), static_cast<double>(now), 5.0);
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
        browser.kinds = {{"Text", {".txt"}}, {"TOML", {".toml"}}};
        if (!saving) browser.kinds.insert(browser.kinds.begin(), {"All scenes", {".txt", ".toml"}});
        browser.places = {folder.path("sub"), "/"};
        browser.accept = [this](const std::string& path, PictureSize) { accepted.push_back(path); };
        harness.put(browser);
    }
    FileBrowser& browser() { return harness.top<FileBrowser>(); }
};

using Accepted = std::vector<std::string>;

TEST_F(BrowserDialog, KeepsNamesReadableWhereThereIsLittleRoom) {
    ImGui::GetIO().DisplaySize = {330.0F, 400.0F};
    open();
    EXPECT_FALSE(harness.panels.has("browser sort date"));
    const WidgetRectangle name = harness.panels.rectangles.at("browser sort name");
    EXPECT_GE(name.right - name.left, 10.0F * ImGui::GetFontSize());
    EXPECT_GT(harness.panels.rectangles.at("browser hidden").top, harness.panels.rectangles.at("browser ok").bottom);
    ImGui::GetIO().DisplaySize = {800.0F, 600.0F};
}

TEST_F(BrowserDialog, OpensByDoubleClickOrByClickAndButton) {
    open();
    EXPECT_EQ(harness.top_id(), "browser");
    EXPECT_TRUE(harness.panels.has("entry four.txt"));
    EXPECT_FALSE(harness.panels.has("entry picture.png"));
    harness.panels.double_click("entry Sieben Kugeln äöü.toml");
    EXPECT_EQ(accepted, Accepted{folder.path("Sieben Kugeln äöü.toml")});
    EXPECT_TRUE(harness.dialogs.empty());
    open();
    harness.click("browser ok");
    EXPECT_EQ(browser().error, "Choose a file.");
    harness.click("entry four.txt");
    EXPECT_EQ(accepted.size(), 1U);
    EXPECT_EQ(browser().name, "four.txt");
    harness.click("browser ok");
    EXPECT_EQ(accepted.back(), folder.path("four.txt"));
}

TEST_F(BrowserDialog, WalksThroughFoldersAndGoesToPlaces) {
    open();
    harness.double_click("entry sub");
    EXPECT_EQ(browser().folder, folder.path("sub"));
    EXPECT_TRUE(harness.panels.has("entry deep.txt"));
    harness.double_click("entry ..");
    EXPECT_EQ(browser().folder, folder.path());
    harness.click("browser up");
    EXPECT_EQ(browser().folder, fs::path(folder.path()).parent_path().string());
    harness.enter_over("browser path", folder.path("sub") + "/");
    EXPECT_EQ(browser().folder, folder.path("sub"));
    EXPECT_TRUE(accepted.empty());
    harness.enter_over("browser path", "..");
    EXPECT_EQ(browser().folder, folder.path());
    harness.click("place 0");
    EXPECT_EQ(browser().folder, folder.path("sub"));
    harness.click("place 1");
    EXPECT_EQ(browser().folder, "/");
    harness.click("browser home");
    EXPECT_EQ(browser().folder, home_folder());
    EXPECT_EQ(browser().error, "");
}

TEST_F(BrowserDialog, RefusesWhatIsNotThere) {
    open();
    harness.enter_over("browser path", folder.path("missing"));
    EXPECT_EQ(browser().folder, folder.path());
    EXPECT_EQ(browser().error, "Cannot read " + folder.path("missing") + ": No such file or directory");
    harness.enter_over("browser name", "missing.txt");
    EXPECT_EQ(browser().error, "There is no file " + folder.path("missing.txt") + ".");
    EXPECT_TRUE(accepted.empty());
    harness.escape();
    EXPECT_TRUE(harness.dialogs.empty());
    EXPECT_TRUE(accepted.empty());
}

TEST_F(BrowserDialog, TakesATypedFileOrFolder) {
    open();
    harness.enter_over("browser name", "sub");
    EXPECT_EQ(browser().folder, folder.path("sub"));
    EXPECT_EQ(browser().name, "");
    harness.enter_over("browser name", "../picture.png");
    EXPECT_EQ(accepted, Accepted{folder.path("picture.png")}) << "a typed name need not have an ending that is listed";
    open();
    harness.enter_over("browser path", folder.path("sub/deep.txt"));
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
    harness.enter_over("browser name", "neue Szene.v2");
    EXPECT_EQ(accepted, Accepted{folder.path("neue Szene.v2.txt")});
    open(true);
    harness.enter_over("browser name", "b.TOML");
    EXPECT_EQ(accepted.back(), folder.path("b.TOML"));
    open(true);
    harness.enter_over("browser name", "no/b.toml");
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
    harness.double_click("entry four.txt");
    EXPECT_EQ(harness.top_id(), "replace");
    harness.click("answer Replace");
    EXPECT_EQ(accepted, Accepted{folder.path("four.txt")});
    EXPECT_TRUE(harness.dialogs.empty());
    open(true);
    harness.enter_over("browser name", "four");
    EXPECT_EQ(harness.top_id(), "replace");
}

TEST_F(BrowserDialog, SortsByTheHeadThatIsClicked) {
    folder.write("z.txt", std::string(5000, 'x'));
    open();
    const auto above = [&](const std::string& upper, const std::string& lower) {
        return harness.panels.place("entry " + upper).y < harness.panels.place("entry " + lower).y;
    };
    EXPECT_TRUE(above("four.txt", "z.txt"));
    EXPECT_NE(harness.panels.text().find("5.0 kB"), std::string::npos) << harness.panels.text();
    harness.click("browser sort size");
    EXPECT_TRUE(above("z.txt", "four.txt")) << "the largest first";
    EXPECT_TRUE(above("sub", "z.txt")) << "folders stay first";
    harness.click("browser sort size");
    EXPECT_TRUE(above("four.txt", "z.txt"));
    harness.click("browser sort name");
    harness.click("browser sort name");
    EXPECT_TRUE(above("z.txt", "four.txt"));
    harness.panels.double_click("entry sub");
    harness.click("browser up");
    EXPECT_TRUE(above("z.txt", "four.txt")) << "the order holds for every folder";
}

TEST_F(BrowserDialog, ShowsHiddenFilesAndOneKindWhenAsked) {
    folder.write(".secret.txt", "0\n");
    open();
    EXPECT_FALSE(harness.panels.has("entry .secret.txt"));
    harness.click("browser hidden");
    EXPECT_TRUE(harness.panels.has("entry .secret.txt"));
    EXPECT_TRUE(harness.panels.has("entry four.txt"));
    harness.click("browser kind");
    harness.click("browser kind TOML (.toml)");
    EXPECT_FALSE(harness.panels.has("entry four.txt"));
    EXPECT_TRUE(harness.panels.has("entry Sieben Kugeln äöü.toml"));
}

TEST_F(BrowserDialog, SavesInTheFormatThatIsChosen) {
    open(true);
    EXPECT_TRUE(harness.panels.has("entry Sieben Kugeln äöü.toml")) << "files of all formats are shown";
    harness.type_over("browser name", "new.txt");
    harness.click("browser kind");
    harness.click("browser kind TOML (.toml)");
    EXPECT_EQ(browser().name, "new.toml") << "the name follows the format";
    harness.type_over("browser name", "other.txt");
    EXPECT_EQ(browser().kind, 0U) << "the format follows the name";
    harness.click("browser kind");
    harness.click("browser kind TOML (.toml)");
    harness.enter_over("browser name", "plain");
    EXPECT_EQ(accepted, Accepted{folder.path("plain.toml")});
}

TEST_F(BrowserDialog, TheBoxWithTheFaultKeepsTheKeyboard) {
    const auto type_wrong = [&](const std::string& widget, const std::string& text) {
        harness.type_over(widget, text);
        harness.panels.tap(ImGuiKey_Enter);  // takes the keyboard from the box
        harness.enter();
        EXPECT_NE(browser().error, "");
    };
    open();
    type_wrong("browser name", "missing.txt");
    harness.panels.type("four.txt");
    EXPECT_EQ(browser().name, "four.txt");
    EXPECT_EQ(browser().error, "");
    type_wrong("browser path", folder.path("missing"));
    harness.panels.type("/x");
    EXPECT_EQ(browser().typed_folder, folder.path("missing/x"));
}

TEST_F(BrowserDialog, DrawsOnlyWhatIsSeenOfManyFiles) {
    for (int i = 0; i < 3000; ++i) folder.write("many/" + std::to_string(10000 + i) + ".txt", "");
    folder.write("many/##\n%s.txt", "");
    open();
    harness.double_click("entry many");
    EXPECT_EQ(browser().entries.size(), 3002U);
    EXPECT_LT(harness.panels.rectangles.size(), 100U);
    harness.panels.double_click("entry ##\n%s.txt");
    EXPECT_EQ(accepted, Accepted{folder.path("many/##\n%s.txt")});
}

}  // namespace

}  // namespace sphereview
