// Short ways to render in a test's folder.
#pragma once

#include <string>
#include <vector>

#include "support/picture.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview::test {

// A red sphere straight ahead. In a 5x5 picture it covers the middle pixel alone.
inline constexpr const char* red_scene = "1\n255 0 0\n0 0 200\n20\n";

// The same in another colour, for a picture that differs in one pixel.
inline constexpr const char* blue_scene = "1\n0 0 250\n0 0 200\n20\n";

// One sphere whose radius is not allowed: an error at line 4, column 1.
inline constexpr const char* bad_scene = "1\n1 2 3\n0 0 200\n-5\n";

// A text scene of `count` spheres far away.
std::string many_spheres(int count);

// A scene whose picture takes minutes at endless_size: spheres around the eye that differ in the last bit of their radii, so
// that every pixel is decided exactly. Its blocks are short enough for a progress bar.
std::string endless_scene();
inline constexpr const char* endless_size = "1000x100000";

// `sphereview render` on the CPU with more arguments, run in `folder`.
Command cpu_render(const TemporaryFolder& folder, const std::vector<std::string>& arguments);
Outcome render(const TemporaryFolder& folder, const std::vector<std::string>& arguments);

// Renders the scene on the given backend, which must succeed, and decodes the picture.
Picture picture_of(const std::string& scene, const std::string& backend, const std::vector<std::string>& options = {});

}  // namespace sphereview::test
