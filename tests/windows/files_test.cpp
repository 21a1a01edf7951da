// Files as only Windows has them.
#include <gtest/gtest.h>
#include <windows.h>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/path.hpp"
#include "base/user_folders.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview::test {
namespace {

TEST(OutputFile, IsWholeOrTheOldOneWhileAnotherProgramReadsIt) {
    const TemporaryFolder folder;
    const std::string path = folder.write("picture.png", "old");
    const HANDLE other = CreateFileW(path_from(path).c_str(), GENERIC_READ, FILE_SHARE_READ, nullptr, OPEN_EXISTING, 0, nullptr);
    ASSERT_NE(other, INVALID_HANDLE_VALUE);
    EXPECT_THROW(write_output(path, "new"), OutputError);
    CloseHandle(other);
    EXPECT_EQ(folder.read("picture.png"), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"picture.png"});
    write_output(path, "new");
    EXPECT_EQ(folder.read("picture.png"), "new");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"picture.png"});
}

TEST(OutputFile, TakesNamesBeyondAscii) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/größe→球.txt";
    write_output(path, "text");
    EXPECT_EQ(InputFile(path).bytes(), "text");
    EXPECT_EQ(text_from(path_from(path)), path);
    EXPECT_EQ(file_identity(path, FileUse::output), file_identity(folder.path(".") + "/größe→球.txt", FileUse::input));
}

TEST(OutputFile, GoesToDevices) {
    EXPECT_EQ(file_identity("NUL", FileUse::output), "");
    check_output("NUL");
    write_output("NUL", "text");
}

TEST(Path, OfANameThatIsNoUtf16ComesBackUnchanged) {
    const std::filesystem::path name = std::wstring{L'a', wchar_t{0xD800}, L'b', wchar_t{0xDFFF}};
    EXPECT_EQ(text_from(name),
              "a\xED\xA0\x80"
              "b\xED\xBF\xBF");
    EXPECT_EQ(path_from(text_from(name)), name);
    EXPECT_EQ(path_from("\xFF"), std::filesystem::path(L"\uFFFD"));
}

TEST(InputFile, SaysWhatIsMissing) {
    const TemporaryFolder folder;
    EXPECT_THROW(InputFile(folder.path("missing.txt")), InputError);
    EXPECT_THROW(InputFile(folder.path()), InputError);
}

TEST(UserFolders, AreThoseOfWindows) {
    const std::vector<std::filesystem::path> found = drives();
    EXPECT_NE(std::find(found.begin(), found.end(), "C:\\"), found.end());
    const wchar_t* roaming = _wgetenv(L"APPDATA");
    const wchar_t* local = _wgetenv(L"LOCALAPPDATA");
    ASSERT_TRUE(roaming != nullptr && local != nullptr);
    EXPECT_TRUE(config_folder().is_absolute());
    EXPECT_EQ(config_folder(), std::filesystem::path(roaming) / "sphereview");
    EXPECT_EQ(state_folder(), std::filesystem::path(local) / "sphereview");
}

}  // namespace
}  // namespace sphereview::test
