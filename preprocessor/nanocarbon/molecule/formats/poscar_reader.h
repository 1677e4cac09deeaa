// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/molecule/formats/read_settings.h"

namespace nanocarbon::molecule {

//! \brief The structure of a POSCAR or CONTCAR file of VASP (https://www.vasp.at/wiki/index.php/POSCAR), or the
//! frames of an XDATCAR, whose cell may change.
//! \details Scale or volume, three vectors, elements (VASP 5; without them --types says them in their order),
//! numbers of atoms, Selective dynamics, Direct or Cartesian. Velocities that follow are passed over.
//! \throw UserError (malformed; unsuitable)
std::vector<MoleculeFrame> read_poscar(TextInput& input, ReadSettings& settings);

}  // namespace nanocarbon::molecule
