// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::molecule {

//! \brief Writes extended XYZ, as ASE and OVITO read it: species and positions, with Lattice and pbc.
//! \details A molecule without cell has no Lattice and pbc="F F F". Bonds, where there are any, are the
//! columns `bonded`: the atoms bonded to each, numbered from 1 in the order of the file, 0 where there are no
//! more (through a periodic boundary, too). Rings are not part of the format. Numbers are the shortest text
//! that reads back exactly.
//!
//! \param generator kept as the comment line's `generator` key when not empty (command and version)
void write_xyz(std::ostream& out, const Molecule& molecule, const std::string& generator = {});

//! The same, whole or not at all, to a file.
void write_xyz(const std::filesystem::path& path, const Molecule& molecule,
               const std::string& generator = {});

}  // namespace nanocarbon::molecule
