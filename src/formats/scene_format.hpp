// The table of file formats: how each is recognised, read and written, and its words for help, file dialogs and messages. A new
// format is a file with its functions, declared in sphere_data.hpp, and a row in scene_format.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_file.hpp"
#include "base/progress.hpp"
#include "formats/sphere_data.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct SceneFormat {
    std::string_view name{};                    // for people: "text", "TOML", "XYZ"; no two differ by letter case alone
    std::array<std::string_view, 4> endings{};  // of file names, in lower case: ".xyz"; the usual one first
    bool is_data = false;                       // of another program: no camera of its own, and right-handed (data_axes)
    bool may_end_in_txt = false;                // recognised by its beginning also under a name for text
    bool may_be_binary = false;                 // asked first about files with bytes that no text holds
    bool has_frames = false;
    bool has_columns = false;         // a table, whose columns may be chosen
    bool holds_only_spheres = false;  // no background, camera, light, views, names or hidden spheres

    // Whether a text that begins with `head`, without a byte-order mark, is of this format; true only where that is clear.
    bool (*sniff)(std::string_view head) = nullptr;

    // Reads a whole file. `name`: the file's in messages. Without has_frames ignores the wanted frame. Throws InputError
    // "NAME:LINE:COLUMN: found ..., expected ...", also if the file lacks the frame, and MemoryError when the spheres cannot fit.
    SphereData (*read)(std::string_view content, const std::string& name, const DataOptions& options) = nullptr;

    // The content of a file with the scene, which reads back bit for bit. Null: the format is only read.
    std::string (*write)(const Scene& scene) = nullptr;

    // Reads a file of which only a part is in memory. bytes_per_sphere: a sphere's memory, including later uses. progress: may be
    // null. Null: the format has only `read`.
    Scene (*stream)(InputStream& stream, std::size_t bytes_per_sphere, Progress* progress) = nullptr;

    // The bytes of the frame at the beginning of `text`, which has no byte-order mark; 0 if no frame follows; nothing if more text
    // is needed. Unless it has `ended`, the text may be cut off anywhere. `part`: the frame's place, and data for the frames behind
    // it. The content of the frame's lines is not read. Throws InputError. Null: only the whole file is read.
    std::optional<std::size_t> (*step_over)(std::string_view text, bool ended, const std::string& name, PartOfFile& part) = nullptr;

    // Frames may need the head of an earlier one: PartOfFile::of_first says which, and PartOfFile::head must be given.
    bool has_heads = false;

    static const SceneFormat text;
    static const SceneFormat toml;

    bool operator==(const SceneFormat& other) const { return name == other.name; }
};

std::span<const SceneFormat> scene_formats();

// The format of that name, in any letter case; null if there is none.
const SceneFormat* find_format(std::string_view name);

inline bool is_data(const SceneFormat& format) { return format.is_data; }
inline bool is_written(const SceneFormat& format) { return format.write != nullptr; }
inline bool has_frames(const SceneFormat& format) { return format.has_frames; }
inline bool has_columns(const SceneFormat& format) { return format.has_columns; }

// The format's endings that are not "".
std::vector<std::string> endings_of(const SceneFormat& format);

// The names, or the endings of file names, of the formats for which `wanted` holds; all for null.
std::vector<std::string> format_names(bool (*wanted)(const SceneFormat&) = nullptr);
std::vector<std::string> format_endings(bool (*wanted)(const SceneFormat&) = nullptr);

// The format by the ending of the name, in any letter case and also with .gz behind it; text for all other names.
const SceneFormat& format_of_name(std::string_view path);

// Why no scene can be written under this name: "a name for CSV, which is only read; expected one that ends with ..."; "" if one
// can.
std::string name_fault(std::string_view path);

// The format of a file that begins with `content`. A name for data decides. Else the content does, if it is clear; for a name for
// text or TOML only among these and tables in text. Else the name. Throws InputError for known other formats (foreign_file.hpp),
// and if only a nearly right ending shows the format.
const SceneFormat& detect_format(std::string_view content, std::string_view name);

// Reads a scene of any format. Throws as SceneFormat::read.
Scene parse_scene(std::string_view content, const std::string& name);

inline std::string write_scene(const Scene& scene, const SceneFormat& format) { return format.write(scene); }

// The parts of the scene that `format` cannot hold, for a warning ("the camera, 2 names"); "" if nothing is lost.
std::string lost_in(const Scene& scene, const SceneFormat& format);

}  // namespace sphereview
