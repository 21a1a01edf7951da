// Crystals of CIF: atoms in parts of a cell's edges, and the symmetry that repeats them. For sources that may include gemmi.
#pragma once

#include <gemmi/cifdoc.hpp>

#include "formats/lines.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

// The table of a crystal's atoms; not ok() if the block has none.
gemmi::cif::Table crystal_atoms(gemmi::cif::Block& block);

// The atoms of that table, and their images by symmetry within the cell, each place once. Keeps the fullest of alternatives
// (disorder groups). Throws as SceneFormat::read.
SphereData read_crystal(const TextSource& source, gemmi::cif::Table& atoms, const DataOptions& options);

}  // namespace sphereview
