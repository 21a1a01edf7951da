// Reading and writing whole scene files, whatever their format.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "formats/text_format.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// The text and the native format are for scenes. The others are other programs' data: they are only read, by src/formats/, and
// have no camera.
enum class SceneFormat { text, toml, xyz, csv, pdb, mmcif };

constexpr bool is_data(SceneFormat format) { return format != SceneFormat::text && format != SceneFormat::toml; }

// How messages call it: "the text format", "TOML", "XYZ".
std::string_view words_for(SceneFormat format);

// The format by the ending of the name, in any letter case and also with .gz behind it: .toml is TOML, .xyz and .extxyz XYZ, .csv
// CSV, .pdb and .ent PDB, .cif and .mmcif mmCIF, all else is text.
SceneFormat format_of_name(std::string_view path);

// The format of a file. A name of data decides. Where a name ends with neither .txt nor .toml (standard input) the content may
// show data: by the third line of XYZ, the header of CSV, the first record of PDB or mmCIF. Else the content decides between text
// and TOML as far as it shows it behind its comments: a first word that is a number is the text format; a table's head, a `key =`
// or nothing but comments is TOML; and at last the name. Throws InputError where the text format begins with a comment, which it
// cannot have.
SceneFormat detect_format(std::string_view content, std::string_view name);

// Reads a scene in the text format or TOML. `name` is how messages call it. Throws InputError "NAME:LINE:COLUMN: ...".
Scene parse_scene(std::string_view content, const std::string& name);

// The scene as the content of a file of text or TOML. Reading it gives the same doubles, bit for bit.
std::string write_scene(const Scene& scene, SceneFormat format);

// What `format` cannot hold of the scene, for a warning ("the camera, 2 names"), or "" when nothing is lost.
std::string lost_in(const Scene& scene, SceneFormat format);

}  // namespace sphereview
