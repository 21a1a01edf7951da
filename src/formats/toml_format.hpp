// The native format, TOML: `background`, `[camera]`, `[[sphere]]`, or `spheres = """..."""` holding the text format. Beside that
// text may stand `hidden = [3, 5]` and `[names]` with `7 = "sun"`: the numbers of spheres, from 0.
#pragma once

#include <string>
#include <string_view>

#include "formats/sphere_data.hpp"

namespace sphereview {

// Above this many spheres write_toml uses the `spheres` text.
inline constexpr std::size_t most_sphere_tables = 1000;

// Reads a whole native scene. Unknown keys are errors. Throws InputError "NAME:LINE:COLUMN: ...".
Scene parse_toml(std::string_view content, const std::string& name);

// The functions of the table of formats.
bool shows_toml(std::string_view head);
SphereData read_toml(std::string_view content, const std::string& name, const DataOptions& options);

// The scene as TOML that parse_toml reads back as the same scene, bit for bit. Defaults are left out.
std::string write_toml(const Scene& scene);

}  // namespace sphereview
