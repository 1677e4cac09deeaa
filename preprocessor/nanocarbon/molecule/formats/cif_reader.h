// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "nanocarbon/molecule/formats/read_settings.h"

namespace nanocarbon::molecule {

//! \brief The structures of a CIF file, one for each block that has atoms, as unit cells with all of their atoms.
//! \details Parsed by gemmi. Symmetry: the listed operations, else the space group by its Hall or H-M name, else
//! none, with a warning. Elements: _atom_site_type_symbol, else _atom_site_label (species.h). Images of an atom
//! within 0.3 Angstrom of each other are one atom in a special position. IDs are 1, 2, ...
//! \throw UserError (malformed; unsuitable, also for partial occupancy and for unknown space groups)
std::vector<MoleculeFrame> read_cif(TextInput& input, ReadSettings& settings);

}  // namespace nanocarbon::molecule
