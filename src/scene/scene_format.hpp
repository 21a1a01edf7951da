// Reading and writing whole scene files, whatever their format.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.hpp"
#include "scene/text_format.hpp"

namespace sphereview {

enum class SceneFormat { text, toml };

// The format that the content shows behind its comments: a first word that is a number is the text format; a table's head, a
// `key =` or nothing but comments is TOML. Otherwise (empty, or neither) the name decides: .toml is TOML, all else is text.
// Throws InputError where the text format begins with a comment, which it cannot have.
SceneFormat detect_format(std::string_view content, std::string_view name);

// The format for writing to `path`, by its name: .toml is TOML, all else is text.
SceneFormat format_of_name(std::string_view path);

// Reads a scene of either format. `name` is how messages call it. Throws InputError "NAME:LINE:COLUMN: ...".
Scene parse_scene(std::string_view content, const std::string& name);

// The scene as a file's content. Reading it gives the same doubles, bit for bit.
std::string write_scene(const Scene& scene, SceneFormat format);

// What `format` cannot hold of the scene, for a warning ("the camera, 2 names"), or "" when nothing is lost.
std::string lost_in(const Scene& scene, SceneFormat format);

}  // namespace sphereview
