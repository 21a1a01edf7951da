// A window with two spheres, and what its picture must be after an edit.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "ui/file_steps.hpp"

namespace sphereview::test {

class Editing : public testing::Test {
protected:
    // The scene's file is `name`: what its format cannot hold cannot be saved either.
    explicit Editing(const std::string& name = "scene.txt");

    // Where the window shows the middle of the picture, and so of the red sphere; so many pixels beside it.
    Place red(double right = 0.0, double down = 0.0);
    void select_red();
    void select(int number);
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
