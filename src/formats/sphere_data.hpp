// What reading a file asks and gives, and the functions behind each row of the table of formats (scene_format.hpp, which says what
// they throw). `shows_`: whether a file that begins with `head`, without a byte-order mark, is clearly of that format.
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

// Which field of a table a column that is drawn is, instead of what the header's names say.
struct ColumnChoice {
    std::string column;  // "x": one of csv_column_names
    std::string field;   // by the name in the header, or by the number from 1

    bool operator==(const ColumnChoice&) const = default;
};

// Where a text stands that is a part of its file and begins with a frame.
struct PartOfFile {
    TextPosition origin{};
    std::int64_t frames = 0;  // before it
    bool is_a_frame = false;  // and no more than one
    // What is to be known of frames before. XYZ: how many numbers stand behind the first one's number of atoms. LAMMPS: in which
    // units the dump is, from 1; 0 where it does not say. XDATCAR: which frame has the head of those behind it, from 1; 0: none
    // has.
    std::size_t of_first = 0;
    // XDATCAR: the text of that frame, as far as its head may be long.
    std::string_view head{};
    // Of a text that is whole, as PDB is read: where frame `frames` is looked for, and whether those behind the wanted one are not.
    std::size_t begin = 0;
    bool stops = false;
};

// A second or less is needed to go through a shorter text.
inline constexpr std::uint64_t usual_index_from = std::uint64_t{1} << 26;

struct DataOptions {
    std::int64_t frame = 0;                    // from 0
    std::optional<double> radius{};            // of spheres for which the file says none, instead of the usual one; > 0
    std::optional<double> radius_of_points{};  // of points, instead of one that is made of their distances; > 0
    bool virtual_sites = true;                 // whether to show what a file of atoms calls one and is none (elements.hpp)
    std::vector<ColumnChoice> columns{};       // of CSV
    PartOfFile part{};                         // of a format that steps over frames (scene_format.hpp): what the text is
    std::vector<std::string>
        properties{};             // names of those to keep in the scene, in any letter case; those that a file lacks are left out
    bool all_properties = false;  // keep every one
    std::size_t all_properties_up_to = 0;  // keep every one of at most so many spheres
    // Where the frames of a text of at least so many bytes stand is kept for later (frame_index.hpp); none: of no text.
    std::optional<std::uint64_t> index_from = usual_index_from;
};

struct SphereData {
    Scene scene{};                             // of data: spheres and names, with the default camera and background
    std::int64_t frames = 1;                   // in the file
    std::string fault{};                       // that ends them before the text does; among the warnings, too
    std::optional<std::int64_t> cut_frame{};   // others may be lost in or behind this one, though more follow
    std::optional<FrameTime> time{};           // of the frame, where the file says it
    std::size_t next_frame = 0;                // where PartOfFile::begin may be for the one behind it; 0: that is not known
    bool asks_for_radius = false;              // nothing says any: it is to be made of the points' distances, if these give one
    std::optional<double> radius_of_points{};  // that all got of them (point_radius.hpp)

    // What a person should know of a file that was read all the same, a line each, which begins with the file's name:
    // "NAME:LINE:COLUMN: found ..., expected ...; ...". Not yet made safe to print.
    std::vector<std::string> warnings{};
    // What helps where something is missing in the picture, likewise.
    std::vector<std::string> notes{};
    // What the file holds of each sphere, by the names that DataOptions::properties takes, whether asked for or not.
    std::vector<std::string> property_names{};
};

// Up to how many atoms each is named after its element. A name takes more memory and more time than its sphere, and nobody looks
// for one atom of a million by its name.
inline constexpr std::size_t most_named_atoms = 100'000;

// Throws InputError when a file of so many frames has not the one that is asked for.
void require_frame(const std::string& name, std::int64_t frame, std::int64_t frames);

// The native format, TOML: `background`, `[camera]`, `[light]`, `[[view]]`, `[[property]]`, `[[sphere]]`, or `spheres = """..."""`
// holding the text format. Beside that text may stand `hidden = [3, 5]` and `[names]` with `7 = "sun"`: the numbers of spheres,
// from 0. Unknown keys are errors. Properties are the scene's own, and always kept.
bool shows_toml(std::string_view head);
SphereData read_toml(std::string_view content, const std::string& name, const DataOptions& options);

// The scene as TOML that read_toml reads back as the same scene, bit for bit. Defaults are left out.
std::string write_toml(const Scene& scene);

// Above this many spheres write_toml uses the `spheres` text, and text for the values of properties.
inline constexpr std::size_t most_sphere_tables = 1000;

// A long string of a native scene.
struct NumberLiteral {
    std::size_t line = 1;   // where its quotes open
    std::string_view text;  // inside `spheres = """..."""`, without the line end that may stand first
};

struct NumberLiterals {
    std::vector<NumberLiteral> literals{};  // ascending
    std::string rest{};  // the whole document with these emptied; every place outside them has the same line and column
};

// Finds the strings `spheres` and `values` without a TOML parser, which copies them several times. Finds them where that is plain:
// before any other string of several lines, `spheres` above all tables, and nothing but numbers and white space inside. Nothing
// where there are none: the TOML parser then reads or refuses what there is.
std::optional<NumberLiterals> find_number_literals(std::string_view content);

// XYZ: for each frame the number of atoms, a line of comment, and lines `ELEMENT x y z ...`. Extended XYZ: the comment's
// `Properties=` says what the columns are. The other frames are only skipped: what their lines hold is not looked at.
bool shows_xyz(std::string_view head);
SphereData read_xyz(std::string_view content, const std::string& name, const DataOptions& options);
std::optional<std::size_t> step_over_xyz(std::string_view text, bool ended, const std::string& name, PartOfFile& part);

// CSV and other tables in text as programs write them (csv_table.hpp): x, y, z and perhaps radius, r, g, b, name, in any order.
bool shows_csv(std::string_view head);
SphereData read_csv(std::string_view content, const std::string& name, const DataOptions& options);

// "x=Position X,y=2,radius=size" as choices; nothing where it is none. A comma inside a name is its own where no column stands
// behind it.
std::optional<std::vector<ColumnChoice>> parse_column_choices(const std::string& text);
inline constexpr const char* column_choices_syntax =
    "COLUMN=NAME or COLUMN=NUMBER, with commas between, of x, y, z, radius, diameter, r, g, b, color, element and name";

// PDB: models are frames; of alternative places the fullest is kept.
bool shows_pdb(std::string_view head);
SphereData read_pdb(std::string_view content, const std::string& name, const DataOptions& options);

// CIF: mmCIF (PDBx), likewise, crystals in parts of a cell with their symmetry, and chemical components; the models of each data
// block follow on those before. Builds without gemmi say that they cannot read it.
bool shows_mmcif(std::string_view head);
SphereData read_mmcif(std::string_view content, const std::string& name, const DataOptions& options);

// Dumps of LAMMPS in text: places as x, xs, xu or xsu, in boxes of any form; radius or diameter, element or type, in the order of
// the ids.
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
// Whether one line of an atom may be PQR's, with blanks between its fields.
bool may_be_pqr_atom(std::string_view line);
SphereData read_pqr(std::string_view content, const std::string& name, const DataOptions& options);

// PLY: the points of the element `vertex`, in text or in bytes of either order; faces are passed over.
bool shows_ply(std::string_view head);
SphereData read_ply(std::string_view content, const std::string& name, const DataOptions& options);

}  // namespace sphereview
