// What the tests of files do again and again in the window.
#pragma once

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

void wait_for_no_dialogs(ViewerWindow& window);

// Waits for an announcement that holds the text, and returns all of it.
std::string announced(ViewerWindow& window, const std::string& part);

// A file of another name, renamed to `name`: as editors save.
void replace_by_rename(const TemporaryFolder& folder, const std::string& name, const std::string& bytes);

}  // namespace sphereview::test
