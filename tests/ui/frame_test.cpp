// Stepping through the frames of a file.
#include <gtest/gtest.h>

#include "ui/file_steps.hpp"

namespace sphereview::test {

TEST(Frames, AreSteppedThroughByKeysMenuAndSlider) {
    const TemporaryFolder folder;
    const std::string path = folder.write("atoms.xyz", "1\n\nO 0 0 300\n1\n\nN 0 0 300\n2\n\nN 0 0 300\nH 100 0 300\n");
    ViewerWindow window(folder, {path, "--radius", "60", "--frame", "1"});
    const auto middle = [&] {
        const Picture picture = window.picture();
        return picture.at(picture.width / 2, picture.height / 2);
    };
    const auto nitrogen = middle();
    EXPECT_EQ(window.frame().at("scene_frame"), Json({1, 3}));
    const Json camera = window.frame().at("camera");

    window.key("Page_Up");
    window.wait_for("scene_frame", {0, 3});
    EXPECT_NE(middle(), nitrogen);
    window.key("Page_Up");  // there is none before
    window.choose("View", "Next frame");
    window.wait_for("scene_frame", {1, 3});
    EXPECT_EQ(middle(), nitrogen);
    window.key("Page_Down");
    window.wait_for("scene_frame", {2, 3});
    EXPECT_EQ(window.frame().at("spheres"), 2);
    EXPECT_EQ(window.frame().at("camera"), camera);
    EXPECT_EQ(window.frame().at("changed"), false);

    window.click(window.widget("frame", 0.05));
    window.wait_for("scene_frame", {0, 3});

    edit(window);
    window.key("Page_Down");
    answer(window, "save-changes", "Don't save");
    window.wait_for("scene_frame", {1, 3});
    EXPECT_EQ(window.frame().at("spheres"), 1);
}

}  // namespace sphereview::test
