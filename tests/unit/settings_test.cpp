#include "viewer/settings.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "support/environment.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_match.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

struct Settings : testing::Test {
    test::TemporaryFolder folder;
    test::Variable config{"XDG_CONFIG_HOME", folder.path("config")};

    ViewerSettings loaded_from(const std::string& json) const {
        folder.write("config/sphereview/viewer.json", json);
        return load_settings();
    }
};

const ViewerSettings defaults;

}  // namespace

TEST_F(Settings, ComeBackAsTheyWereSaved) {
    ViewerSettings settings;
    settings.place = {-20, 30, 800, 600, true};
    settings.panel_width = 412.5;
    settings.inspector_width = 333.0;
    settings.text_scale = 1.25;
    settings.shading = Shading::id;
    settings.export_width = 1920;
    settings.export_height = 1080;
    settings.film_width = 640;
    settings.film_height = 480;
    settings.samples = 4;
    settings.trackball = true;
    settings.light_theme = true;
    settings.axes_shown = false;
    settings.scale_bar_shown = true;
    settings.legend_shown = false;
    settings.marks_exported = true;
    settings.recent = {"/a/K\xC3\xBCgeln \"x\".toml", "/b"};
    EXPECT_TRUE(save_settings(settings));
    EXPECT_EQ(load_settings(), settings);
    EXPECT_EQ(fs::status(folder.path("config/sphereview")).permissions(), fs::perms::owner_all);
    settings.place.x = settings.place.y = std::nullopt;
    EXPECT_TRUE(save_settings(settings));
    EXPECT_EQ(load_settings(), settings);
}

TEST_F(Settings, AreTheDefaultsWithoutAFile) {
    EXPECT_EQ(load_settings(), defaults);
    EXPECT_EQ(folder.names().size(), 0U);
    fs::create_directories(folder.path("config/sphereview/viewer.json"));
    EXPECT_EQ(load_settings(), defaults);
    EXPECT_FALSE(save_settings({}));
}

