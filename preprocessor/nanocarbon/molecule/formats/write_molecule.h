// SPDX-License-Identifier: GPL-2.0-or-later
// The way out for molecules to files, in the format of the file's name.
#pragma once

#include <filesystem>

#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::molecule {

//! \brief Writes a molecule as a LAMMPS data file (.data) or as extended XYZ (.xyz, .extxyz), whole or not at all.
//! \param options atom style and margin are for data files alone
//! \throw UserError (usage) for other extensions; (unwritable); (unsuitable) as write_lammps_data
void write_molecule(const std::filesystem::path& path, const Molecule& molecule,
                    const LammpsDataOptions& options = {});

}  // namespace nanocarbon::molecule
