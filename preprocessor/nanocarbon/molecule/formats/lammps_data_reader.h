// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/formats/read_settings.h"

namespace nanocarbon::molecule {

//! \brief Reads a LAMMPS data file, as LAMMPS, ASE, OVITO, VMD, Moltemplate, msi2lmp and this library write them.
//! \details The style of the atoms: the options, the comment after Atoms, or the columns (atom_columns.h).
//! Elements: type_elements.h. Image flags unwrap positions. LAMMPS data files do not say which directions are
//! periodic: the comment "# boundary p p f" of our own files does, and without it all are, as by LAMMPS's
//! default; where none is, the molecule has no cell. Of bonds across boundaries the nearest image is taken.
//! Velocities, angles, coefficients and unknown sections are passed over.
//! \throw UserError (malformed, naming file and line; unsuitable; usage for options that do not fit)
MoleculeFrame read_lammps_data(TextInput& input, ReadSettings& settings);

}  // namespace nanocarbon::molecule
