// The options and the result of reading a file, and the functions of the table of formats (scene_format.hpp has their contracts).
// shows_FORMAT(): whether a file that begins with `head`, without a byte-order mark, is clearly of that format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "formats/frame_time.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// A field of a table chosen for a drawn column, instead of by the header's names.
struct ColumnChoice {
    std::string column;  // "x": one of csv_column_names
    std::string field;   // the name in the header, or the number from 1

    bool operator==(const ColumnChoice&) const = default;
};

// The place of a text that is a part of its file and begins with a frame.
struct PartOfFile {
    TextPosition origin{};
    std::int64_t frames = 0;  // before it
    bool is_a_frame = false;  // the text is a single frame
    // Data from earlier frames. XYZ: how many numbers follow the first frame's number of atoms. LAMMPS: the dump's units, from 1;
    // 0: unknown. XDATCAR: the frame, from 1, that has the head of those behind it; 0: none.
    std::size_t of_first = 0;
    // XDATCAR: the text of that frame, at least its head.
    std::string_view head{};
    // For a whole text, as with PDB: where to search for frame `frames`, and whether to stop behind the wanted one.
    std::size_t begin = 0;
    bool stops = false;
};

// Going through a shorter text takes at most a second.
inline constexpr std::uint64_t usual_index_from = std::uint64_t{1} << 26;

struct DataOptions {
    std::int64_t frame = 0;                    // from 0
    std::optional<double> radius{};            // for spheres without one in the file; > 0
    std::optional<double> radius_of_points{};  // of points, instead of one made of their distances; > 0
    bool virtual_sites = true;                 // shows sites that are no atoms (elements.hpp)
    std::vector<ColumnChoice> columns{};       // of CSV
    PartOfFile part{};                         // for formats that step over frames (scene_format.hpp)
    std::vector<std::string> properties{};     // to keep in the scene, in any letter case; missing ones are ignored
    bool all_properties = false;               // keep all
    std::size_t all_properties_up_to = 0;      // keep all, for at most so many spheres
    // Keeps an index of the frames of texts of at least so many bytes (frame_index.hpp); none: never.
    std::optional<std::uint64_t> index_from = usual_index_from;
};

struct SphereData {
    Scene scene{};                             // for data: spheres and names, with the default camera and background
    std::int64_t frames = 1;                   // in the file
    std::string fault{};                       // ends the frames before the text's end; among the warnings, too
    std::optional<std::int64_t> cut_frame{};   // frames may be lost in or behind this one, though more follow
    std::optional<FrameTime> time{};           // the frame's, if the file has it
    std::size_t next_frame = 0;                // PartOfFile::begin for the next frame; 0: unknown
    bool asks_for_radius = false;              // no radius is known: to be made of the points' distances
    std::optional<double> radius_of_points{};  // the radius made of the distances (point_radius.hpp)

    // Warnings about a file that was read all the same, a line each: "NAME:LINE:COLUMN: found ..., expected ...; ...". Not yet made
    // safe to print.
    std::vector<std::string> warnings{};
    // Hints for when something is missing in the picture, likewise.
    std::vector<std::string> notes{};
    // The names of all properties in the file, whether asked for or not.
    std::vector<std::string> property_names{};
};

// Up to so many atoms get names. A name takes more memory and time than its sphere, and nobody looks for one atom of a million by
// name.
inline constexpr std::size_t most_named_atoms = 100'000;

// Throws InputError if a file of `frames` frames lacks frame `frame`.
void require_frame(const std::string& name, std::int64_t frame, std::int64_t frames);

// The native format, TOML: `background`, `[camera]`, `[light]`, `[[view]]`, `[[property]]`, `[[sphere]]`, or `spheres = """..."""`
// with the text format; beside that text `hidden = [3, 5]` and `[names]` with `7 = "sun"`, where numbers of spheres are from 0.
// Unknown keys are errors. All properties are kept.
bool shows_toml(std::string_view head);
SphereData read_toml(std::string_view content, const std::string& name, const DataOptions& options);

// The scene as TOML, which read_toml reads back bit for bit. Leaves defaults out.
std::string write_toml(const Scene& scene);

// Above this many spheres write_toml uses the `spheres` text, and text for the values of properties.
inline constexpr std::size_t most_sphere_tables = 1000;

