// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

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

//! \brief Reads all frames of an XYZ file, plain or extended.
//! \details Of the comment line: Lattice, Origin, pbc and Properties, whose species and pos columns are used.
//! A Lattice without pbc is periodic in all directions, as ASE has it; a frame without Lattice, or with
//! pbc="F F F", has no cell. Species are C and H, or their atomic numbers. Bonds and rings are left empty.
//! \throw UserError (unreadable; malformed, naming file and line; unsuitable for other elements)
std::vector<Molecule> read_xyz_frames(const std::filesystem::path& path);
//! \param name to appear in errors in place of a path
std::vector<Molecule> read_xyz_frames(std::istream& in, const std::string& name);

//! The first frame of a file. Errors as above.
Molecule read_xyz(const std::filesystem::path& path);

}  // namespace nanocarbon::molecule
