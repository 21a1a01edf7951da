// Every file format is one row of a table: how it is known, read and written, and what help, file dialogs and messages say of it.
// A new one is a file with its functions, declared in sphere_data.hpp, and a row in scene_format.cpp.
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
    bool may_end_in_txt = false;                // also known by what it begins with where the name is one for text
    bool may_be_binary = false;                 // of bytes that no text holds, so that nothing else is asked first what they are
    bool has_frames = false;
    bool has_columns = false;         // a table, whose columns may be chosen
    bool holds_only_spheres = false;  // no background, camera, light, views, names or hidden spheres

    // Whether a text that begins with `head`, without a byte-order mark, is of this format; true only where that is clear.
    bool (*sniff)(std::string_view head) = nullptr;

    // Reads a whole file; `name` is how messages call it. Without has_frames the frame is not looked at. Throws InputError
    // "NAME:LINE:COLUMN: found ..., expected ...", also for a frame that the file has not, and MemoryError when the spheres cannot
    // fit.
    SphereData (*read)(std::string_view content, const std::string& name, const DataOptions& options) = nullptr;

    // The content of a file with the scene; reading it gives the same doubles, bit for bit. Null: the format is only read.
    std::string (*write)(const Scene& scene) = nullptr;

    // Reads a file without having it whole in memory; bytes_per_sphere: what a sphere will need, with what is made of it later;
    // progress: told how far it is, may be null. Null: the format has only `read`.
    Scene (*stream)(InputStream& stream, std::size_t bytes_per_sphere, Progress* progress) = nullptr;

    // How many bytes the frame takes that `text`, without a byte-order mark, begins with; 0 where none follows, and nothing where
    // more of the text is needed to tell, which may be cut off anywhere unless it has `ended`. `part`: where it stands, and what is
    // to be known for the frames behind it. What the frame's lines hold is not looked at. Throws InputError. Null: only the whole
    // file is read.
    std::optional<std::size_t> (*step_over)(std::string_view text, bool ended, const std::string& name, PartOfFile& part) = nullptr;

    // Frames may need the head of one before: PartOfFile::of_first says which, and PartOfFile::head is to be given.
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

// The endings of the format's file names: those that are not "".
std::vector<std::string> endings_of(const SceneFormat& format);

// The names, or the endings of file names, of the formats for which `wanted` holds; all for null.
std::vector<std::string> format_names(bool (*wanted)(const SceneFormat&) = nullptr);
std::vector<std::string> format_endings(bool (*wanted)(const SceneFormat&) = nullptr);

// The format by the ending of the name, in any letter case and also with .gz behind it; text for all other names.
const SceneFormat& format_of_name(std::string_view path);

// What such a name is, where no scene may be written under it: "a name for CSV, which is only read; expected one that ends with
// ...";
// "" where one may.
std::string name_fault(std::string_view path);

// The format of a file that begins with `content`. A name of data decides. Else the content does, as far as it is clear; where the
// name is one for text or TOML, only between these, and tables in text. At last the name. Throws InputError for what is known to be
// of no format here (foreign_file.hpp), and where nothing shows the format but an ending that is nearly one of a format's.
const SceneFormat& detect_format(std::string_view content, std::string_view name);

// Reads a scene of any format. Throws as SceneFormat::read.
Scene parse_scene(std::string_view content, const std::string& name);

inline std::string write_scene(const Scene& scene, const SceneFormat& format) { return format.write(scene); }

// What `format` cannot hold of the scene, for a warning ("the camera, 2 names"), or "" when nothing is lost.
std::string lost_in(const Scene& scene, const SceneFormat& format);

}  // namespace sphereview
