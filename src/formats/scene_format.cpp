#include "formats/scene_format.hpp"

#include <algorithm>
#include <iterator>

#include "base/error.hpp"
#include "base/gunzip.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "formats/foreign_file.hpp"
#include "formats/text_format.hpp"

namespace sphereview {

namespace {

// When names do not tell, the last is asked first: the lower ones look at more.
constexpr std::array<SceneFormat, 12> table = {{
    {.name = "text",
     .endings = {".txt"},
     .holds_only_spheres = true,
     .sniff = shows_text,
     .read = read_text,
     .write = write_text,
     .stream = stream_text},
    {.name = "TOML", .endings = {".toml"}, .sniff = shows_toml, .read = read_toml, .write = write_toml},
    {.name = "XYZ",
     .endings = {".xyz", ".extxyz"},
     .is_data = true,
     .has_frames = true,
     .sniff = shows_xyz,
     .read = read_xyz,
     .step_over = step_over_xyz},
    {.name = "CSV",
     .endings = {".csv", ".tsv", ".asc"},
     .is_data = true,
     .may_end_in_txt = true,
     .has_columns = true,
     .sniff = shows_csv,
     .read = read_csv},
    {.name = "PDB", .endings = {".pdb", ".ent"}, .is_data = true, .has_frames = true, .sniff = shows_pdb, .read = read_pdb},
    {.name = "mmCIF", .endings = {".cif", ".mmcif"}, .is_data = true, .has_frames = true, .sniff = shows_mmcif, .read = read_mmcif},
    {.name = "LAMMPS",
     .endings = {".lammpstrj", ".lammpsdump"},
     .is_data = true,
     .may_end_in_txt = true,
     .has_frames = true,
     .sniff = shows_lammps,
     .read = read_lammps,
     .step_over = step_over_lammps},
    {.name = "GROMACS",
     .endings = {".gro"},
     .is_data = true,
     .may_end_in_txt = true,
     .has_frames = true,
     .sniff = shows_gromacs,
     .read = read_gromacs,
     .step_over = step_over_gromacs},
    {.name = "POSCAR",
     .endings = {".vasp", "poscar", "contcar", "xdatcar"},
     .is_data = true,
     .may_end_in_txt = true,
     .has_frames = true,
     .sniff = shows_poscar,
     .read = read_poscar,
     .step_over = step_over_poscar,
     .has_heads = true},
    {.name = "SDF",
     .endings = {".sdf", ".sd", ".mol", ".mdl"},
     .is_data = true,
     .may_end_in_txt = true,
     .has_frames = true,
     .sniff = shows_sdf,
     .read = read_sdf,
     .step_over = step_over_sdf},
    {.name = "PQR",
     .endings = {".pqr"},
     .is_data = true,
     .may_end_in_txt = true,
     .has_frames = true,
     .sniff = shows_pqr,
     .read = read_pqr},
    {.name = "PLY",
     .endings = {".ply"},
     .is_data = true,
     .may_end_in_txt = true,
     .may_be_binary = true,
     .sniff = shows_ply,
     .read = read_ply},
}};

// Null for a name that none of the endings ends.
const SceneFormat* named_format(std::string_view path) {
    const std::string name = lower_case(without_gzip_ending(path));
    for (const SceneFormat& format : table) {
        const auto ends = [&](const std::string& ending) { return name.ends_with(ending); };
        if (std::ranges::any_of(endings_of(format), ends)) return &format;
    }
    return nullptr;
}

}  // namespace

constinit const SceneFormat SceneFormat::text = table[0];
constinit const SceneFormat SceneFormat::toml = table[1];

std::span<const SceneFormat> scene_formats() { return table; }

const SceneFormat* find_format(std::string_view name) {
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const SceneFormat& f) { return lower_case(f.name) == lower_case(name); });
    return found == table.end() ? nullptr : &*found;
}

std::vector<std::string> endings_of(const SceneFormat& format) {
    std::vector<std::string> endings(format.endings.begin(), format.endings.end());
    std::erase(endings, "");
    return endings;
}

std::vector<std::string> format_names(bool (*wanted)(const SceneFormat&)) {
    std::vector<std::string> names;
    for (const SceneFormat& format : table) {
        if (wanted == nullptr || wanted(format)) names.emplace_back(format.name);
    }
    return names;
}

