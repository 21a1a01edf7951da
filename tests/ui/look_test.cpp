// Colours by a property of the file, chosen in the window: what is exported is what `render` makes by its options.
#include <gtest/gtest.h>

#include "ui/editing.hpp"

namespace sphereview::test {

TEST(Look, AsOnTheCommandLineInTheRangeOfWhatIsSeen) {
    const TemporaryFolder folder;
    folder.write("home/config/sphereview/viewer.json", R"({"axes": false, "samples": 1})");
    // The sphere behind the first one has the largest value.
    const std::string scene = folder.write("scene.csv", "x,y,z,radius,charge\n0,0,0,40,1\n0,0,-60,20,100\n70,0,0,20,3\n");
    ViewerWindow window(folder, {scene, "--size", "200x200", "--shade", "flat", "--color-by", "charge"});
    const auto colored_alike = [&](const std::string& file, const std::vector<std::string>& options) {
        std::vector<std::string> all = {"-s", "200x200", "--background", "#202430", "--color-by", "charge"};
        all.insert(all.end(), options.begin(), options.end());
        window.key("F12");
        announced(window, file + " (200 x 200");
        EXPECT_EQ(folder.read(file), render_bytes(folder, scene, all)) << file;
    };
    window.wait_until("the picture", [](const Json& f) { return f.at("exact") == true; });
    colored_alike("scene.png", {});
    window.step("the range of what is seen");
    window.click_widget("look");
    window.wait_until("the panel", [](const Json& f) { return f.at("widgets").contains("range of seen"); });
    window.click_widget("range of seen");
    window.wait_until("the edit", [](const Json& f) { return f.at("undo") == "Colour by 'charge'" && f.at("exact") == true; });
    colored_alike("scene-1.png", {"--range", "1:3"});
    window.step("with its legend");
    window.key("shift+a");
    colored_alike("scene-2.png", {"--range", "1:3", "--legend"});
}

}  // namespace sphereview::test
