#include "platform/font_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/environment.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

TEST(SystemFontFile, IsTrueType) {
    if (!std::filesystem::exists("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")) GTEST_SKIP() << "fonts-dejavu-core is missing";
    const std::string usual = system_font_file();
    if (usual.empty()) GTEST_SKIP() << "built without fontconfig";
    const std::string monospaced = system_font_file(FontFamily::monospaced);
    for (const std::string& path : {usual, monospaced}) {
        char bytes[4] = {};
        std::ifstream(path, std::ios::binary).read(bytes, sizeof bytes);
        const std::string signature(bytes, sizeof bytes);
        EXPECT_TRUE(signature == std::string("\0\1\0\0", 4) || signature == "true") << path;
    }
    EXPECT_NE(usual, monospaced);
}

TEST(SystemFontFile, IsEmptyWhereThereIsNoFont) {
    const test::TemporaryFolder folder;
    const std::string none = "<?xml version=\"1.0\"?><fontconfig><dir>" + folder.path() + "</dir><cachedir>" +
                             folder.path("cache") + "</cachedir></fontconfig>";
    const test::Variable file("FONTCONFIG_FILE", folder.write("fonts.conf", none));
    EXPECT_EQ(system_font_file(), "");
    EXPECT_EQ(system_font_file(FontFamily::monospaced), "");
}

}  // namespace sphereview