// A long string of a native scene.
struct NumberLiteral {
    std::size_t line = 1;   // of its opening quotes
    std::string_view text;  // inside `spheres = """..."""`, without a line end at the beginning
};

struct NumberLiterals {
    std::vector<NumberLiteral> literals{};  // ascending
    std::string rest{};                     // the document with these emptied, and all other places unchanged
};

// Finds the strings `spheres` and `values` without a TOML parser, which would copy them several times. Only in plain cases: before
// any other string of several lines, `spheres` above all tables, and only numbers and white space inside. Nothing if there are
// none: then the TOML parser reads or refuses the document.
std::optional<NumberLiterals> find_number_literals(std::string_view content);

// XYZ: for each frame the number of atoms, a line of comment, and lines `ELEMENT x y z ...`. Extended XYZ: the comment's
// `Properties=` names the columns. Other frames are skipped without reading their lines.
bool shows_xyz(std::string_view head);
SphereData read_xyz(std::string_view content, const std::string& name, const DataOptions& options);
std::optional<std::size_t> step_over_xyz(std::string_view text, bool ended, const std::string& name, PartOfFile& part);

// CSV and other tables in text as programs write them (csv_table.hpp): x, y, z and perhaps radius, r, g, b, name, in any order.
bool shows_csv(std::string_view head);
SphereData read_csv(std::string_view content, const std::string& name, const DataOptions& options);

// "x=Position X,y=2,radius=size" as choices; nothing for a wrong text. A comma belongs to the name if no column follows it.
std::optional<std::vector<ColumnChoice>> parse_column_choices(const std::string& text);
inline constexpr const char* column_choices_syntax =
    "COLUMN=NAME or COLUMN=NUMBER, with commas between, of x, y, z, radius, diameter, r, g, b, color, element and name";

// PDB: models are frames; keeps the fullest of alternative places.
bool shows_pdb(std::string_view head);
SphereData read_pdb(std::string_view content, const std::string& name, const DataOptions& options);

// CIF: mmCIF (PDBx), likewise, crystals in parts of a cell with their symmetry, and chemical components. The models of all data
// blocks follow each other. Builds without gemmi say that they cannot read it.
bool shows_mmcif(std::string_view head);
SphereData read_mmcif(std::string_view content, const std::string& name, const DataOptions& options);

// LAMMPS's text dumps: places as x, xs, xu or xsu, in boxes of any form; radius or diameter, element or type, in the order of the
// ids.
bool shows_lammps(std::string_view head);
SphereData read_lammps(std::string_view content, const std::string& name, const DataOptions& options);
std::optional<std::size_t> step_over_lammps(std::string_view text, bool ended, const std::string& name, PartOfFile& part);

// GROMACS's .gro: nanometres, which become angstrom, in columns whose width the decimals show.
bool shows_gromacs(std::string_view head);
SphereData read_gromacs(std::string_view content, const std::string& name, const DataOptions& options);
std::optional<std::size_t> step_over_gromacs(std::string_view text, bool ended, const std::string& name, PartOfFile& part);

// VASP's POSCAR and CONTCAR, in parts of a cell or not, and XDATCAR with its frames.
bool shows_poscar(std::string_view head);
SphereData read_poscar(std::string_view content, const std::string& name, const DataOptions& options);
std::optional<std::size_t> step_over_poscar(std::string_view text, bool ended, const std::string& name, PartOfFile& part);

// SDF and MOL, V2000 and V3000: molecules are frames.
bool shows_sdf(std::string_view head);
SphereData read_sdf(std::string_view content, const std::string& name, const DataOptions& options);
std::optional<std::size_t> step_over_sdf(std::string_view text, bool ended, const std::string& name, PartOfFile& part);

// PQR: atoms of PDB with charges and radii; models are frames.
bool shows_pqr(std::string_view head);
// Whether an atom's line may be PQR's, with blanks between its fields.
bool may_be_pqr_atom(std::string_view line);
SphereData read_pqr(std::string_view content, const std::string& name, const DataOptions& options);

// PLY: the points of the element `vertex`, in text or in bytes of either order; faces are passed over.
bool shows_ply(std::string_view head);
SphereData read_ply(std::string_view content, const std::string& name, const DataOptions& options);

}  // namespace sphereview
