// The records of PDB, and of formats that borrow them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "formats/sphere_data.hpp"

namespace sphereview {

inline bool is_pdb_atom(std::string_view line) { return line.starts_with("ATOM") || line.starts_with("HETATM"); }

// Where the atoms of the wanted frame stand. Frames are models, or what END separates, as some programs do.
struct PdbFrame {
    std::int64_t frames = 0;  // in the file
    bool has_atoms = false;   // in any
    std::size_t begin = 0;    // of its records
    std::size_t end = 0;
    std::size_t count = 0;  // of its atoms
    std::size_t next = 0;   // where the frame behind it begins; 0: there is none
};

// By `part` it begins behind some frames, which count as looked at.
PdbFrame find_pdb_frame(std::string_view text, std::int64_t wanted, const PartOfFile& part);

}  // namespace sphereview
