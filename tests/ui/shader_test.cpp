// Shaders from a folder: a saved one is in the picture at once, a broken one leaves the last good one.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/folders.hpp"
#include "support/text_match.hpp"
#include "ui/editing.hpp"

namespace sphereview::test {

TEST(LiveShaders, AreInThePictureWhenSaved) {
    const TemporaryFolder folder;
    const std::string shaders = folder.path("shaders");
    std::filesystem::copy(source_file("shaders"), shaders, std::filesystem::copy_options::recursive);
    const std::string good = folder.read("shaders/shade.frag");
    const std::string scene = folder.write("scene.txt", two_spheres);
    ViewerWindow window(folder, {scene, "--shader-dir", shaders});
    window.key("m");
    window.move_to({5, 5});
    const auto shows = [&](const Picture& picture, bool same) {
        window.wait_until("the picture", [&](const Json& f) {
            return f.at("hovered").is_null() && static_cast<bool>(same_picture(window.picture(), picture)) == same;
        });
    };
    window.wait_until("no marks", [](const Json& f) { return f.at("hovered").is_null(); });
    // By those shaders, not the export: of its doubtful pixels it shows a guess.
    const Picture first = window.picture();
    EXPECT_EQ(window.frame().at("exact"), false);

    const std::size_t end = good.rfind('}');
    ASSERT_NE(end, std::string::npos);
    folder.write("shaders/shade.frag", good.substr(0, end) + "    color = vec4(0.25, 0.5, 0.75, 1.0);\n}\n");
    shows(first, false);
    EXPECT_EQ(window.frame().at("shader_error"), "");
    const Picture changed = window.picture();

    folder.write("shaders/shade.frag", "#version 330 core\nnonsense\n");
    window.wait_until("an error", [](const Json& f) { return contains(f.at("shader_error").get<std::string>(), "shade.frag:2"); });
    window.click_widget("close shader error");
    window.wait_for("shader_error", "");
    shows(changed, true);

    folder.write("shaders/shade.frag", good);
    shows(first, true);
    EXPECT_EQ(window.frame().at("shader_error"), "");
}

}  // namespace sphereview::test
