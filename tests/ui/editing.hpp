// A window with two spheres, what its picture must be after an edit, and what tests of files do again and again.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "ui/viewer_window.hpp"

namespace sphereview::test {

// A large red sphere straight ahead; with a green one to the right of it.
inline constexpr const char* one_sphere = "1\n255 0 0\n0 0 300\n60\n";
inline constexpr const char* two_spheres = "2\n255 0 0\n0 0 300\n60\n0 255 0\n100 0 300\n30\n";

// Adds a sphere, which makes the scene one that is not saved.
void edit(ViewerWindow& window);

// Types a name, or a whole path, into the file browser that is open or about to open, and accepts it. Does not wait.
void choose_file(ViewerWindow& window, const std::string& name);

// Answers the question that is asked, or about to be.
void answer(ViewerWindow& window, const std::string& question, const std::string& answer);

// The file in which a window with this folder keeps unsaved changes, relative to the folder, and what it holds; "" when there are
// none.
std::string kept_file(const TemporaryFolder& folder);
std::string kept_changes(const TemporaryFolder& folder);

void wait_for_no_dialogs(ViewerWindow& window);

// Waits for an announcement, or an error, that holds the text, and returns all of it.
std::string announced(ViewerWindow& window, const std::string& part, const std::string& member = "announcement");

// Nothing is selected or hovered, and no message shown: the picture is the scene's alone.
const Json& take_marks_away(ViewerWindow& window);

// The file that `render` writes of a scene.
std::string render_bytes(const TemporaryFolder& folder, const std::string& scene, std::vector<std::string> options);

// The window shows what `render` writes of a scene's file in the window's size, with its shading and samples.
void expect_rendered(ViewerWindow& window, const TemporaryFolder& folder, const std::string& scene,
                     std::vector<std::string> options = {});

// A file of another name, renamed to `name`: as editors save.
void replace_by_rename(const TemporaryFolder& folder, const std::string& name, const std::string& bytes);

class Editing : public testing::Test {
protected:
    // The scene's file is `name`: what its format cannot hold cannot be saved either.
    explicit Editing(const std::string& name = "scene.txt", const ScreenOptions& screen = {});

    // Where the window shows the middle of the picture, and so of the red sphere; so many pixels beside it.
    Place red(double right = 0.0, double down = 0.0);
    void select_red();
    void select(int number);
    // Saves the scene, and expects that the window shows it as `render` does.
    void expect_rendered();

    TemporaryFolder folder_;
    std::string name_;
    std::string scene_;
    ViewerWindow window_;
};

}  // namespace sphereview::test
