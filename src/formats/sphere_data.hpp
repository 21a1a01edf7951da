// Files of atoms, particles and packings, as other programs write them, read as scenes. They have no camera of their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "formats/scene_format.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct DataOptions {
    std::int64_t frame = 0;          // from 0
    std::optional<double> radius{};  // of spheres for which the file says none, instead of the usual one; > 0

    bool operator==(const DataOptions&) const = default;
};

struct SphereData {
    Scene scene{};            // spheres and names; default camera and background
    std::int64_t frames = 1;  // in the file
};

// Up to how many atoms each is named after its element. A name takes more memory and more time than its sphere, and nobody looks
// for one atom of a million by its name.
inline constexpr std::size_t most_named_atoms = 100'000;

// The readers of each format. `name` is how messages call the file. All throw InputError "NAME:LINE:COLUMN: found ...,
// expected ...", also for a frame that the file has not, and MemoryError when the spheres cannot fit.

// Reads a file of one of the formats for data.
SphereData read_data(std::string_view content, const std::string& name, SceneFormat format, const DataOptions& options);

// Throws InputError when a file of so many frames has not the one that is asked for.
void require_frame(const std::string& name, std::int64_t frame, std::int64_t frames);

// XYZ: for each frame the number of atoms, a line of comment, and lines `ELEMENT x y z ...`. Extended XYZ: the comment's
// `Properties=` says what the columns are. The other frames are only skipped: what their lines hold is not looked at.
SphereData read_xyz(std::string_view content, const std::string& name, const DataOptions& options);

// CSV (RFC 4180; ';' or tabs do as well) with a header: x, y, z and perhaps radius, r, g, b, name, in any order.
SphereData read_csv(std::string_view content, const std::string& name, const DataOptions& options);

// PDB: models are frames; of alternative places the fullest is kept. Builds without gemmi say that they cannot read it.
SphereData read_pdb(std::string_view content, const std::string& name, const DataOptions& options);

// mmCIF (PDBx), likewise.
SphereData read_mmcif(std::string_view content, const std::string& name, const DataOptions& options);

}  // namespace sphereview
