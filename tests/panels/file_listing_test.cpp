#include "panels/file_listing.hpp"

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> names_of(const Listing& listing) {
    std::vector<std::string> names;
    for (const FileBrowser::Entry& entry : listing.entries) names.push_back(entry.name + (entry.is_folder ? "/" : ""));
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

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

}  // namespace sphereview
