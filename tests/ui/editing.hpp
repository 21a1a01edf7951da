// A window with two spheres, and what its picture must be after an edit.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "ui/viewer_window.hpp"

namespace sphereview::test {

// A large red sphere straight ahead, a green one to the right of it.
inline constexpr const char* two_spheres = "2\n255 0 0\n0 0 300\n60\n0 255 0\n100 0 300\n30\n";

class Editing : public testing::Test {
protected:
    // The scene's file is `name`: what its format cannot hold cannot be saved either.
    explicit Editing(const std::string& name = "scene.txt");

    // Where the window shows the middle of the picture, and so of the red sphere; so many pixels beside it.
    Place red(double right = 0.0, double down = 0.0);
    void select_red();
    // Nothing is selected or hovered, and no message shown: the picture is the scene's alone.
    const Json& take_marks_away();
    // Saves the scene, and expects that the window shows it as `render` does.
    void expect_rendered();
    void undo_all();

    TemporaryFolder folder_;
    std::string name_;
    std::string scene_;
    ViewerWindow window_;
};

}  // namespace sphereview::test