std::vector<std::string> format_endings(bool (*wanted)(const SceneFormat&)) {
    std::vector<std::string> endings;
    for (const SceneFormat& format : table) {
        if (wanted == nullptr || wanted(format)) std::ranges::move(endings_of(format), std::back_inserter(endings));
    }
    return endings;
}

const SceneFormat& format_of_name(std::string_view path) {
    const SceneFormat* named = named_format(path);
    return named == nullptr ? table[0] : *named;
}

std::string name_fault(std::string_view path) {
    const SceneFormat& named = format_of_name(path);
    const bool packed = without_gzip_ending(path) != path;
    for (const std::string_view picture : {".png", ".jpg", ".jpeg", ".gif", ".bmp", ".tif", ".tiff", ".webp", ".ppm", ".pgm"}) {
        if (has_ending(path, picture))
            return "a picture's name, expected one that ends with " + listed(format_endings(is_written), "or");
    }
    if (is_written(named) && !packed) return "";
    return "a name for " + std::string(is_written(named) ? "gzip" : named.name) +
           ", which is only read; expected one that ends with " + listed(format_endings(is_written), "or");
}

const SceneFormat& detect_format(std::string_view content, std::string_view name) {
    constexpr std::size_t head = std::size_t{1} << 16;
    const SceneFormat* named = named_format(name);
    content = without_byte_order_mark(content).substr(0, head);
    const auto is_binary = std::ranges::find_if(table, [&](const SceneFormat& f) { return f.may_be_binary && f.sniff(content); });
    if (is_binary != table.end()) return *is_binary;
    const auto refuse = [&](std::string_view kind) {
        throw InputError(std::string(name) + ": found " + std::string(kind) + ", expected " + listed(format_names(), "or"));
    };
    const std::string_view kind_of_name = named == nullptr ? foreign_kind_of_name(name) : "";
    std::string_view kind = foreign_kind(content);
    // Zero bytes behind a text make it no binary data; those at the end of other files may be a part of them.
    if (const std::string_view text = without_end_marks(content); !text.empty()) {
        content = text;
        if (kind == binary_data) kind = foreign_kind(text);
    }
    if (!kind.empty()) {
        refuse(kind == binary_data && !kind_of_name.empty() ? kind_of_name : kind);
    }
    if (named != nullptr && named->is_data) return *named;
    for (auto format = table.rbegin(); format != table.rend(); ++format) {
        const bool may_be = named == nullptr || !format->is_data || (*named == SceneFormat::text && format->may_end_in_txt);
        if (may_be && format->sniff(content)) return *format;
    }
    if (named != nullptr) return *named;
    if (!kind_of_name.empty()) refuse(kind_of_name);
    const std::string ending = text_from(path_from(without_gzip_ending(name)).extension());
    if (const std::string meant = did_you_mean(ending, format_endings()); !meant.empty()) {
        throw InputError(std::string(name) + ": found the ending " + in_quotes(ending) +
                         " and nothing that shows a format, expected the ending of one" + meant);
    }
    return table[0];
}

Scene parse_scene(std::string_view content, const std::string& name) {
    return detect_format(content, name).read(content, name, {}).scene;
}

void require_frame(const std::string& name, std::int64_t frame, std::int64_t frames) {
    if (frame >= 0 && frame < frames) return;
    const std::string found =
        frames == 1 ? "1 frame, number 0" : std::to_string(frames) + " frames, 0 to " + std::to_string(frames - 1);
    throw InputError(name + ": found " + found + ", expected frame " + std::to_string(frame));
}

std::string lost_in(const Scene& scene, const SceneFormat& format) {
    if (!format.holds_only_spheres) return "";
    std::vector<std::string> lost;
    if (scene.background != Background{}) lost.emplace_back("the background");
    if (scene.camera != Camera{}) lost.emplace_back("the camera");
    if (scene.light != Light{}) lost.emplace_back("the light");
    if (!scene.views.empty()) lost.push_back("the views (" + std::to_string(scene.views.size()) + ")");
    if (!scene.properties.empty()) lost.push_back("the properties (" + std::to_string(scene.properties.size()) + ")");
    if (!scene.names.empty()) lost.push_back("the names (" + std::to_string(scene.names.size()) + ")");
    const auto hidden = std::count_if(scene.spheres.begin(), scene.spheres.end(), [](const Sphere& s) { return s.hidden; });
    if (hidden != 0) lost.push_back("the hidden spheres (" + std::to_string(hidden) + ")");
    return joined(lost, ", ");
}

}  // namespace sphereview