TEST_F(Settings, AreTheDefaultsForABrokenFile) {
    for (const char* broken : {"", "{", "null", "[1,2]", "\"text\"", "{\"panel_width\": 500", "\xFF\xFE"}) {
        EXPECT_EQ(loaded_from(broken), defaults) << broken;
    }
    for (const auto& [broken, fault] : std::vector<std::pair<std::string, std::string>>{
             {std::string(100'000, '['), "1:33: found values nested deeper than 32"},
             {"{\n\"a\": x}", "2:6: this is not JSON"},
             {"[]", "1:1: this is not a JSON object"},
         }) {
        folder.write("config/sphereview/viewer.json", broken);
        std::string said;
        EXPECT_EQ(load_settings(&said), defaults);
        EXPECT_EQ(said, folder.path("config/sphereview/viewer.json") + ":" + fault);
        EXPECT_TRUE(save_settings({}));
        EXPECT_LT(folder.read("config/sphereview/viewer.json").size(), 1000U) << "what nests so deep is not written again";
    }
}

TEST_F(Settings, AreTheDefaultsWhereAFieldIsWrong) {
    for (const char* wrong : {R"({"window": 3})",
                              R"({"window": {"x": "left", "y": 5}})",
                              R"({"window": {"x": 5}})",
                              R"({"window": {"width": 0, "height": -5, "maximized": 1}})",
                              R"({"window": {"width": 99999999999999999999}})",
                              R"({"window": {"width": 18446744073709551615}})",
                              R"({"window": {"width": 800.5}})",
                              R"({"panel_width": 1e9})",
                              R"({"panel_width": 219})",
                              R"({"panel_width": null, "text_scale": 0})",
                              R"({"text_scale": -1e308})",
                              R"({"export_width": 0})",
                              R"({"export_width": 65536})",
                              R"({"export_width": 65535, "export_height": 65535})",
                              R"({"film_width": 65535, "film_height": 65535})",
                              R"({"recent": "x"})",
                              R"({"samples": 2})",
                              R"({"samples": 64})",
                              R"({"samples": "4"})",
                              R"({"samples": 4.0})",
                              R"({"trackball": 1})",
                              R"({"recent": [1, null, "relative", ""]})"}) {
        EXPECT_EQ(loaded_from(wrong), defaults) << wrong;
    }
    const ViewerSettings settings = loaded_from(R"({"text_scale": "big", "panel_width": 500, "recent": ["/a", 5, "/b", "/a"]})");
    EXPECT_EQ(settings.text_scale, 1.0);
    EXPECT_EQ(settings.panel_width, 500.0) << "the others count";
    EXPECT_EQ(settings.recent, (std::vector<std::string>{"/a", "/b"}));
}

TEST_F(Settings, KeepWhatANewerVersionWrote) {
    ViewerSettings settings =
        loaded_from(R"({"theme": {"dark": true}, "window": {"x": 1, "y": 2, "screen": 3}, "panel_width": 500})");
    settings.panel_width = 600.0;
    EXPECT_TRUE(save_settings(settings));
    const std::string text = folder.read("config/sphereview/viewer.json");
    EXPECT_TRUE(test::contains(text, "\"dark\": true"));
    EXPECT_TRUE(test::contains(text, "\"screen\": 3"));
    EXPECT_EQ(load_settings().panel_width, 600.0);
}

TEST_F(Settings, AreNotSavedWhereThatIsImpossible) {
    folder.write("config", "a file, not a folder");
    EXPECT_FALSE(save_settings({}));
    EXPECT_EQ(folder.names().size(), 1U);
    const test::Variable none("XDG_CONFIG_HOME", {});
    const test::Variable home("HOME", {});
    EXPECT_FALSE(save_settings({}));
    EXPECT_EQ(load_settings(), defaults);
}

// The end of the window writes them.
TEST_F(Settings, DoNotWaitForAFifo) {
    fs::create_directories(folder.path("config/sphereview"));
    ASSERT_EQ(mkfifo(folder.path("config/sphereview/viewer.json").c_str(), 0600), 0);
    EXPECT_EQ(load_settings(), defaults);
    EXPECT_FALSE(save_settings({}));
    EXPECT_TRUE(fs::is_fifo(folder.path("config/sphereview/viewer.json")));
}

TEST_F(Settings, ForgetAPathThatNoFileCanHave) {
    std::string longest;
    while (longest.size() < 100'000) longest += "/x";
    const ViewerSettings settings = loaded_from("{\"recent\": [\"" + longest + "\", \"/a\"]}");
    EXPECT_EQ(settings.recent, std::vector<std::string>{"/a"});
    EXPECT_TRUE(save_settings(settings));
    EXPECT_LT(folder.read("config/sphereview/viewer.json").size(), 1000U) << "it would take its time again and again";
}

TEST_F(Settings, LeaveOutAPathThatIsNotUtf8) {
    ViewerSettings settings;
    settings.recent = {"/a", "/\xFF", "/b"};
    EXPECT_TRUE(save_settings(settings));
    EXPECT_EQ(load_settings().recent, (std::vector<std::string>{"/a", "/b"}));
}

TEST_F(Settings, RememberTheLatestFilesFirst) {
    ViewerSettings settings;
    for (int i = 0; i < 12; ++i) add_recent(settings, "/scene" + std::to_string(i));
    EXPECT_EQ(settings.recent.size(), most_recent);
    EXPECT_EQ(settings.recent.front(), "/scene11");
    EXPECT_EQ(settings.recent.back(), "/scene2");
    add_recent(settings, "/x/../scene5");
    EXPECT_EQ(settings.recent.front(), "/scene5");
    EXPECT_EQ(settings.recent.size(), most_recent);
    EXPECT_EQ(std::ranges::count(settings.recent, "/scene5"), 1);
    remove_recent(settings, "/scene5");
    remove_recent(settings, "/missing");
    EXPECT_EQ(settings.recent.size(), most_recent - 1);
    add_recent(settings, "relative");
    EXPECT_EQ(settings.recent.front(), (fs::current_path() / "relative").string());
}

}  // namespace sphereview
