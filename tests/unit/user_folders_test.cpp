#include "base/user_folders.hpp"

#include <gtest/gtest.h>

#include "support/environment.hpp"
#include "support/temporary_folder.hpp"

#if !defined(_WIN32) && !defined(__APPLE__)

#include <sys/stat.h>

namespace sphereview {

namespace fs = std::filesystem;

namespace {

// A home of its own, and none of the variables.
struct UserFolders : testing::Test {
    test::TemporaryFolder home;
    test::Variable home_variable{"HOME", home.path()};
    test::Variable no_config{"XDG_CONFIG_HOME", {}};
    test::Variable no_state{"XDG_STATE_HOME", {}};

    std::string pictures_with(const std::string& dirs) const {
        home.write(".config/user-dirs.dirs", dirs);
        return pictures_folder().string();
    }
};

}  // namespace

TEST_F(UserFolders, AreInTheHomeFolder) {
    EXPECT_EQ(config_folder(), home.path(".config/sphereview"));
    EXPECT_EQ(state_folder(), home.path(".local/state/sphereview"));
    EXPECT_EQ(home.names().size(), 0U) << "asking makes nothing";
}

TEST_F(UserFolders, AreWhereTheVariablesSay) {
    const test::Variable config("XDG_CONFIG_HOME", "/far/settings");
    const test::Variable state("XDG_STATE_HOME", "/far/state");
    EXPECT_EQ(config_folder(), "/far/settings/sphereview");
    EXPECT_EQ(state_folder(), "/far/state/sphereview");
}

TEST_F(UserFolders, IgnoreVariablesThatAreNotAbsolute) {
    for (const char* value : {"", "settings", "./settings", "~/settings"}) {
        const test::Variable config("XDG_CONFIG_HOME", value);
        const test::Variable state("XDG_STATE_HOME", value);
        EXPECT_EQ(config_folder(), home.path(".config/sphereview")) << value;
        EXPECT_EQ(state_folder(), home.path(".local/state/sphereview")) << value;
    }
}

TEST_F(UserFolders, AreEmptyWithoutAHome) {
    for (const auto& none : {std::optional<std::string>(), std::optional<std::string>("relative")}) {
        const test::Variable without("HOME", none);
        EXPECT_EQ(config_folder(), "");
        EXPECT_EQ(state_folder(), "");
        EXPECT_EQ(pictures_folder(), fs::temp_directory_path());
    }
}

TEST_F(UserFolders, PicturesAreWhereXdgUserDirsSays) {
    fs::create_directories(home.path("Bilder \"alt\""));
    fs::create_directories(home.path("Pictures"));
    fs::create_directories(home.path("far"));
    EXPECT_EQ(pictures_with("# XDG_PICTURES_DIR=\"$HOME/far\"\n"
                            "XDG_MUSIC_DIR=\"$HOME/far\"\n"
                            "XDG_PICTURES_DIR=\"$HOME/Bilder \\\"alt\\\"\"\n"),
              home.path("Bilder \"alt\""));
    EXPECT_EQ(pictures_with("  XDG_PICTURES_DIR=\"" + home.path("far") + "\"\n"), home.path("far"));
    const std::string usual = home.path("Pictures");
    EXPECT_EQ(pictures_with("XDG_PICTURES_DIR=\"far\"\n"), usual) << "relative: not allowed";
    EXPECT_EQ(pictures_with("XDG_PICTURES_DIR=\"$HOMEfar\"\n"), usual);
    EXPECT_EQ(pictures_with("XDG_PICTURES_DIR=\""), usual);
    EXPECT_EQ(pictures_with(""), usual);
}

TEST_F(UserFolders, PicturesAreAtHomeWhereTheirFolderIsMissing) {
    EXPECT_EQ(pictures_folder(), home.path());
    EXPECT_EQ(pictures_with("XDG_PICTURES_DIR=\"$HOME/missing\"\n"), home.path());
    EXPECT_EQ(fs::path(pictures_with("XDG_PICTURES_DIR=\"$HOME/\"\n")).parent_path(), home.path()) << "how it is turned off";
}

TEST_F(UserFolders, PicturesDoNotWaitForAFifo) {
    fs::create_directories(home.path("Pictures"));
    fs::create_directories(home.path(".config"));
    ASSERT_EQ(mkfifo(home.path(".config/user-dirs.dirs").c_str(), 0600), 0);
    EXPECT_EQ(pictures_folder(), home.path("Pictures"));
}

TEST_F(UserFolders, AreMadeForTheUserAlone) {
    const fs::path deep = home.path("a/b/c");
    EXPECT_TRUE(make_user_folder(deep));
    EXPECT_TRUE(make_user_folder(deep));
    EXPECT_EQ(fs::status(deep).permissions(), fs::perms::owner_all);
    EXPECT_EQ(fs::status(home.path("a")).permissions(), fs::perms::owner_all);
    home.write("file", "");
    EXPECT_FALSE(make_user_folder(home.path("file")));
    EXPECT_FALSE(make_user_folder(home.path("file/x")));
    EXPECT_FALSE(make_user_folder(""));
}

#ifdef __linux__
TEST(ShareFolder, IsFoundFromTheProgram) {
    const test::TemporaryFolder prefix;
    EXPECT_EQ(share_folder(prefix.path("bin/sphereview")), "");
    prefix.write("share/sphereview/scenes/a.txt", "0");
    EXPECT_EQ(share_folder(prefix.path("bin/sphereview")), prefix.path("share/sphereview"));
    EXPECT_EQ(program_file().filename(), "unit_tests");
    EXPECT_EQ(share_folder(), "") << "a build is not installed";
}
#endif

}  // namespace sphereview

#endif
