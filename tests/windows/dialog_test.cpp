// The file dialog with drives, network names and names as Windows has them.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/output_file.hpp"
#include "base/path.hpp"
#include "panels/file_listing.hpp"
#include "panels/harness.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview::test {
namespace {

namespace fs = std::filesystem;

TEST(TypedPath, KnowsDrivesAndNetworkNames) {
    const fs::path folder = "C:\\a\\b";
    for (const auto& [typed, path] : {std::pair{"D:\\c\\", "D:\\c"},
                                      {"D:\\", "D:\\"},
                                      {"c/d", "C:\\a\\b\\c\\d"},
                                      {"..", "C:\\a"},
                                      {"\\c", "C:\\c"},
                                      {"\\\\server\\share\\c", "\\\\server\\share\\c"},
                                      {"\\\\server\\share\\", "\\\\server\\share"},
                                      {"//server/share/c/../d", "\\\\server\\share\\d"}}) {
        EXPECT_EQ(text_from(typed_path(typed, folder)), path);
    }
    EXPECT_EQ(text_from(typed_path("d", path_from("\\\\server\\share\\c"))), "\\\\server\\share\\c\\d");
    EXPECT_EQ(text_from(typed_path("..", path_from("\\\\server\\share\\c"))), "\\\\server\\share");
}

TEST(FileDialog, GoesToDrivesAndTakesNamesBeyondAscii) {
    const TemporaryFolder folder;
    const std::string name = "größe→球.txt";
    fs::create_directory(path_from(folder.path("Ωmega")));
    write_output(folder.path("Ωmega") + "\\" + name, "0\n");
    std::vector<std::string> accepted;
    DialogHarness harness;
    FileBrowser browser;
    browser.title = "Open";
    browser.folder = folder.path();
    browser.accept = [&](const std::string& path, PictureSize) { accepted.push_back(path); };
    harness.put(browser);
    const auto shown = [&] { return harness.top<FileBrowser>().folder; };

    harness.click("drive C:\\");
    EXPECT_EQ(shown(), "C:\\");
    EXPECT_TRUE(harness.panels.has("entry windows"));
    harness.click("browser up");
    EXPECT_EQ(shown(), "C:\\");

    harness.enter_over("browser path", folder.path());
    harness.double_click("entry Ωmega");
    EXPECT_EQ(shown(), folder.path("Ωmega"));
    harness.double_click("entry " + name);
    EXPECT_EQ(accepted, std::vector<std::string>{folder.path("Ωmega") + "\\" + name});
}

}  // namespace
}  // namespace sphereview::test
