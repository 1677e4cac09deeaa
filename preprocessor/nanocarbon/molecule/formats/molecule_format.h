// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace nanocarbon::molecule {

//! The formats that molecules are read from.
enum class MoleculeFormat { lammps_data, lammps_dump, lammps_yaml, xyz, cif, poscar };

std::string_view name(MoleculeFormat format);

//! \brief The format of a file, by what it holds; by its name only where that does not tell.
//! \param head the first part of what it holds, unpacked: 64 KiB or all of it
//! \param file its path or name, with or without .gz, for messages and as the last hint
//! \throw UserError (malformed) where it is of a known kind that is not read here (binary, PDB, a mesh, UTF-16,
//! other compression, ...), naming the kind, or of none
MoleculeFormat recognise_molecule(std::string_view head, const std::string& file);

}  // namespace nanocarbon::molecule
